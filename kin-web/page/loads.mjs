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

/**
 * A section of loads to begin with: a force on the first point of the plane, and the masses of bodies as remarks. Null
 * if there is no such point.
 * @param {string[]} bodies the names of the bodies that move
 */
export function loadsToBegin({ outputs }, bodies) {
  const point = outputs.find(({ dimension }) => dimension === "Point");
  if (!point) {
    return null;
  }
  const masses = bodies.map((body) => `    // mass of ${body} = 1kg at (0, 0), inertia 0.001kgm2;`);
  return ["loads {", `    force ${point.name} = (0, -100N);`, "    // gravity = (0, -9.81m/s2);", ...masses, "}"].join(
    "\n",
  );
}
