/** The tools: what a press at a place does, and the drag or the click that it becomes. */
import {
  addLink,
  addPoint,
  addSlide,
  addToLink,
  driveAt,
  fix,
  joinPoints,
  moveLink,
  movePoint,
  removeSlide,
} from "./model/edits.mjs";
import { snapDirection } from "./model/grid.mjs";
import { at, nameOf, slidesAt } from "./model/sketch.mjs";
import { turning } from "./slide-handle.mjs";

/**
 * @typedef {object} Gesture
 * @property {(place: number[], isFree: boolean) => void} move isFree: without the grid
 * @property {(place: number[], isMoved: boolean, isFree: boolean) => void} end isMoved: a drag and not a click
 * @typedef {{point: number} | {link: number, at: number[]} | {at: number[]}} Target a pin, a place on a link, a place
 * @typedef {object} Tool
 * @property {string} id
 * @property {string} key
 * @property {string} label
 * @property {string} hint
 * @property {(desk: any, place: number[], isFree: boolean) => Gesture | null} press null if the picture is shifted
 */

/** The point of a target, which is made if it is not there. */
function pointAt(draft, target) {
  if (target.point !== undefined) {
    return target.point;
  }
  const point = addPoint(draft, target.at);
  if (target.link !== undefined) {
    addToLink(draft, target.link, point);
  }
  return point;
}

/** Where a target lies, in the drawing. */
function placeOf(sketch, target) {
  return target.point === undefined ? target.at : at(sketch, target.point);
}

const nothing = { move() {}, end() {} };

/** A gesture that acts as soon as the pointer is lifted, wherever. */
const onEnd = (action) => ({ move() {}, end: action });

const select = {
  id: "select",
  key: "v",
  label: "Select",
  hint: "Click a pin or a link to see its values, or drag it. Digits give a link its length. Alt leaves the grid.",
  press(desk, place) {
    const handle = desk.pickHandle(place);
    if (handle !== null) {
      return turning(desk, handle);
    }
    const part = desk.pick(place);
    desk.select(part);
    if (part === null) {
      return null;
    }
    const start = desk.toDrawing(place);
    if (part.kind === "point") {
      const targetOf = (to) => desk.pickPoint(to, [part.index]);
      return {
        move(to, isFree) {
          const other = targetOf(to);
          const end = other === null ? desk.snapped(to, isFree) : at(desk.base(), other);
          desk.preview((draft) => movePoint(draft, part.index, end));
        },
        end(to, isMoved) {
          const other = isMoved ? targetOf(to) : null;
          if (other !== null) {
            desk.preview((draft) => joinPoints(draft, other, part.index));
            desk.select({ kind: "point", index: other > part.index ? other - 1 : other });
            desk.say("The two pins are one joint now.");
          }
          desk.commit();
        },
      };
    }
    const first = at(desk.sketch(), desk.sketch().links[part.index].points[0]);
    const offset = [first[0] - start[0], first[1] - start[1]];
    return {
      move(to, isFree) {
        const here = desk.toDrawing(to);
        const end = desk.nearGrid([here[0] + offset[0], here[1] + offset[1]], isFree);
        desk.preview((draft) => moveLink(draft, part.index, [end[0] - first[0], end[1] - first[1]]));
      },
      end: () => desk.commit(),
    };
  },
};

const link = {
  id: "link",
  key: "l",
  label: "Link",
  hint: "Drag from pin to pin, or click one after the other. On a link, a new pin is made. Escape ends.",
  press(desk, place, isFree) {
    const start = desk.pending() ?? desk.target(place, isFree);
    const isSecond = desk.pending() !== null;
    const finish = (target) => {
      desk.setPending(null);
      const kept = { index: 0 };
      const isSame = JSON.stringify(target) === JSON.stringify(start);
      if (isSame) {
        desk.say("A link has two pins: choose another place for the second.");
        return;
      }
      const count = desk.sketch().links.length;
      desk.edit((draft) => {
        const points = [pointAt(draft, start), pointAt(draft, target)];
        kept.index = addLink(draft, points);
      });
      desk.select({ kind: "link", index: kept.index });
      if (kept.index < count) {
        desk.say(`${nameOf(desk.sketch(), kept.index)} has both pins already.`);
      }
    };
    return {
      move(to, isNowFree) {
        desk.loosen(placeOf(desk.sketch(), start), desk.target(to, isNowFree));
      },
      end(to, isMoved, isNowFree) {
        const target = desk.target(to, isNowFree);
        if (isMoved || isSecond) {
          finish(target);
        } else {
          desk.setPending(start);
          desk.say("Choose the other pin of the link.");
        }
      },
    };
  },
};

