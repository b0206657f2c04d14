/** The values at the cursor, above a plot: beside its title as long as they fit, otherwise in lines below it. */

/** The width of a letter beside the title and in the lines below it, in pixels, and of the dot with its gaps. */
const LETTER = 7.6;
const SMALL_LETTER = 6.8;
const DOT = 15;
/** The height of a line below the title. */
const LINE = 13;
/** The room of a title with its unit. */
const TITLE = 120;
/** The letters of a value. */
const VALUE = 8;
/** The part of a plot that values may take. */
const PART = 0.34;

/**
 * @typedef {object} Readouts
 * @property {boolean} named whether values stand behind their names
 * @property {number} columns the columns of the lines below the title, or 0 if all stand beside the title
 * @property {number} count so many are shown
 * @property {number} step the distance of the columns
 * @property {number} high the height of the lines below the title
 * @property {boolean} wide whether there is room for two values in the place of each
 */

/**
 * @param {boolean} brief whether values are left out that do not fit beside the title
 * @returns {Readouts}
 */
export function readoutsOf(names, width, plotHeight, brief = false) {
  const total = names.reduce((sum, name) => sum + LETTER * (name.length + 1 + VALUE) + DOT, 0);
  if (total < width - TITLE) {
    const wide = 2 * names.length * LETTER * 11 < width;
    return { named: true, columns: 0, count: names.length, step: 0, high: 0, wide };
  }
  if (brief) {
    return { named: false, columns: 0, count: 0, step: 0, high: 0, wide: false };
  }
  const longest = Math.max(0, ...names.map(({ length }) => length + 1));
  const most = Math.max(1, Math.floor((PART * plotHeight) / LINE));
  const inLines = (named) => {
    const cell = SMALL_LETTER * ((named ? longest : 0) + VALUE) + DOT;
    const columns = Math.max(1, Math.floor(width / cell));
    const lines = Math.ceil(names.length / columns);
    const count = Math.min(names.length, most * columns);
    return { named, columns, count, step: width / columns, high: LINE * Math.min(lines, most), wide: false };
  };
  const named = inLines(true);
  return named.count === names.length ? named : inLines(false);
}

/** The place of a value below the title: its column from the left, and its base line. */
export function placeOfReadout({ columns, step }, index) {
  return [(index % columns) * step, LINE * (Math.floor(index / columns) + 1)];
}
