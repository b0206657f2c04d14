/**
 * A length that is typed. Newton's method closes the linkage again with all its other lengths: it moves the points as
 * little as it can, at first without turning what is driven. If the linkage cannot close so, the end of the link moves
 * along the link, and the links that share the end get other lengths.
 */
import { movePoint, movePoints, changed } from "./edits.mjs";
import { at, linksAt, pivotOf } from "./sketch.mjs";

const ITERATIONS = 60;
/** The part of the drawing's size below which an equation holds. */
const CLOSED = 1e-11;

const minus = ([x, y], [fromX, fromY]) => [x - fromX, y - fromY];
const cross = ([x, y], [toX, toY]) => x * toY - y * toX;

/** The distance of two points. */
export function lengthOf(sketch, from, to) {
  return Math.hypot(...minus(at(sketch, to), at(sketch, from)));
}

/** The pairs of a link's points whose distances are shown: its sides. */
export function sidesOf({ points }) {
  const sides = points.slice(1).map((point, index) => [points[index], point]);
  return points.length > 2 ? [...sides, [points[points.length - 1], points[0]]] : sides;
}

/**
 * Gives two points of a link another distance.
 * @returns {{sketch: import("./sketch.mjs").Sketch, isKept: boolean}} and whether all other lengths are as they were
 */
export function setLength(sketch, link, from, to, length) {
  const shape = reshaped(sketch, link, from, to, length);
  const turned =
    closed(sketch, equationsOf(sketch, link, shape, true)) ?? closed(sketch, equationsOf(sketch, link, shape, false));
  if (turned !== null) {
    return { sketch: changed(sketch, (draft) => movePoints(draft, turned)), isKept: true };
  }
  const isFree = (point) => !sketch.ground.includes(point);
  const count = (point) => (isFree(point) ? linksAt(sketch, point).length : Infinity);
  const [stays, moves] = count(from) < count(to) ? [to, from] : [from, to];
  const [x, y] = minus(at(sketch, moves), at(sketch, stays));
  const factor = length / Math.hypot(x, y);
  const [startX, startY] = at(sketch, stays);
  const end = [startX + factor * x, startY + factor * y];
  return { sketch: changed(sketch, (draft) => movePoint(draft, moves, end)), isKept: false };
}

/** The points of a link in the shape that it gets: a triangle keeps its other two sides. */
function reshaped(sketch, link, from, to, length) {
  const { points } = sketch.links[link];
  const shape = new Map(points.map((point) => [point, at(sketch, point)]));
  const along = minus(shape.get(to), shape.get(from));
  const before = Math.hypot(...along);
  const end = [0, 1].map((axis) => shape.get(from)[axis] + (along[axis] * length) / before);
  shape.set(to, end);
  const third = points.length === 3 ? points.find((point) => point !== from && point !== to) : undefined;
  if (third !== undefined) {
    const [near, far] = [lengthOf(sketch, from, third), lengthOf(sketch, to, third)];
    const side = cross(along, minus(at(sketch, third), at(sketch, from))) / before;
    const foot = (near ** 2 - far ** 2 + length ** 2) / (2 * length);
    const height = near ** 2 - foot ** 2;
    if (height > 0 && Math.abs(side) > 1e-6 * before) {
      const [x, y] = along.map((value) => value / before);
      const up = Math.sign(side) * Math.sqrt(height);
      const [startX, startY] = shape.get(from);
      shape.set(third, [startX + foot * x - up * y, startY + foot * y + up * x]);
    }
  }
  return shape;
}

