/** Pointers on the picture, the plots and the scrubber. */
import { followedAt, coordinatesOf } from "./kinematics/anatomy.mjs";
import { follow, STILL, within } from "./gesture.mjs";
import { flat, onPage, orbitView, zoomView } from "./view.mjs";

/** Links are dragged; the empty plane is shifted, and space is turned. */
export function handlePicture(svg, model, actions) {
  const { view } = actions;
  const grabbed = (body, at) => {
    const { joints } = actions.pose();
    if (!model.space) {
      return followedAt(model, body, joints, [(at[0] - view.x) / view.scale, (view.y - at[1]) / view.scale]);
    }
    const flatJoints = joints.map((joint) => flat(view, joint));
    return followedAt(model, body, flatJoints, [(at[0] - view.x) / view.scale, (at[1] - view.y) / view.scale]);
  };
  svg.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) {
      return;
    }
    const target = event.target;
    const body = target.getAttribute("data-body");
    const assembly = target.getAttribute("data-assembly");
    const start = within(svg, event);
    if (assembly !== null) {
      actions.assembly(Number(assembly));
      return;
    }
    if (body !== null) {
      const followed = grabbed(Number(body), start);
      const placed = (pose) => onPage(view, coordinatesOf(model, followed, pose.joints));
      svg.classList.add("dragging");
      let moved = false;
      const move = (next) => {
        const at = within(svg, next);
        moved ||= Math.hypot(at[0] - start[0], at[1] - start[1]) > STILL;
        if (moved) {
          actions.drag(placed, at);
        }
      };
      follow(svg, event, move, () => {
        svg.classList.remove("dragging");
        if (!moved) {
          actions.pick(Number(body));
        }
        actions.end();
      });
      return;
    }
    if (event.pointerType === "touch" && !model.space) {
      return;
    }
    let last = start;
    const centre = centreOf(actions.pose().joints);
    follow(
      svg,
      event,
      (next) => {
        const at = within(svg, next);
        const by = [at[0] - last[0], at[1] - last[1]];
        if (model.space && !next.shiftKey) {
          orbitView(view, by, centre);
        } else {
          view.x += by[0];
          view.y += by[1];
        }
        last = at;
        actions.changed();
      },
      () => {},
    );
  });
  svg.addEventListener("dblclick", (event) => {
    const body = event.target.getAttribute("data-body");
    if (body !== null) {
      actions.trace(grabbed(Number(body), within(svg, event)));
    }
  });
  onWheel(svg, (at, factor) => {
    zoomView(view, at, factor);
    actions.changed();
  });
}

function centreOf(joints) {
  return joints[0].map((_, axis) => joints.reduce((sum, joint) => sum + joint[axis], 0) / joints.length);
}

/** The wheel enlarges once an element was clicked, or with the control key; otherwise it scrolls the page. */
function onWheel(svg, zoom) {
  svg.addEventListener(
    "wheel",
    (event) => {
      if (event.ctrlKey || event.metaKey || document.activeElement === svg) {
        event.preventDefault();
        zoom(within(svg, event), Math.exp(-Math.max(-60, Math.min(60, event.deltaY)) * 0.004));
      }
    },
    { passive: false },
  );
}

/** Hovering moves the mechanism, a drag enlarges a part, the wheel zooms, a double click shows all. */
export function handlePlots(svg, actions) {
  svg.addEventListener("pointermove", (event) => {
    if (event.buttons === 0 || event.pointerType === "touch") {
      actions.hover(actions.inputAt(within(svg, event)[0]));
    }
  });
  svg.addEventListener("pointerleave", () => actions.leave());
  svg.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || event.pointerType === "touch") {
      return;
    }
    const start = within(svg, event)[0];
    let end = start;
    follow(
      svg,
      event,
      (next) => {
        end = within(svg, next)[0];
        actions.select([actions.inputAt(start), actions.inputAt(end)]);
      },
      () => {
        actions.select(null);
        if (Math.abs(end - start) > 2 * STILL) {
          const [one, other] = [actions.inputAt(start), actions.inputAt(end)];
          actions.zoom([Math.min(one, other), Math.max(one, other)]);
        }
      },
    );
  });
  svg.addEventListener("dblclick", () => actions.all());
  onWheel(svg, (at, factor) => {
    const [from, to] = actions.zoomed();
    const here = actions.inputAt(at[0]);
    actions.zoom([here + (from - here) / factor, here + (to - here) / factor]);
  });
}

/** A press or a drag moves the mechanism. */
export function handleScrubber(svg, actions) {
  svg.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) {
      return;
    }
    const move = (next) => actions.move(actions.inputAt(within(svg, next)[0]));
    move(event);
    follow(svg, event, move, () => actions.end());
  });
}
