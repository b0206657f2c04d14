/** The parts of a mechanism's picture: pins, driven bodies, and the unknown that is a body's angle. */
import { inputAt } from "./drive.mjs";
import { groundAxes } from "./axes.mjs";
import { alongSlide, innerRows, sizeOf } from "./sweep.mjs";
import { DESCRIBES, ROUNDING, TURNS } from "./tolerances.mjs";

/**
 * @typedef {{pins: boolean[], fixed: boolean[], colours: (number | null)[], drivers: (number | null)[],
 *   driven: boolean[], drivenSlides: boolean[], keeps: boolean[], floating: number, size: number,
 *   axes: (number[] | null)[]}} Anatomy
 */

/** @returns {Anatomy | null} null if it closes nowhere */
export function anatomyOf(sweep) {
  const { model } = sweep;
  const rows = innerRows(sweep);
  if (rows.length === 0) {
    return null;
  }
  const { outline } = model;
  const some = [0, 0.2, 0.37, 0.55, 0.71, 0.9, 1].map((part) => rows[Math.floor(part * (rows.length - 1))]);
  const fixed = some[0].pose.joints.map((_, joint) => outline.ground.includes(joint));
  const keeps = outline.slides.map((_, slide) => {
    const [first, ...others] = some.map(({ pose }) => pose.slides[slide]);
    return others.every((direction) => parallel(first, direction));
  });
  const follows = (body, value) => {
    const apart = some.map((row) => angleOf(model, row.pose, body) - value(row));
    return apart.every((angle) => Number.isFinite(angle) && Math.abs(Math.sin(0.5 * (angle - apart[0]))) < DESCRIBES);
  };
  const turns = (value) => some.some((row) => Math.abs(value(row) - value(some[0])) > TURNS);
  // the values of the inputs that move, of which no dimension changes anything
  const inputs = model.moving.map(({ index, dimension }) => ({
    index,
    dimension,
    value: (row) => inputAt(model.drive, index, row),
  }));
  const angles = inputs.filter(({ dimension }) => dimension === "angle");
  const lengths = inputs.filter(({ dimension }) => dimension === "length");
  const colours = outline.bodies.map((_, body) => {
    const owner = model.quantities.find(({ name, dimension, isInput }) => {
      const value = (row) => row.pose[name][0];
      const opposite = (row) => -value(row);
      return (
        dimension === "angle" &&
        !isInput &&
        !model.space &&
        turns(value) &&
        (follows(body, value) || follows(body, opposite))
      );
    });
    return owner ? owner.colour : null;
  });
  const drivers = outline.bodies.map(({ joints }, body) => {
    const turns = ({ value }) =>
      model.space ? joints.some((joint) => fixed[joint]) && turnsAlong(rows, joints, value) : follows(body, value);
    return angles.find(turns)?.index ?? null;
  });
  const drivenSlides = outline.slides.map((_, slide) => {
    return lengths.some(({ value }) => {
      const apart = some.map((row) => Math.abs(alongSlide(model, row.pose, slide)) - Math.abs(value(row)));
      return apart.every((shift) => Math.abs(shift - apart[0]) < DESCRIBES * (1 + Math.abs(apart[0])));
    });
  });
  const pins = some[0].pose.joints.map((_, joint) => {
    const turning = outline.bodies.filter(({ joints }, body) => {
      const glides = joints.length === 1 && outline.slides.some((slide, index) => slide.guide === body && keeps[index]);
      return joints.includes(joint) && !glides;
    }).length;
    return turning > 1 || (turning === 1 && (fixed[joint] || outline.slides.some((slide) => slide.joint === joint)));
  });
  const size = sizeOf(some[0].pose);
  const poses = some.map(({ pose }) => pose);
  const floating = outline.bodies.findIndex(({ joints }) => joints.length > 1 && !joints.some((joint) => fixed[joint]));
  return {
    pins,
    fixed,
    colours,
    drivers,
    driven: drivers.map((driver) => driver !== null),
    drivenSlides,
    keeps,
    floating,
    size,
    axes: model.space ? groundAxes(model, poses, size) : [],
  };
}

/** Whether a body of space turns as far as the input, at right angles to its axis. */
function turnsAlong(rows, [first, second], value) {
  const direction = ({ pose }) => pose.joints[second].map((value, axis) => value - pose.joints[first][axis]);
  const way = (row) => value(row) - value(rows[0]);
  const close = rows.filter((row) => Math.abs(way(row)) > 0 && Math.abs(way(row)) < 0.5);
  if (second === undefined || close.length === 0) {
    return false;
  }
  const one = direction(rows[0]);
  return close.every((row) => {
    const other = direction(row);
    const cosine =
      one.reduce((sum, value, axis) => sum + value * other[axis], 0) / (Math.hypot(...one) * Math.hypot(...other));
    return Math.abs(cosine - Math.cos(way(row))) < DESCRIBES;
  });
}

function parallel(one, other) {
  const product = one.reduce((sum, value, axis) => sum + value * other[axis], 0);
  const [long, wide] = [Math.hypot(...one), Math.hypot(...other)];
  return Math.abs(Math.abs(product) - long * wide) <= ROUNDING * long * wide;
}

/** The direction of a plane body: from its first joint to the second, or that of its slide. */
export function angleOf(model, pose, body) {
  const [first, second] = model.outline.bodies[body].joints;
  if (second !== undefined) {
    const [one, other] = [pose.joints[first], pose.joints[second]];
    return Math.atan2(other[1] - one[1], other[0] - one[0]);
  }
  const { slides } = model.outline;
  const carried = slides.findIndex(({ guide }) => guide === body);
  const slide = carried < 0 ? slides.findIndex(({ joint }) => joint === first) : carried;
  return slide < 0 ? NaN : Math.atan2(pose.slides[slide][1], pose.slides[slide][0]);
}

/**
 * A point that is followed: a joint, or a point of a body as parts of the way from its first joint to the second, along
 * and across.
 * @typedef {{name: string, joint: number} | {name: string, body: number, along: number, across: number}} Followed
 */

/** The coordinates of a followed point, or its rates if those of the joints are given. @returns {number[]} */
export function coordinatesOf(model, followed, joints) {
  if (followed.joint !== undefined) {
    return joints[followed.joint];
  }
  const [first, second] = model.outline.bodies[followed.body].joints.map((joint) => joints[joint]);
  const run = second.map((value, axis) => value - first[axis]);
  const across = model.space ? run.map(() => 0) : [-run[1], run[0]];
  return first.map((value, axis) => value + run[axis] * followed.along + across[axis] * followed.across);
}

/**
 * The point of a body under the pointer, to be followed.
 * @param {number[][]} flatJoints the joints in the picture's plane, y upwards
 */
export function followedAt(model, body, flatJoints, at) {
  const { joints } = model.outline.bodies[body];
  if (joints.length < 2) {
    return { name: "", joint: joints[0] };
  }
  const [first, second] = joints.map((joint) => flatJoints[joint]);
  const [dx, dy] = [second[0] - first[0], second[1] - first[1]];
  const [x, y] = [at[0] - first[0], at[1] - first[1]];
  const square = dx * dx + dy * dy || 1;
  return { name: "", body, along: (x * dx + y * dy) / square, across: model.space ? 0 : (dx * y - dy * x) / square };
}
