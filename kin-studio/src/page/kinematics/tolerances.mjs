/** The tolerances and counts of the page's kinematics. Values of the variable are in parts of the range. */

/** Between values that are the same but for rounding. */
export const SAME = 1e-9;
/** Of what is found by halving. */
export const HALVED = 1e-10;
/** Between a limit as the page finds it and the same limit in the report. */
export const LIMIT = 1e-5;
/** The part of a stretch beside a limit in which rates grow beyond bounds. */
export const BESIDE_LIMIT = 0.04;
/** The ratio to the rates elsewhere from which a rate at a limit counts as unbounded. */
export const UNBOUNDED = 100;

/** The parts of the range, and of each piece of the drive, at whose ends a sweep has rows. */
export const PARTS = 360;
export const PARTS_OF_PIECE = 8;
/** The part of its size by which a joint may move from row to row; rows are put between where it moves further. */
export const APART = 0.03;
/** The smallest step of a coupled mechanism, in parts of the usual one. */
export const SMALLEST_STEP = 2 ** -22;
/** Between its position and the one that its rates before lead to: radians, or parts of its size. */
export const ASTRAY = 1e-3;

/** The longest way of the mechanism in one step of the pointer. */
export const REACH_OF_POINTER = 0.22;
/** The distance to the pointer from which a dragged point counts as held by a limit, in pixels. */
export const HELD = 6;

/** The distance of the poses from which the rates of joints come, at most in parts of a piece of the drive. */
export const DIFFERENCE = 1 / 400;
export const DIFFERENCE_OF_PIECE = 1 / 16;

/** A length, angle or rate below this part of what is beside it is rounding. */
export const ROUNDING = 1e-9;
/** Between an angle or a length and that of a body which it describes. */
export const DESCRIBES = 1e-6;
/** The change of an angle that turns, in radians. */
export const TURNS = 1e-3;
/** A transmission angle below it is poor, in radians. */
export const POOR = (40 * Math.PI) / 180;

/** Whether two values are the same but for rounding. */
export function same(model, one, other) {
  return Math.abs(one - other) <= SAME * model.width;
}

/** Whether two values are one limit. */
export function sameLimit(model, one, other) {
  return Math.abs(one - other) <= LIMIT * model.width;
}
