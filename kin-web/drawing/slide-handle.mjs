/** Handles of slides: one stands at the end of the line of each slide of the selected pin, and turns the line. */
import { snapDirection } from "./model/grid.mjs";
import { slidesAt } from "./model/sketch.mjs";

/** The distance of a handle from its pin in pixels, which is half the length of the drawn line. */
export const REACH = 46;

/** Where the handles of the selected pin stand in the picture. */
export function handlesOf(sketch, places, selection) {
  if (selection?.kind !== "point") {
    return [];
  }
  const [x, y] = places[selection.index];
  return slidesAt(sketch, selection.index).map((slide) => {
    const { direction } = sketch.slides[slide];
    return { slide, place: [x + REACH * Math.cos(direction), y - REACH * Math.sin(direction)] };
  });
}

/** The slide whose handle is at a place, or null. */
export function handleAt(handles, [x, y], radius) {
  return handles.find(({ place }) => Math.hypot(place[0] - x, place[1] - y) < radius)?.slide ?? null;
}

/** The gesture that turns the line of a slide. @returns {import("./toolset.mjs").Gesture} */
export function turning(desk, slide) {
  const [x, y] = desk.placeOf(desk.base().slides[slide].point);
  return {
    move([toX, toY], isFree) {
      const angle = Math.atan2(y - toY, toX - x);
      const direction = isFree || !desk.isSnapping() ? angle : snapDirection(angle);
      desk.preview((draft) => Object.assign(draft.slides[slide], { direction }));
    },
    end: () => desk.commit(),
  };
}
