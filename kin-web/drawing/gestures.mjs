/** Pointers on the picture: the tool's gesture, a shift of the picture, or two fingers that enlarge it. */
import { follow, STILL, within } from "../../kin-studio/src/page/gesture.mjs";
import { zoomView } from "../../kin-studio/src/page/view.mjs";

/** The radii within which a pointer finds a part, in pixels. A finger hides what it points at. */
const RADII = { mouse: 12, pen: 14, touch: 22 };

export function handlePointers(svg, desk) {
  const fingers = new Map();
  /** @type {import("./toolset.mjs").Gesture | null} */
  let gesture = null;
  let spread = null;

  svg.addEventListener("pointerdown", (event) => {
    const start = within(svg, event);
    desk.hold(RADII[event.pointerType] ?? RADII.mouse);
    fingers.set(event.pointerId, start);
    if (fingers.size === 2) {
      gesture = null;
      desk.cancel();
      spread = spreadOf(fingers);
    } else if (fingers.size === 1) {
      const isShift = event.button === 1 || event.button === 2;
      gesture = (isShift ? null : desk.tool().press(desk, start, event.altKey)) ?? shift(desk, start);
    }
    svg.focus({ preventScroll: true });
    event.preventDefault();
    const own = gesture;
    let isMoved = false;
    follow(
      svg,
      event,
      (next) => {
        const place = within(svg, next);
        fingers.set(event.pointerId, place);
        isMoved ||= Math.hypot(place[0] - start[0], place[1] - start[1]) > STILL;
        if (spread !== null) {
          spread = spreadView(desk, spread, spreadOf(fingers));
        } else if (isMoved && own === gesture) {
          own?.move(place, next.altKey);
        }
      },
      (next) => {
        fingers.delete(event.pointerId);
        if (spread === null && own !== null && own === gesture) {
          if (next.type === "pointercancel") {
            desk.cancel();
          } else {
            desk.loosen(null, null);
            own.end(within(svg, next), isMoved, next.altKey);
          }
        }
        if (fingers.size === 0) {
          [gesture, spread] = [null, null];
          desk.release();
        }
      },
    );
  });
  svg.addEventListener("pointermove", (event) => {
    if (event.buttons === 0 && event.pointerType !== "touch") {
      desk.hover(within(svg, event), event.altKey);
    }
  });
  svg.addEventListener("contextmenu", (event) => event.preventDefault());
  svg.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      zoomView(desk.view, within(svg, event), Math.exp(-Math.max(-60, Math.min(60, event.deltaY)) * 0.004));
      desk.render();
    },
    { passive: false },
  );
}

function shift(desk, start) {
  let last = start;
  return {
    move(place) {
      desk.view.x += place[0] - last[0];
      desk.view.y += place[1] - last[1];
      last = place;
      desk.render();
    },
    end() {},
  };
}

/** The middle of two fingers and their distance. */
function spreadOf(fingers) {
  const [[x, y], [toX, toY]] = [...fingers.values()].concat([[0, 0]]);
  return { middle: [(x + toX) / 2, (y + toY) / 2], distance: Math.hypot(toX - x, toY - y), count: fingers.size };
}

function spreadView(desk, from, to) {
  if (from.count === 2 && to.count === 2) {
    desk.view.x += to.middle[0] - from.middle[0];
    desk.view.y += to.middle[1] - from.middle[1];
    zoomView(desk.view, to.middle, to.distance / Math.max(1, from.distance));
    desk.render();
  }
  return to;
}
