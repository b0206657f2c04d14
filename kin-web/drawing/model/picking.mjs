/** The part that lies at a place of the picture. */
import { hull } from "../../../kin-studio/src/page/notation.mjs";

/** The distance of a place from a segment, and how far along it its foot lies, from 0 to 1. */
export function fromSegment([x, y], [fromX, fromY], [toX, toY]) {
  const [runX, runY] = [toX - fromX, toY - fromY];
  const square = runX * runX + runY * runY;
  const along = square > 0 ? Math.max(0, Math.min(1, ((x - fromX) * runX + (y - fromY) * runY) / square)) : 0;
  return { distance: Math.hypot(x - fromX - along * runX, y - fromY - along * runY), along };
}

function distanceFrom(place, corners) {
  const outer = hull(corners);
  if (outer.length === 1) {
    return Math.hypot(place[0] - outer[0][0], place[1] - outer[0][1]);
  }
  const sides = outer.map((from, index) => [from, outer[(index + 1) % outer.length]]);
  const isInside =
    outer.length > 2 &&
    sides.every(([from, to]) => (to[0] - from[0]) * (place[1] - from[1]) >= (to[1] - from[1]) * (place[0] - from[0]));
  return isInside ? 0 : Math.min(...sides.map(([from, to]) => fromSegment(place, from, to).distance));
}

/**
 * The nearest pin within a radius, or else the nearest link.
 * @param {number[][]} places where the points are in the picture
 * @param {{radius: number, except?: number[]}} options points that are not looked at
 * @returns {import("./sketch.mjs").Part | null}
 */
export function pick(sketch, places, place, { radius, except = [] }) {
  const point = pickPoint(places, place, { radius, except });
  return point === null ? pickLink(sketch, places, place, { radius }) : { kind: "point", index: point };
}

/** The nearest pin within a radius, or null. */
export function pickPoint(places, place, { radius, except = [] }) {
  const found = nearest(
    places.map((of) => Math.hypot(of[0] - place[0], of[1] - place[1])),
    radius,
    except,
  );
  return found;
}

/** The nearest link within a radius as a part, or null. */
export function pickLink(sketch, places, place, { radius, except = [] }) {
  const distances = sketch.links.map(({ points }) =>
    points.length > 0
      ? distanceFrom(
          place,
          points.map((point) => places[point]),
        )
      : Infinity,
  );
  const index = nearest(distances, radius, except);
  return index === null ? null : { kind: "link", index };
}

function nearest(distances, radius, except) {
  let best = null;
  distances.forEach((distance, index) => {
    if (distance <= radius && !except.includes(index) && (best === null || distance < distances[best])) {
      best = index;
    }
  });
  return best;
}
