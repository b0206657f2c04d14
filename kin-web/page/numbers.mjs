/** Dimensions in the text: the sliders of the moving page write their numbers back, and a drawing reads their unit. */

/**
 * The changes that give dimensions and inputs other values.
 * @param {{name: string, unit: string, size: number, from: number, to: number, text: string}[]} numbers those of a
 *   `.kin` file
 * @param {{name: string, value: number}[]} wanted values, with angles in radians and lengths in the unit of the file
 * @returns {{from: number, to: number, insert: string}[]}
 */
export function changesFor(numbers, wanted) {
  return numbers.flatMap(({ name, unit, size, from, to, text }) => {
    const value = wanted.find((one) => one.name === name)?.value;
    const shown = Number((value / size).toPrecision(6));
    // a number that the page only rounds stays as it was typed
    const stays = value === undefined || Number(Number.parseFloat(text).toPrecision(6)) === shown;
    return stays ? [] : [{ from, to, insert: `${shown}${unit}` }];
  });
}

/** The unit of the first length that a text gives, or empty. */
export const lengthUnitOf = (text) => /=\s*\(?-?[\d.]+(?:e-?\d+)?(mm|cm|m|in)\b/.exec(text)?.[1] ?? "";