const pin = {
  id: "pin",
  key: "p",
  label: "Pin",
  hint: "Click a link to bore it there, or drag from it to give it another corner. A selected link takes any pin.",
  press(desk, place, isFree) {
    const target = desk.target(place, isFree);
    const chosen = desk.selection();
    const owner = target.link ?? (chosen?.kind === "link" ? chosen.index : undefined);
    if (owner === undefined) {
      desk.say("Choose the link that gets the pin.");
      const part = desk.pick(place);
      desk.select(part?.kind === "link" ? part : null);
      return nothing;
    }
    const give = (to) => {
      desk.edit((draft) => addToLink(draft, owner, pointAt(draft, to.link === owner ? { at: to.at } : to)));
      desk.select({ kind: "link", index: owner });
    };
    return {
      move: (to, isNowFree) => desk.loosen(placeOf(desk.sketch(), target), desk.target(to, isNowFree)),
      end: (to, isMoved, isNowFree) => give(isMoved ? desk.target(to, isNowFree) : target),
    };
  },
};

const ground = {
  id: "ground",
  key: "g",
  label: "Ground",
  hint: "Click a pin to fix it to the ground or to free it; click elsewhere for a new fixed pin.",
  press(desk, place, isFree) {
    const target = desk.target(place, isFree);
    return onEnd(() => {
      const isFixed = target.point === undefined || !desk.sketch().ground.includes(target.point);
      let point = 0;
      desk.edit((draft) => {
        point = pointAt(draft, target);
        fix(draft, point, isFixed);
      });
      desk.select({ kind: "point", index: point });
    });
  },
};

const slider = {
  id: "slider",
  key: "s",
  label: "Slider",
  hint: "Drag from a pin in the direction of its line, or onto the link that carries it. Click again to take it away.",
  press(desk, place, isFree) {
    const found = desk.pickPoint(place);
    const target = found === null ? { at: desk.snapped(place, isFree) } : { point: found };
    const start = desk.toPicture(placeOf(desk.sketch(), target));
    const carrierAt = (to) => (found === null ? null : desk.pickOtherLink(to, found));
    const lineTo = (to, isNowFree) => {
      const carrier = carrierAt(to);
      if (carrier !== null) {
        const [first, second] = desk.base().links[carrier].points.map((point) => at(desk.base(), point));
        return { on: carrier, direction: second ? Math.atan2(second[1] - first[1], second[0] - first[0]) : 0 };
      }
      const angle = Math.atan2(start[1] - to[1], to[0] - start[0]);
      return { on: "ground", direction: isNowFree || !desk.isSnapping() ? angle : snapDirection(angle) };
    };
    const put = ({ on, direction }) =>
      desk.preview((draft) => {
        const point = pointAt(draft, target);
        addSlide(draft, point, on, direction);
        desk.select({ kind: "point", index: point });
      });
    return {
      move: (to, isNowFree) => put(lineTo(to, isNowFree)),
      end(to, isMoved, isNowFree) {
        const slides = found === null ? [] : slidesAt(desk.base(), found);
        if (isMoved) {
          put(lineTo(to, isNowFree));
        } else if (slides.length > 0) {
          desk.preview((draft) => removeSlide(draft, slides[0]));
          desk.select({ kind: "point", index: found });
        } else {
          const carrier = carrierAt(place);
          put(carrier === null ? { on: "ground", direction: 0 } : lineTo(place, isNowFree));
        }
        desk.commit();
      },
    };
  },
};

const drive = {
  id: "drive",
  key: "d",
  label: "Drive",
  hint: "Click a link to turn it from the ground, or a sliding pin to move it; click again to take the drive away.",
  press(desk, place) {
    const part = desk.pick(place);
    return onEnd(() => {
      let isDone = false;
      if (part !== null) {
        desk.edit((draft) => (isDone = driveAt(draft, part)));
        desk.select(part);
      }
      if (!isDone) {
        desk.say("Choose a link, or a pin that slides.");
      }
    });
  },
};

/** @type {Tool[]} */
export const toolset = [select, link, pin, ground, slider, drive];
