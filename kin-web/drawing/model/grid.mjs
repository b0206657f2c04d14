/** The grid: as fine as the eye parts it, in steps of 1, 2 or 5 times a power of ten. */
import { ticks } from "../../../kin-studio/src/page/numbers.mjs";

/** The least distance of two lines, in pixels. */
const CLOSEST = 16;

/** The distance of two lines in the drawing's unit. */
export function gridStep(scale) {
  // twenty lines at least, of which the first two tell the step
  const [first, second] = ticks(CLOSEST / scale, (21 * CLOSEST) / scale, 20);
  return second - first;
}

/** A number without the noise of a division. */
function clean(value) {
  return Number(value.toPrecision(12)) || 0;
}

/** The nearest crossing of the grid. @returns {[number, number]} */
export function snap([x, y], step) {
  return [clean(Math.round(x / step) * step), clean(Math.round(y / step) * step)];
}

/** The nearest direction of a multiple of fifteen degrees. */
export function snapDirection(angle) {
  const part = Math.PI / 12;
  return Math.round(angle / part) * part || 0;
}
