/** Velocity, acceleration and jerk of joints, for arrows, circles of curvature and instant centres. */
import { solveAt, valuesNear } from "./model.mjs";
import { DIFFERENCE, DIFFERENCE_OF_PIECE, ROUNDING } from "./tolerances.mjs";

/**
 * Central differences of seven nodes: the first, second and third derivative, whose errors go with the sixth, sixth
 * and fourth power.
 */
const WEIGHTS = [
  [-1 / 60, 3 / 20, -3 / 4, 0, 3 / 4, -3 / 20, 1 / 60],
  [1 / 90, -3 / 20, 3 / 2, -49 / 18, 3 / 2, -3 / 20, 1 / 90],
  [1 / 8, -1, 13 / 8, 0, -13 / 8, 1, -1 / 8],
];

/**
 * The velocity, acceleration and jerk of every joint at a row; null next to a limit. They are drawn, and never printed
 * as numbers.
 * @returns {number[][][] | null}
 */
export function ratesOfJoints({ model, design, assembly }, row) {
  // the series of the row's piece goes on beyond its ends, though from a short piece not far
  const { from, to } = model.drive.pieces[row.piece];
  const step = Math.min(model.width * DIFFERENCE, (to - from) * DIFFERENCE_OF_PIECE);
  const poses = [];
  for (let node = -3; node <= 3; node += 1) {
    const argument = model.coupled ? valuesNear(model, design, row.pose, node * step) : assembly.argument;
    const found =
      node === 0 ? { ok: true, pose: row.pose } : solveAt(model, design, row.x + node * step, argument, row.piece);
    if (!found.ok) {
      return null;
    }
    poses.push(found.pose.joints);
  }
  const time = step / design.speed;
  return row.pose.joints.map((joint, index) =>
    WEIGHTS.map((weights, order) =>
      joint.map(
        (_, axis) =>
          weights.reduce((sum, weight, node) => sum + weight * poses[node][index][axis], 0) / time ** (order + 1),
      ),
    ),
  );
}

/**
 * The circle of curvature of a plane path, or null where the path is straight or stands still.
 * @returns {{centre: number[], radius: number} | null}
 */
export function circleOfCurvature(point, [vx, vy], [ax, ay]) {
  const square = vx * vx + vy * vy;
  const bend = vx * ay - vy * ax;
  if (!(square > 0) || !(Math.abs(bend) > ROUNDING * Math.hypot(ax, ay) * Math.sqrt(square))) {
    return null;
  }
  const part = square / bend;
  return { centre: [point[0] - vy * part, point[1] + vx * part], radius: Math.abs(part) * Math.sqrt(square) };
}

/**
 * The instant centre of a plane body, from two of its joints and their velocities; null if it only shifts.
 * @returns {number[] | null}
 */
export function instantCentre(one, other, velocityOne, velocityOther) {
  const [dx, dy] = [other[0] - one[0], other[1] - one[1]];
  const square = dx * dx + dy * dy;
  // the velocity of one joint relative to the other is at right angles to their distance, times the angular velocity
  const angularVelocity =
    (dx * (velocityOther[1] - velocityOne[1]) - dy * (velocityOther[0] - velocityOne[0])) / square;
  if (!(square > 0) || !(Math.abs(angularVelocity) * Math.sqrt(square) > ROUNDING * Math.hypot(...velocityOne))) {
    return null;
  }
  return [one[0] - velocityOne[1] / angularVelocity, one[1] + velocityOne[0] / angularVelocity];
}
