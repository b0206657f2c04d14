/** The input at which a dragged place comes nearest to the pointer. */
import { rowAt, spanAt } from "./sweep.mjs";

/** How far from where it is the mechanism may go in one step of the pointer, in parts of the range. */
const WINDOW = 0.22;

/**
 * @param {import("./model.mjs").Model} model
 * @param {import("./model.mjs").Design} design
 * @param {import("./sweep.mjs").Sweep} sweep
 * @param {any} assembly
 * @param {number} x where it is
 * @param {(pose: any) => number[]} placed the dragged place of a pose, on the page
 * @param {number[]} pointer
 * @returns {{x: number, beyond: boolean}} beyond: it stops at an end of what closes
 */
export function nearestInput(model, design, sweep, assembly, x, placed, pointer) {
  const span = spanAt(sweep, x);
  if (span === null) {
    return { x, beyond: false };
  }
  const width = model.to - model.from;
  const turn = Math.abs(width - model.period) < 1e-9 ? model.period : 0;
  const apart = (one) => {
    const distance = Math.abs(one - x);
    return turn > 0 ? Math.min(distance, turn - distance) : distance;
  };
  const reached = turn > 0 ? sweep.spans.filter((one) => one === span || joined(model, span, one)) : [span];
  const off = (pose) => {
    const place = placed(pose);
    return Math.hypot(place[0] - pointer[0], place[1] - pointer[1]);
  };
  let best = { x, off: Infinity, rows: span.rows, index: 0 };
  for (const { rows } of reached) {
    rows.forEach((row, index) => {
      if (apart(row.x) <= WINDOW * width) {
        // of two poses that are as near, the one that asks for less motion
        const cost = off(row.pose) + (0.5 * apart(row.x)) / width;
        if (cost < best.off) {
          best = { x: row.x, off: cost, rows, index };
        }
      }
    });
  }
  const { rows, index } = best;
  let [low, high] = [rows[Math.max(0, index - 1)].x, rows[Math.min(rows.length - 1, index + 1)].x];
  const at = (place) => {
    const row = rowAt(model, design, sweep, assembly, place);
    return row === null ? Infinity : off(row.pose);
  };
  const ratio = 0.5 * (Math.sqrt(5) - 1);
  for (let step = 0; step < 22; step += 1) {
    const [one, other] = [high - ratio * (high - low), low + ratio * (high - low)];
    if (at(one) < at(other)) {
      high = other;
    } else {
      low = one;
    }
  }
  const found = 0.5 * (low + high);
  const edges = [rows[0].x, rows[rows.length - 1].x];
  const edge = edges.find((end) => Math.abs(end - found) < 1e-4 * width && at(end) <= at(found) + 1e-3);
  const open = turn > 0 && edge !== undefined && (Math.abs(edge - model.from) < 1e-9 || Math.abs(edge - model.to) < 1e-9);
  return { x: edge ?? found, beyond: edge !== undefined && !open && off(rowAt(model, design, sweep, assembly, edge).pose) > 6 };
}

/** Whether a turn leads from the end of one stretch to the beginning of another. */
function joined(model, one, other) {
  const begins = (span) => Math.abs(span.from - model.from) < 1e-9;
  const ends = (span) => Math.abs(span.to - model.to) < 1e-9;
  return (begins(one) && ends(other)) || (ends(one) && begins(other));
}
