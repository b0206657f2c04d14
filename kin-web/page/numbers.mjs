/** Dimensions in the text: the sliders of the moving page write their numbers back, and a drawing reads their unit. */

/**
 * The changes that give dimensions other values, as ranges of the text with what stands there then.
 * @param {string} text the text of a `.kin` file
 * @param {{name: string, dimension: string, value: number}[]} wanted dimensions by their declared names, with angles in
 *   radians and lengths in the unit of the file
 */
export function changesFor(text, wanted) {
  const section = /(^|\n)\s*(dimensions|motion)\s*\{/g;
  const changes = [];
  for (let match = section.exec(text); match; match = section.exec(text)) {
    const start = match.index + match[0].length;
    const end = text.indexOf("}", start);
    const body = text.slice(start, end < 0 ? undefined : end);
    for (const { name, dimension, value } of wanted) {
      const entry = new RegExp(`(^|[;\\s{])${name}\\s*=\\s*([^;.(]|\\.(?!\\.))+;`).exec(body);
      if (entry) {
        const equals = entry[0].indexOf("=");
        const old = entry[0].slice(equals + 1, -1);
        const from = start + entry.index + equals + 1;
        changes.push({ from, to: from + old.length, insert: ` ${written(old, dimension, value)}` });
      }
    }
  }
  return changes;
}

/** The value with the unit that the old value had. */
function written(old, dimension, value) {
  const unit = /[a-zA-Zµ°]+\s*$/.exec(old)?.[0].trim() ?? "";
  const size = dimension === "angle" && unit !== "rad" ? 180 / Math.PI : 1;
  return `${Number((value * size).toPrecision(6))}${unit}`;
}

/** The unit of the first length that a text gives, or empty. */
export const lengthUnitOf = (text) => /=\s*\(?-?[\d.]+(?:e-?\d+)?(mm|cm|m|in)\b/.exec(text)?.[1] ?? "";
