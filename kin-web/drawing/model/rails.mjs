/** The lines of slides turn with the links that carry them. */
import { at } from "./sketch.mjs";

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

/** Turns the lines of slides as far as their links have turned since a drawing. */
export function turnSlides(before, draft) {
  for (const slide of draft.slides) {
    const turn = wrapped(heading(draft, slide) - heading(before, slide));
    if (Math.abs(turn) > 1e-12) {
      slide.direction = wrapped(slide.direction + turn);
    }
  }
}
