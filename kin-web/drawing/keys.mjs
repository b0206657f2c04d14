/** The keyboard: tools by their letters, arrows that move, digits that are a length, Enter that acts as a click. */
import { toolset } from "./toolset.mjs";

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Handles the keys of the picture and of the tool bar. */
export function handleKeys(svg, tools, desk) {
  const onKey = (event) => {
    const isField = event.target.matches("input, select, textarea");
    if (isField || !act(event, svg, desk)) {
      return;
    }
    event.preventDefault();
  };
  svg.addEventListener("keydown", onKey);
  tools.addEventListener("keydown", onKey);
  // a focus that a pointer gave shows neither the pen nor an outline
  const showFocus = () => {
    svg.toggleAttribute("data-keyboard", isKeyLast);
    desk.showPen(isKeyLast && document.activeElement === svg);
  };
  let isKeyLast = false;
  for (const [kind, isKey] of Object.entries({ keydown: true, pointerdown: false })) {
    document.addEventListener(
      kind,
      () => {
        isKeyLast = isKey;
        if (svg.contains(document.activeElement)) {
          showFocus();
        }
      },
      true,
    );
  }
  svg.addEventListener("focusin", (event) => {
    const part = desk.partOf(event.target);
    if (part !== null && isKeyLast) {
      desk.select(part);
    }
    showFocus();
  });
  svg.addEventListener("focusout", () => desk.showPen(false));
}

function act(event, svg, desk) {
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (event.ctrlKey || event.metaKey) {
    return actWithControl(key, event.shiftKey, desk);
  }
  const actions = {
    Escape: () => desk.escape(),
    Delete: () => desk.remove(),
    Backspace: () => desk.remove(),
    "+": () => desk.zoom(1.25),
    "=": () => desk.zoom(1.25),
    "-": () => desk.zoom(0.8),
    f: () => desk.fit(),
    n: () => desk.toggleSnapping(),
  };
  const tool = toolset.find((other) => other.key === key);
  if (tool !== undefined && !event.altKey) {
    desk.choose(tool);
    return true;
  }
  if (actions[key] && !event.altKey) {
    actions[key]();
    return true;
  }
  if (!svg.contains(event.target)) {
    return false;
  }
  const part = desk.partOf(event.target);
  if (ARROWS[key]) {
    desk.arrow(part, ARROWS[key], event.shiftKey || event.altKey);
    return true;
  }
  if (/^[\d.,]$/.test(key)) {
    const chosen = part ?? desk.selection();
    return chosen?.kind === "link" && desk.typeLength(chosen.index, key);
  }
  if (key === "Enter" || key === " ") {
    desk.click(part);
    return true;
  }
  return false;
}

function actWithControl(key, isShift, desk) {
  const action = { z: isShift ? desk.redo : desk.undo, y: desk.redo }[key];
  action?.();
  return action !== undefined;
}
