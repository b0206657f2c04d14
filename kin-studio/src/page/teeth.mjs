/** The outlines of gears and racks. */

/** The height of a tooth above and its depth below the pitch curve, in modules. */
const TIP = 0.9;
const ROOT = 1.1;
/** Half the width of a tooth at its root and at its tip, in parts of the pitch. */
const WIDE = 0.36;
const NARROW = 0.14;
/** The rim behind the teeth of a ring or a rack, in modules. */
const RIM = 3.2;

/** The corners of a gear's teeth, and of its rim if they stand inside. @returns {number[][][]} closed lines */
export function teethOf({ centre: [x, y], radius, teeth, phase, isRing }) {
  const size = ((2 * radius) / teeth) * (isRing ? -1 : 1);
  const step = (2 * Math.PI) / teeth;
  const at = (angle, far) => [x + far * Math.cos(angle), y + far * Math.sin(angle)];
  const [tip, root] = [radius + TIP * size, radius - ROOT * size];
  const corners = [...Array(teeth).keys()].flatMap((tooth) => {
    const middle = phase + tooth * step;
    return [
      at(middle - WIDE * step, root),
      at(middle - NARROW * step, tip),
      at(middle + NARROW * step, tip),
      at(middle + WIDE * step, root),
    ];
  });
  const rim = [...Array(72).keys()].map((part) => at((part * Math.PI) / 36, radius - RIM * size));
  return isRing ? [corners, rim] : [corners];
}

/** The corners of a rack. @returns {number[][]} a closed line */
export function rackOf({ from, to, along, up, first, pitch }) {
  const size = pitch / Math.PI;
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const at = (way, high) => from.map((value, axis) => value + way * along[axis] + high * up[axis]);
  const corners = [at(0, -RIM * size), at(0, -ROOT * size)];
  for (let middle = first; middle + WIDE * pitch < length; middle += pitch) {
    if (middle - WIDE * pitch > 0) {
      corners.push(
        at(middle - WIDE * pitch, -ROOT * size),
        at(middle - NARROW * pitch, TIP * size),
        at(middle + NARROW * pitch, TIP * size),
        at(middle + WIDE * pitch, -ROOT * size),
      );
    }
  }
  return [...corners, at(length, -ROOT * size), at(length, -RIM * size)];
}
