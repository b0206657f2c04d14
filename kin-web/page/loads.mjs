/** The section of loads in a text: one to begin with, and that of a text which a drawing writes anew. */

/** The part of a text between two positions in lines and characters. */
function textIn(text, { start, end }) {
  const lines = text.split("\n").slice(start.line, end.line + 1);
  lines[lines.length - 1] = lines.at(-1).slice(0, end.character);
  lines[0] = lines[0].slice(start.character);
  return lines.join("\n");
}

/** The text with a section behind it. */
export const withSection = (text, section) => `${text.trimEnd()}\n${section}\n`;

/**
 * The section of loads of a text, or null if it has none.
 * @param {object} outline what kin says of the text
 */
export function loadsOf(text, outline) {
  const section = outline.sections.find(({ name }) => name === "loads");
  return section ? textIn(text, section.range) : null;
}

/** A load on the first quantity that can have one: a point, an angle or a length. */
function firstLoad({ outputs, unknowns }) {
  const first = (quantities, dimension) => quantities.find((quantity) => quantity.dimension === dimension)?.name;
  const kinds = [
    ["force", first(outputs, "Point"), "(0, -100N)"],
    ["force", first(outputs, "Point3"), "(0, 0, -100N)"],
    ["torque", first(unknowns, "Angle"), "1Nm"],
    ["force", first(unknowns, "Length"), "100N"],
  ];
  const [kind, name, size] = kinds.find(([, name]) => name) ?? [];
  return kind ? `${kind} ${name} = ${size};` : null;
}

/** The text with a unit at its first length, if no length has one: without a unit, loads have no meaning. */
function withUnit(text, { length_unit, numbers, dimensions, inputs }) {
  const lengths = [...dimensions, ...inputs].filter(({ dimension }) => /^(Length|Point|Vector)/.test(dimension));
  const isLength = ({ name }) => lengths.some((length) => length.name === name.split(".")[0]);
  const first = numbers.find(isLength);
  if (length_unit !== "" || !first) {
    return text;
  }
  const before = textIn(text, { start: { line: 0, character: 0 }, end: first.range.end });
  return `${before}mm${text.slice(before.length)}`;
}

/**
 * A text with loads to begin with: a force or torque, and gravity and the masses of bodies as remarks. Null if nothing
 * can be loaded.
 * @param {object} outline what kin says of the text, which has no loads
 */
export function withFirstLoads(text, outline) {
  const load = firstLoad(outline);
  if (load === null) {
    return null;
  }
  const { bodies, space } = outline;
  const gravity = space ? "gravity = (0, 0, -9.81m/s2);" : "gravity = (0, -9.81m/s2);";
  const inertia = space
    ? "1kg at (0, 0, 0), inertia (0.001kgm2, 0.001kgm2, 0.001kgm2)"
    : "1kg at (0, 0), inertia 0.001kgm2";
  const remarks = [gravity, ...bodies.map((body) => `mass of ${body} = ${inertia};`)];
  const lines = [load, ...remarks.map((remark) => `// ${remark}`)].map((line) => `    ${line}`);
  return withSection(withUnit(text, outline), ["loads {", ...lines, "}"].join("\n"));
}
