/** The axes about which bodies of space turn on the ground. */
import { ROUNDING } from "./tolerances.mjs";

const minus = (one, other) => one.map((value, axis) => value - other[axis]);
const dot = (one, other) => one.reduce((sum, value, axis) => sum + value * other[axis], 0);
const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];

/** A vector of length 1; null for one that is zero beside a size. */
export function unitVector(vector, size) {
  const length = Math.hypot(...vector);
  return length > Math.sqrt(ROUNDING) * size ? vector.map((value) => value / length) : null;
}

/** Two directions at right angles to a direction and to each other. */
export function acrossOf(direction) {
  const least = direction.reduce((best, value, axis) => (Math.abs(value) < Math.abs(direction[best]) ? axis : best), 0);
  const one = unitVector(
    cross(
      direction,
      [0, 1, 2].map((axis) => (axis === least ? 1 : 0)),
    ),
    1,
  );
  return [one, cross(direction, one)];
}

/**
 * For each joint the direction of the axis about which a body turns there on the ground; null if there is no such body,
 * or if the body turns about a point.
 * @param {any[]} poses some poses of the motion
 * @returns {(number[] | null)[]}
 */
export function groundAxes({ outline }, poses, size) {
  const axes = poses[0].joints.map(() => null);
  for (const { joints } of outline.bodies) {
    const fixed = joints.filter((joint) => outline.ground.includes(joint));
    const [moving] = joints.filter((joint) => !outline.ground.includes(joint));
    if (fixed.length > 1) {
      const [one, other] = fixed.map((joint) => poses[0].joints[joint]);
      fixed.forEach((joint) => (axes[joint] ??= unitVector(minus(other, one), size)));
    } else if (fixed.length === 1 && moving !== undefined) {
      axes[fixed[0]] ??= normalOf(
        poses.map((pose) => pose.joints[moving]),
        size,
      );
    }
  }
  return axes;
}

/** The normal of the plane in which a point moves, or null. */
function normalOf([first, ...others], size) {
  const ways = others.map((point) => minus(point, first));
  const far = ways.reduce((best, way) => (Math.hypot(...way) > Math.hypot(...best) ? way : best), [0, 0, 0]);
  const normals = ways.map((way) => cross(far, way));
  const widest = normals.reduce((best, one) => (Math.hypot(...one) > Math.hypot(...best) ? one : best), [0, 0, 0]);
  const normal = unitVector(widest, size * size);
  return normal && ways.every((way) => Math.abs(dot(way, normal)) <= ROUNDING * size) ? normal : null;
}
