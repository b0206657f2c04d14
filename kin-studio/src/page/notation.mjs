/** The notation of books on mechanisms, as data of paths: ground, blocks, arrows of drives, plates. */
import { line } from "./elements.mjs";

/** Half the length and half the width of a slider's block, in pixels. */
export const BLOCK = [13, 7.5];

export function unitOf(from, to) {
  const [x, y] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(x, y);
  return length > 1e-9 ? [x / length, y / length] : [1, 0];
}

/** Short lines on one side of a line. */
export function hatch(from, to, below) {
  const [x, y] = unitOf(from, to);
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const count = Math.max(1, Math.floor(length / 6));
  let data = "";
  for (let index = 0; index < count; index += 1) {
    const distance = (length * (index + 0.5)) / count;
    const start = [from[0] + x * distance, from[1] + y * distance];
    data += line([start, [start[0] + 5.5 * below[0] - 5 * x, start[1] + 5.5 * below[1] - 5 * y]]);
  }
  return data;
}

/** The side of a line on which its ground lies: down the page, or to the right of an upright line. */
export function belowOf([x, y]) {
  return x < -1e-9 || (Math.abs(x) <= 1e-9 && y > 0) ? [y, -x] : [-y, x];
}

/** A pivot of the ground: its foot, the line it stands on, and what lies below. */
export function footOf([x, y]) {
  const [from, to] = [
    [x - 14, y + 16],
    [x + 14, y + 16],
  ];
  const corners = [
    [x, y],
    [x - 9, y + 16],
    [x + 9, y + 16],
  ];
  return { foot: line(corners, true), base: line([from, to]), hatching: hatch(from, to, [0, 1]) };
}

/** The block of a slider, along a direction. */
export function blockOf([x, y], [along, up]) {
  const corner = (length, width) => [
    x + length * BLOCK[0] * along - width * BLOCK[1] * up,
    y + length * BLOCK[0] * up + width * BLOCK[1] * along,
  ];
  return line([corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)], true);
}

/**
 * The shaft of the arrow around a driven joint.
 * @param {number} from the angle of the driven link, counterclockwise
 * @param {number} sign the sense in which it turns, 1 or -1
 * @returns {number[][]}
 */
export function arcOfDrive([x, y], from, sign, radius = 19) {
  return [...Array(17).keys()].map((step) => {
    const angle = from + sign * (0.4 + (1.4 * step) / 16);
    return [x + radius * Math.cos(angle), y - radius * Math.sin(angle)];
  });
}

/** The head of an arrow whose shaft ends at a point. */
export function arrowHead(tip, from) {
  const [x, y] = unitOf(from, tip);
  const end = [tip[0] + 4 * x, tip[1] + 4 * y];
  const back = [end[0] - 9 * x, end[1] - 9 * y];
  return line([end, [back[0] - 3.4 * y, back[1] + 3.4 * x], [back[0] + 3.4 * y, back[1] - 3.4 * x]], true);
}

/** The corners of the smallest convex polygon around some points; two if all lie on one line. @returns {number[][]} */
export function hull(points) {
  const sorted = [...points].sort((one, other) => one[0] - other[0] || one[1] - other[1]);
  const chain = (all) => {
    const found = [];
    for (const point of all) {
      while (found.length > 1) {
        const [before, last] = found.slice(-2);
        const cross = (last[0] - before[0]) * (point[1] - last[1]) - (last[1] - before[1]) * (point[0] - last[0]);
        // less than a pixel beside the line is on it
        if (cross > 0.5 * Math.hypot(point[0] - before[0], point[1] - before[1])) {
          break;
        }
        found.pop();
      }
      const last = found[found.length - 1];
      if (!last || Math.hypot(point[0] - last[0], point[1] - last[1]) > 0.5) {
        found.push(point);
      }
    }
    return found;
  };
  const lower = chain(sorted);
  const upper = chain(sorted.reverse());
  if (lower.length === 1) {
    return lower;
  }
  const ring = [...lower.slice(0, -1), ...upper.slice(0, -1)];
  // beginning with the same point in every pose, so that a body's outline turns with it
  const first = Math.max(0, ring.indexOf(points.find((point) => ring.includes(point))));
  return [...ring.slice(first), ...ring.slice(0, first)];
}
