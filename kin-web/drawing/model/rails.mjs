/** The lines of slides turn with the links that carry them, and slotted levers with the pins in their slots. */
import { at, linksAt, slidesAt } from "./sketch.mjs";

/** The direction that turns with the body of a slide: between two points of it, or from its only point. */
function heading(sketch, { on, point }) {
  if (on === "ground") {
    return 0;
  }
  const [first, second = point] = sketch.links[on].points;
  if (first === undefined || first === second) {
    return 0;
  }
  const [[x, y], [toX, toY]] = [at(sketch, first), at(sketch, second)];
  return Math.atan2(toY - y, toX - x);
}

/** An angle between half a revolution back and half a revolution on. */
export function wrapped(angle) {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}

/**
 * Turns links about their pivots after points that slide along them, as a slotted lever follows its pin: where the line
 * goes through the pivot, and the lever has no other joint. Otherwise the line goes beside the pivot from then on.
 * @param {Iterable<number>} moved
 */
export function turnLevers(before, draft, moved) {
  for (const point of moved) {
    for (const slide of slidesAt(before, point)) {
      const { on, direction } = before.slides[slide];
      const points = on === "ground" ? [] : before.links[on].points;
      const isJoint = (other) =>
        before.ground.includes(other) || linksAt(before, other).length > 1 || slidesAt(before, other).length > 0;
      const pivots = points.filter(isJoint);
      if (pivots.length !== 1 || before.slides.some((other) => other.guided === on)) {
        continue;
      }
      const [pivot] = pivots;
      const [x, y] = at(draft, pivot);
      const arm = (sketch) => at(sketch, point).map((value, axis) => value - at(sketch, pivot)[axis]);
      const [[fromX, fromY], [toX, toY]] = [arm(before), arm(draft)];
      const long = Math.hypot(fromX, fromY);
      const isInLine = Math.abs(fromX * Math.sin(direction) - fromY * Math.cos(direction)) < 1e-6 * long;
      if (!isInLine || Math.hypot(toX, toY) < 1e-6 * long) {
        continue;
      }
      const turn = Math.atan2(toY, toX) - Math.atan2(fromY, fromX);
      const [sine, cosine] = [Math.sin(turn), Math.cos(turn)];
      for (const other of points.filter((one) => one !== pivot)) {
        const [alongX, alongY] = [0, 1].map((axis) => at(before, other)[axis] - at(before, pivot)[axis]);
        const place = { x: x + alongX * cosine - alongY * sine, y: y + alongX * sine + alongY * cosine };
        Object.assign(draft.points[other], place);
      }
    }
  }
}

/** Turns the lines of slides as far as their links have turned since a drawing. */
export function turnSlides(before, draft) {
  for (const slide of draft.slides) {
    const turn = wrapped(heading(draft, slide) - heading(before, slide));
    if (Math.abs(turn) > 1e-12) {
      slide.direction = wrapped(slide.direction + turn);
    }
  }
}
