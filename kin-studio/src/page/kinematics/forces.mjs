/** The forces of the report at a place of the range. They hold for its own dimensions, speed and assembly. */
import { isBroken, pieceAt } from "./drive.mjs";
import { lastIndex } from "./search.mjs";

/** A derivative of a force jumps where that of the drive of so many orders more does. */
export const ABOVE = 2;

/**
 * Each force with its components and their rates, each curve with its rate, and each load and the place of each contact
 * as they are sampled.
 * @typedef {{forces: (number[] | null)[], curves: (number[] | null)[], loads: number[][], contacts: number[][]}}
 *   ForcesNow
 */

/** What was found for rows. @type {WeakMap<object, ForcesNow>} */
const known = new WeakMap();

/** The forces at a row. @returns {ForcesNow} */
export function forcesAt(model, row) {
  const found = known.get(row) ?? between(model, row);
  known.set(row, found);
  return found;
}

/** The forces at a place, between the samples of a report. */
function between({ drive, report }, { x, piece }) {
  const { samples } = report.forces;
  const pieceOf = ({ input }) => pieceAt(drive, input);
  let low = lastIndex(samples, x, ({ input }) => input);
  // at a joint of laws a sample is that behind it
  if (low > 0 && piece < pieceOf(samples[low])) {
    low -= 1;
  }
  const before = samples[low];
  const behind = samples[low + 1] ?? before;
  const width = behind.input - before.input;
  const own = isBroken(drive, { piece: pieceOf(before) }, { piece: pieceOf(behind) }, ABOVE)
    ? [piece <= pieceOf(before) ? before : behind]
    : [before, behind];
  /** A value with its rate by time, from the samples on the same side of a jump. */
  const valueOf = (values) => {
    const [one, other] = values.map(([value, rate]) => [value, rate / report.speed]);
    if (other === undefined || !(width > 0)) {
      return [one[0] + one[1] * (x - own[0].input), one[1] * report.speed];
    }
    return hermite(one, other, (x - before.input) / width, width).map((value, order) =>
      order === 0 ? value : value * report.speed,
    );
  };
  const each = (kind, parts) =>
    before[kind].map((_, index) => {
      const values = own.map((sample) => sample[kind][index]);
      return values.some((value) => !value)
        ? null
        : parts.flatMap(([value, rate]) => valueOf(values.map((all) => [all[value], all[rate]])));
    });
  const forces = each("forces", [
    [0, 2],
    [1, 3],
  ]).map((force) => force && [force[0], force[2], force[1], force[3]]);
  const part = width > 0 && own.length > 1 ? (x - before.input) / width : 0;
  const [first, last] = [own[0], own[own.length - 1]];
  const along = (kind) =>
    (first[kind] ?? []).map((one, index) =>
      one.map((value, axis) => value + part * ((last[kind]?.[index]?.[axis] ?? value) - value)),
    );
  return { forces, curves: each("curves", [[0, 1]]), loads: along("loads"), contacts: along("contacts") };
}

/** Where the force of a joint acts: in the picture, or where two bodies touch. Nothing if it is not known. */
export function placeOfForce(model, row, index) {
  const { joints } = model.report.forces;
  const { joint } = joints[index];
  if (joint !== null) {
    return row.pose.joints[joint];
  }
  const contact = joints.slice(0, index).filter((own) => own.joint === null).length;
  return forcesAt(model, row).contacts[contact];
}

/** The cubic between two values with their rates, and its rate. */
function hermite([low, rise], [high, fall], part, width) {
  const change = high - low;
  const [two, three] = [3 * change - width * (2 * rise + fall), width * (rise + fall) - 2 * change];
  const value = low + part * (width * rise + part * (two + part * three));
  return [value, (width * rise + part * (2 * two + 3 * part * three)) / width];
}

/** The size of a force and its rate. */
export function sizeOf([x, y, xRate, yRate]) {
  const size = Math.hypot(x, y);
  return [size, size > 0 ? (x * xRate + y * yRate) / size : Math.hypot(xRate, yRate)];
}

/** A couple counts as large if forces of this part of the largest one make it at the ends of the mechanism. */
const ARM = 0.05;

/**
 * The largest force in a joint, unless few are far larger than the others, so that arrows can be seen; and a large
 * couple.
 */
export function scalesOfForces({ report: { forces } }, size) {
  const sizes = forces.samples.flatMap((sample) => sample.forces.filter(Boolean).map(([x, y]) => Math.hypot(x, y)));
  sizes.sort((one, other) => one - other);
  const force = sizes.length > 0 ? Math.min(sizes[sizes.length - 1], 20 * sizes[sizes.length >> 1]) : 0;
  const couples = forces.samples.flatMap(({ loads }) => loads.filter(({ length }) => length === 1).map(([one]) => one));
  const arm = ARM * force * size * forces.metres;
  return { force, couple: couples.reduce((most, couple) => Math.max(most, Math.abs(couple)), arm) };
}
