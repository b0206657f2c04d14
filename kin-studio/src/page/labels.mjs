/** Names at free positions of the picture. */

/** The width of a letter, for each pixel of its height. */
const LETTER = 0.58;
/** The sides of its point on which a name may stand, the best first, in eighths of a revolution. */
const SIDES = [7, 5, 1, 3, 6, 2, 0, 4];

/** The distances at which a name may stand from its point, in pixels. */
const DISTANCES = [6, 10, 15, 22];

/**
 * @typedef {{lines: [number[], number[], number][], boxes: number[][], width: number, height: number}} Room
 */

/** A picture in which nothing stands yet. @returns {Room} */
export function createRoom(width, height) {
  return { lines: [], boxes: [], width, height };
}

/** Keeps a square free. */
export function keepSquare(room, [x, y], half) {
  room.boxes.push([x - half, y - half, x + half, y + half]);
}

/**
 * Keeps lines free.
 * @param {number} half half their width
 */
export function keepLines(room, points, half, closed = false) {
  for (let index = 1; index < points.length + (closed ? 1 : 0); index += 1) {
    room.lines.push([points[index - 1], points[index % points.length], half]);
  }
}

/**
 * The middle of the freest position for a name, which is taken then; null if there is no room. The last choice is kept
 * as long as it is good enough, so that names do not jump about in motion.
 * @returns {{x: number, y: number, choice: number} | null}
 */
export function placeName(room, around, text, size, last) {
  const half = [0.5 * LETTER * size * text.length + 1, 0.55 * size];
  const lines = linesNear(room, around, half);
  if (last) {
    const centre = centreOfChoice(around, half, last.choice);
    if (centre !== null && costOf(room, lines, centre, half, 9) < 9) {
      room.boxes.push([centre[0] - half[0], centre[1] - half[1], centre[0] + half[0], centre[1] + half[1]]);
      return { x: centre[0], y: centre[1], choice: last.choice };
    }
  }
  let best = null;
  let choice = 0;
  for (const distance of DISTANCES) {
    for (let option = 0; option < around.length * SIDES.length; option += 1) {
      const centre = centreOfChoice(around, half, choice);
      const allowed = best === null ? Infinity : best.cost;
      const cost = costOf(room, lines, centre, half, allowed - distance * 0.05) + distance * 0.05;
      if (cost < allowed - 1e-9) {
        best = { x: centre[0], y: centre[1], cost, choice };
      }
      choice += 1;
    }
    if (best !== null && best.cost < 1.5) {
      break;
    }
  }
  if (best === null || best.cost > 60) {
    return null;
  }
  room.boxes.push([best.x - half[0], best.y - half[1], best.x + half[0], best.y + half[1]]);
  return best;
}

/** The middle of a name at one of its positions, counted by distance, then by point, then by side. */
function centreOfChoice(around, [wide, high], choice) {
  const [options, sides] = [around.length * SIDES.length, SIDES.length];
  const point = around[Math.floor((choice % options) / sides)];
  const distance = DISTANCES[Math.floor(choice / options)];
  if (point === undefined || distance === undefined) {
    return null;
  }
  const angle = (SIDES[choice % sides] * Math.PI) / 4;
  return [point[0] + Math.cos(angle) * (wide + distance), point[1] + Math.sin(angle) * (high + distance)];
}

/** The lines that can meet a name: most are too far away, and each position would look at them again. */
function linesNear({ lines }, around, [wide, high]) {
  const [xs, ys] = [0, 1].map((axis) => around.map((point) => point[axis]));
  const farthest = DISTANCES.at(-1);
  const [left, right] = [Math.min(...xs) - 2 * wide - farthest, Math.max(...xs) + 2 * wide + farthest];
  const [top, bottom] = [Math.min(...ys) - 2 * high - farthest, Math.max(...ys) + 2 * high + farthest];
  return lines.filter(
    ([from, to, half]) =>
      Math.max(from[0], to[0]) + half >= left &&
      Math.min(from[0], to[0]) - half <= right &&
      Math.max(from[1], to[1]) + half >= top &&
      Math.min(from[1], to[1]) - half <= bottom,
  );
}

/** The cost of a position: 100 for each overlap with another name or with the edge, less for lines. */
function costOf(room, lines, [x, y], [wide, high], allowed) {
  let cost = 0;
  if (x - wide < 2 || y - high < 2 || x + wide > room.width - 2 || y + high > room.height - 2) {
    cost += 100;
  }
  for (const [left, top, right, bottom] of room.boxes) {
    if (x + wide > left && x - wide < right && y + high > top && y - high < bottom) {
      cost += 100;
    }
    if (cost > allowed) {
      return cost;
    }
  }
  for (const [from, to, half] of lines) {
    cost += 10 * covered(from, to, [x, y], wide + half, high + half);
    if (cost > allowed) {
      return cost;
    }
  }
  return cost;
}

/** The part of a line within a box, in pixels, a tenth of it at most ten. */
function covered(from, to, centre, wide, high) {
  let [start, end] = [0, 1];
  for (const [axis, half] of [
    [0, wide],
    [1, high],
  ]) {
    const run = to[axis] - from[axis];
    const offset = centre[axis] - from[axis];
    if (Math.abs(run) < 1e-9) {
      if (Math.abs(offset) > half) {
        return 0;
      }
      continue;
    }
    const [one, other] = [(offset - half) / run, (offset + half) / run];
    start = Math.max(start, Math.min(one, other));
    end = Math.min(end, Math.max(one, other));
  }
  return end <= start ? 0 : 0.3 + Math.min(1, ((end - start) * Math.hypot(to[0] - from[0], to[1] - from[1])) / 30);
}
