/** Extremes and root mean squares of each quantity: those of the report, or at other dimensions those of the page. */
import { highestAt } from "./search.mjs";
import { allRows, isUnbounded, rowAt, spanAt, valueAt } from "./sweep.mjs";
import { HALVED, ROUNDING } from "./tolerances.mjs";

/**
 * No value: no bound.
 * @typedef {{value: number | null, at: number}} Extreme
 * @typedef {{quantity: string, order: number, highest: Extreme | null, lowest: Extreme | null,
 *   rms: number | null}} Peak
 */

/** The report's peaks, one entry for each quantity and order. @returns {Peak[]} */
export function givenPeaks(model) {
  const { extremes, rms } = model.report;
  return ofEach(model, ({ name, declared }, _, order) => {
    const of = (list, kind) =>
      list.find((entry) => entry.quantity === declared && entry.order === order && entry.kind === kind) ?? null;
    return {
      quantity: name,
      order,
      highest: of(extremes, "highest"),
      lowest: of(extremes, "lowest"),
      rms: of(rms)?.value ?? null,
    };
  }).filter(({ highest, lowest, rms: mean }) => highest || lowest || mean !== null);
}

function ofEach(model, peakOf) {
  const orders = [...Array(model.orders + 1).keys()];
  return model.quantities.flatMap((quantity, index) => orders.map((order) => peakOf(quantity, index, order)));
}

/** Peaks found among the poses of a sweep and narrowed down with the solver. @returns {Peak[]} */
export function ownPeaks(sweep) {
  const rows = allRows(sweep);
  return ofEach(sweep.model, ({ name }, index, order) => {
    const value = (row) => valueAt(sweep.model, row, index, order);
    // the sign is that of the row beside the limit, where rounding is less
    const ends = sweep.spans.flatMap(({ rows: spanRows }) => [spanRows.slice(0, 2), spanRows.slice(-2).reverse()]);
    const poles = ends.filter(([end]) => isUnbounded(sweep, end, index, order));
    const pole = (sign) => poles.find(([end, beside]) => sign * value(beside ?? end) > 0)?.[0].x ?? null;
    const [impulseUp, impulseDown] = impulsesOf(sweep.model, rows, name, order);
    const [up, down] = [impulseUp ?? pole(1), impulseDown ?? pole(-1)];
    const peak = (unbounded, sign) =>
      unbounded === null ? highestOf(sweep, rows, value, sign) : { value: null, at: unbounded };
    const rms = up === null && down === null ? meanOf(sweep, value) : null;
    return { quantity: name, order, highest: peak(up, 1), lowest: peak(down, -1), rms };
  });
}

/**
 * The first joints of laws at which a derivative has no bound upwards and downwards, or null: one below it jumps there.
 * As in kin's extremes, the one above a jump has its direction, and those above that have both.
 */
function impulsesOf({ drive, report }, rows, name, order) {
  const found = [null, null];
  for (const joint of drive.joints) {
    const [left, right] = [-1, 0].map(
      (shift) => rows.find((row) => row.x === joint.at && row.piece === joint.piece + shift)?.pose[name],
    );
    const jumps = (_, below) =>
      Math.abs(right[below] - left[below]) > ROUNDING * Math.max(Math.abs(left[below]), Math.abs(right[below]));
    const jumping = left && right ? left.findIndex((value, below) => below >= joint.order && jumps(value, below)) : -1;
    if (jumping >= 0 && jumping < order) {
      const rises = right[jumping] > left[jumping] === report.speed > 0;
      found[0] ??= rises || order > jumping + 1 ? joint.at : null;
      found[1] ??= !rises || order > jumping + 1 ? joint.at : null;
    }
  }
  return found;
}

/** The highest value, or for the sign -1 the lowest. @returns {Extreme | null} */
function highestOf(sweep, rows, value, sign) {
  const signed = (row) => (row === null ? -Infinity : sign * value(row));
  const higher = (one, other) => (signed(other) > signed(one) ? other : one);
  if (rows.length === 0) {
    return null;
  }
  const best = rows.reduce(higher);
  const index = rows.indexOf(best);
  // the ends of a full revolution are one position
  const isEnd = sweep.full && (index === 0 || index === rows.length - 1);
  const found = (isEnd ? [0, rows.length - 1] : [index]).map((top) => {
    const span = spanAt(sweep, rows[top].x);
    const [low, high] = [rows[top - 1], rows[top + 1]].map((row) =>
      row && spanAt(sweep, row.x) === span ? row : rows[top],
    );
    const isFlat = signed(low) === signed(best) && signed(high) === signed(best);
    const at = (x) => signed(rowAt(sweep, x));
    return isFlat ? best : rowAt(sweep, highestAt(at, low.x, high.x, HALVED * sweep.model.width));
  });
  const highest = [best, ...found].reduce(higher);
  return { value: value(highest), at: highest.x };
}

/** The root of the mean square over what closes, by the trapezoidal rule. */
function meanOf({ spans }, value) {
  let [sum, width] = [0, 0];
  for (const { from, to, rows } of spans) {
    width += to - from;
    for (let index = 1; index < rows.length; index += 1) {
      const [one, other] = [rows[index - 1], rows[index]];
      sum += 0.5 * (other.x - one.x) * (value(one) ** 2 + value(other) ** 2);
    }
  }
  return width > 0 ? Math.sqrt(sum / width) : null;
}
