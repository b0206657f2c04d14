/** The ranges of axes that can be read: where few values are far larger than the rest, the axis ends before them. */
import { ROUNDING } from "./kinematics/tolerances.mjs";
import { raised } from "./numbers.mjs";

/** The part of the values at either end that may lie beyond an axis. */
const BEYOND = 0.05;
/** From so many times the spread of the other values on, these are a line: a fraction of a pixel. */
const FLAT = 200;
/** The same for values that are constant but for these few, in parts of the natural size. */
const FAR = 1e6;
/** The room beside what is seen, in parts of its spread. */
const ROOM = 0.08;

/**
 * The range of an axis, and the largest and the smallest value if they lie beyond it.
 * @typedef {{low: number, high: number, above: number | null, below: number | null}} Axis
 */

/**
 * The axis for some values.
 * @param {number} natural the size of values that change as slowly as the whole motion does
 * @returns {Axis}
 */
export function axisOf(values, natural) {
  const sorted = Float64Array.from(values.filter((value) => !Number.isNaN(value))).sort();
  if (sorted.length === 0) {
    return { low: -1, high: 1, above: null, below: null };
  }
  const [lowest, highest] = [sorted[0], sorted.at(-1)];
  const size = Math.max(Math.abs(lowest), Math.abs(highest));
  if (highest - lowest <= ROUNDING * Math.max(size, natural)) {
    // what does not change but for rounding is a straight line
    const room = 0.1 * Math.max(size, natural) || 1;
    return { low: lowest - room, high: highest + room, above: null, below: null };
  }
  const at = (part) => sorted[Math.round(part * (sorted.length - 1))];
  const [low, high] = [at(BEYOND), at(1 - BEYOND)];
  const changes = high - low > ROUNDING * natural;
  const isFar = changes ? highest - lowest > FLAT * (high - low) : highest - lowest > FAR * natural;
  const reach = !isFar ? Infinity : changes ? high - low : natural;
  const seen = [Math.max(lowest, low - 2 * reach), Math.min(highest, high + 2 * reach)];
  const room = ROOM * (seen[1] - seen[0]);
  return {
    low: seen[0] - room,
    high: seen[1] + room,
    above: highest > seen[1] ? highest : null,
    below: lowest < seen[0] ? lowest : null,
  };
}

/** The power of ten that the numbers of an axis share, so that they stay short: a multiple of three. */
export function sharedPower(numbers) {
  const size = numbers.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  return size >= 1e5 || (size > 0 && size < 1e-3) ? 3 * Math.floor(Math.log10(size) / 3) : 0;
}

/** A unit behind a power of ten. */
export function unitWithPower(unit, power) {
  return power === 0 ? unit : `10${raised(power)}${unit ? ` ${unit}` : ""}`;
}
