/** The highest and lowest values of each quantity, and root mean squares: the report's exact ones, or the page's own. No value: no bound. */
import { innerRows, rowAt } from "./sweep.mjs";

/** A jump below this part of a derivative's size is rounding. */
const JUMP = 1e-9;

/**
 * @typedef {{quantity: string, order: number, highest: {value: number | null, at: number} | null, lowest: {value: number | null, at: number} | null, rms: number | null}} Peak
 */

/**
 * The report's peaks, one entry for each quantity and order.
 * @param {import("./model.mjs").Model} model
 * @returns {Peak[]}
 */
export function givenPeaks(model) {
  const { extremes = [], rms = [] } = model.report;
  const peaks = [];
  for (const { name, declared } of model.quantities) {
    for (let order = 0; order <= model.orders; order += 1) {
      const of = (list) => (list ?? []).filter((entry) => entry.quantity === declared && entry.order === order);
      const kind = (wanted) => of(extremes).find((entry) => entry.kind === wanted) ?? null;
      const [highest, lowest] = [kind("highest"), kind("lowest")];
      const mean = of(rms)[0]?.value ?? null;
      if (highest || lowest || mean !== null) {
        peaks.push({ quantity: name, order, highest, lowest, rms: mean });
      }
    }
  }
  return peaks;
}

/**
 * Peaks found among the poses of a sweep and narrowed down with the solver.
 * @param {import("./model.mjs").Model} model
 * @param {import("./model.mjs").Design} design
 * @param {import("./sweep.mjs").Sweep} sweep
 * @param {any} assembly
 * @returns {Peak[]}
 */
export function ownPeaks(model, design, sweep, assembly) {
  const rows = innerRows(sweep);
  const peaks = [];
  model.quantities.forEach(({ name }, index) => {
    for (let order = 0; order <= model.orders; order += 1) {
      const value = (row) => row.pose[name][order] + (order === 0 ? row.shifts[index] : 0);
      const best = (sign) => {
        let place = -1;
        rows.forEach((row, at) => {
          if (place < 0 || sign * value(row) > sign * value(rows[place])) {
            place = at;
          }
        });
        return place < 0 ? null : narrowed(model, design, sweep, assembly, rows, place, value, sign);
      };
      const [up, down] = impulsesOf(model, rows, name, order);
      const unbounded = (at) => (at === null ? null : { value: null, at });
      const rms = up === null && down === null ? meanOf(rows, value) : null;
      peaks.push({ quantity: name, order, highest: unbounded(up) ?? best(1), lowest: unbounded(down) ?? best(-1), rms });
    }
  });
  return peaks;
}

/**
 * The first joints of laws at which a derivative has no bound upwards and downwards, or null: one below it jumps there. As in kin's extremes,
 * the one above a jump has its direction, and those above that have both.
 */
function impulsesOf(model, rows, name, order) {
  const found = [null, null];
  for (const joint of model.drive.joints) {
    const [left, right] = [joint.piece - 1, joint.piece].map((piece) => rows.find((row) => row.x === joint.at && row.piece === piece)?.pose[name]);
    const jumping = left && right ? left.findIndex((value, below) => below >= joint.order && Math.abs(right[below] - value) > JUMP * Math.max(Math.abs(value), Math.abs(right[below]))) : -1;
    if (jumping >= 0 && jumping < order) {
      const rises = right[jumping] > left[jumping] === model.report.speed > 0;
      found[0] ??= rises || order > jumping + 1 ? joint.at : null;
      found[1] ??= !rises || order > jumping + 1 ? joint.at : null;
    }
  }
  return found;
}

function narrowed(model, design, sweep, assembly, rows, place, value, sign) {
  const row = rows[place];
  let best = { value: value(row), at: row.x };
  const [before, after] = [rows[place - 1], rows[place + 1]];
  if (!before || !after || sign * value(before) === sign * best.value) {
    return best;
  }
  let [low, high] = [before.x, after.x];
  const at = (x) => {
    const found = rowAt(model, design, sweep, assembly, x);
    return found === null ? -Infinity : sign * value(found);
  };
  for (let step = 0; step < 26; step += 1) {
    const third = (high - low) / 3;
    if (at(low + third) < at(high - third)) {
      low += third;
    } else {
      high -= third;
    }
  }
  const x = 0.5 * (low + high);
  if (at(x) >= sign * best.value) {
    best = { value: sign * at(x), at: x };
  }
  return best;
}

/** The root of the mean square over the input, by the trapezoidal rule. */
function meanOf(rows, value) {
  let [sum, width] = [0, 0];
  for (let index = 1; index < rows.length; index += 1) {
    const step = rows[index].x - rows[index - 1].x;
    if (step < 0.05 * (rows[rows.length - 1].x - rows[0].x)) {
      sum += 0.5 * step * (value(rows[index]) ** 2 + value(rows[index - 1]) ** 2);
      width += step;
    }
  }
  return width > 0 ? Math.sqrt(sum / width) : null;
}
