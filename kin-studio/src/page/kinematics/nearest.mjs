/** The input at which a dragged point comes nearest to the pointer. */
import { highestAt } from "./search.mjs";
import { rowAt, spanAt } from "./sweep.mjs";
import { HALVED, HELD, LIMIT, REACH_OF_POINTER, same } from "./tolerances.mjs";

/**
 * @param {number} x the value of the variable
 * @param {(pose: any) => number[]} placed the dragged point in a pose, on the page
 * @returns {{x: number, beyond: boolean}} beyond: the motion stops at a limit
 */
export function nearestInput(sweep, x, placed, pointer) {
  const { model } = sweep;
  const span = spanAt(sweep, x);
  if (span === null) {
    return { x, beyond: false };
  }
  const period = same(model, model.width, model.period) ? model.period : Infinity;
  const apart = (one) => Math.min(Math.abs(one - x), period - Math.abs(one - x)) / model.width;
  // a full revolution leads from the end of one stretch to the beginning of another
  const isLast = ({ to }) => period < Infinity && same(model, to, model.to);
  const isFirst = ({ from }) => period < Infinity && same(model, from, model.from);
  const isReached = (one) => one === span || (isFirst(span) && isLast(one)) || (isLast(span) && isFirst(one));
  const off = (row) =>
    row === null ? Infinity : Math.hypot(...placed(row.pose).map((value, axis) => value - pointer[axis]));
  const offAt = (at) => off(rowAt(sweep, at));
  let best = { cost: Infinity, rows: span.rows, index: 0 };
  for (const { rows } of sweep.spans.filter(isReached)) {
    rows.forEach((row, index) => {
      // of two poses that are as near, the pose that needs less motion
      const cost = apart(row.x) <= REACH_OF_POINTER ? off(row) + 0.5 * apart(row.x) : Infinity;
      if (cost < best.cost) {
        best = { cost, rows, index };
      }
    });
  }
  const { rows, index } = best;
  const [low, high] = [rows[Math.max(0, index - 1)].x, rows[Math.min(rows.length - 1, index + 1)].x];
  const found = highestAt((at) => -offAt(at), low, high, HALVED * model.width);
  // no further from the pointer than the row, and at an end if it is as near
  const ends = [rows[0].x, rows.at(-1).x].filter((end) => Math.abs(end - found) <= 10 * LIMIT * model.width);
  const nearest = [...ends, rows[index].x, found].reduce((one, other) => (offAt(other) < offAt(one) ? other : one));
  const isSeam = period < Infinity && (same(model, nearest, model.from) || same(model, nearest, model.to));
  return { x: nearest, beyond: ends.includes(nearest) && !isSeam && offAt(nearest) > HELD };
}