/** The conditions of all links and slides, as functions of the places of the points that give numbers. */
function equationsOf(sketch, changedLink, shape, isDriveHeld) {
  const equations = [];
  const before = (point) => at(sketch, point);
  const headingOf = (places, [first, second]) => minus(places(second), places(first));
  sketch.links.forEach(({ points }, link) => {
    const own = (point) => (link === changedLink ? shape.get(point) : before(point));
    const [first, second, ...others] = points;
    if (second === undefined) {
      return;
    }
    const target = headingOf(own, points);
    const long = Math.hypot(...target);
    equations.push((places) => [Math.hypot(...headingOf(places, points)) - long]);
    for (const point of others) {
      const [x, y] = minus(own(point), own(first));
      const local = [(x * target[0] + y * target[1]) / long, (y * target[0] - x * target[1]) / long];
      equations.push((places) => {
        const heading = headingOf(places, points);
        const [unitX, unitY] = heading.map((value) => value / Math.hypot(...heading));
        const [toX, toY] = minus(places(point), places(first));
        return [toX - local[0] * unitX + local[1] * unitY, toY - local[0] * unitY - local[1] * unitX];
      });
    }
  });
  for (const { point, on, direction, guided } of sketch.slides) {
    const carrier = on === "ground" ? [] : sketch.links[on].points;
    if (on !== "ground" && carrier.length < 2) {
      continue;
    }
    const turned = (places) => {
      if (on === "ground") {
        return 0;
      }
      const [one, other] = [headingOf(before, carrier), headingOf(places, carrier)];
      return Math.atan2(cross(one, other), one[0] * other[0] + one[1] * other[1]);
    };
    const along = (places) => [Math.cos(direction + turned(places)), Math.sin(direction + turned(places))];
    const origin = on === "ground" ? () => before(point) : (places) => places(carrier[0]);
    const offset = cross(along(before), minus(before(point), origin(before)));
    equations.push((places) => [cross(along(places), minus(places(point), origin(places))) - offset]);
    const held = guided === null ? [] : sketch.links[guided].points;
    if (held.length > 1) {
      const angle = cross(along(before), headingOf(before, held)) / Math.hypot(...headingOf(before, held));
      equations.push((places) => {
        const heading = headingOf(places, held);
        return [cross(along(places), heading) - angle * Math.hypot(...heading)];
      });
    }
  }
  for (const { angle } of isDriveHeld ? sketch.drives : []) {
    if (angle?.to === "ground") {
      const pivot = pivotOf(sketch, angle.of);
      const arm = sketch.links[angle.of].points.find((point) => point !== pivot);
      if (arm !== undefined) {
        const heading = headingOf(before, [pivot, arm]);
        const long = Math.hypot(...heading);
        equations.push((places) => [cross(heading, headingOf(places, [pivot, arm])) / long]);
      }
    }
  }
  return equations;
}

/** The places of the points that move, nearest to where they are drawn; null if the linkage does not close. */
function closed(sketch, equations) {
  const free = [...sketch.points.keys()].filter((point) => !sketch.ground.includes(point));
  const size = Math.max(
    ...[0, 1].map((axis) => extent(sketch.points.map((_, point) => at(sketch, point)[axis]))),
    1e-9,
  );
  const values = free.flatMap((point) => at(sketch, point));
  const residuals = () => {
    const places = (point) => {
      const index = free.indexOf(point);
      return index < 0 ? at(sketch, point) : [values[2 * index], values[2 * index + 1]];
    };
    return equations.flatMap((equation) => equation(places));
  };
  for (let iteration = 0; iteration < ITERATIONS; iteration += 1) {
    const now = residuals();
    if (now.every((value) => Math.abs(value) < CLOSED * size)) {
      return new Map(free.map((point, index) => [point, [values[2 * index], values[2 * index + 1]]]));
    }
    const step = 1e-6 * size;
    const columns = values.map((value, index) => {
      values[index] = value + step;
      const up = residuals();
      values[index] = value - step;
      const down = residuals();
      values[index] = value;
      return up.map((one, row) => (one - down[row]) / (2 * step));
    });
    const normal = now.map((_, row) =>
      now.map((__, other) =>
        columns.reduce((sum, column) => sum + column[row] * column[other], row === other ? 1e-12 : 0),
      ),
    );
    const weights = solved(normal, now);
    const moves = columns.map((column) => -column.reduce((sum, value, row) => sum + value * weights[row], 0));
    const longest = Math.max(...moves.map(Math.abs), 1e-300);
    if (!Number.isFinite(longest)) {
      return null;
    }
    const part = Math.min(1, (0.25 * size) / longest);
    moves.forEach((move, index) => (values[index] += part * move));
  }
  return null;
}

function extent(values) {
  return Math.max(...values) - Math.min(...values);
}

/** Linear equations by elimination with the largest pivots. */
function solved(matrix, right) {
  const rows = matrix.map((row, index) => [...row, right[index]]);
  const count = rows.length;
  for (let column = 0; column < count; column += 1) {
    let pivot = column;
    for (let row = column + 1; row < count; row += 1) {
      if (Math.abs(rows[row][column]) > Math.abs(rows[pivot][column])) {
        pivot = row;
      }
    }
    [rows[column], rows[pivot]] = [rows[pivot], rows[column]];
    for (let row = column + 1; row < count; row += 1) {
      const factor = rows[row][column] / rows[column][column];
      for (let index = column; index <= count; index += 1) {
        rows[row][index] -= factor * rows[column][index];
      }
    }
  }
  const found = Array(count).fill(0);
  for (let row = count - 1; row >= 0; row -= 1) {
    const rest = found.reduce((sum, value, index) => (index > row ? sum + rows[row][index] * value : sum), 0);
    found[row] = (rows[row][count] - rest) / rows[row][row];
  }
  return found;
}
