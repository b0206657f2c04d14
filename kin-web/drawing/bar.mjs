/** The tool bar. */
import { button, drawn, made } from "../../kin-studio/src/page/elements.mjs";
import { toolset } from "./toolset.mjs";

/** Pictures of the buttons, 20 pixels wide and high. */
const ICONS = {
  select: "M5 3l11 6.5-4.8 1.3 2.8 5-2 1.1-2.8-5L5.6 15z",
  link: "M5.2 13.2l7.6-7.6M3 15a2.2 2.2 0 1 0 4.4 0a2.2 2.2 0 1 0-4.4 0M12.6 5a2.2 2.2 0 1 0 4.4 0a2.2 2.2 0 1 0-4.4 0",
  pin: "M3 15.5L10 4l7 11.5zM8 12a2 2 0 1 0 4 0a2 2 0 1 0-4 0",
  ground: "M10 4l-4 8h8zM3 12h14M5 12l-2 4M9 12l-2 4M13 12l-2 4M17 12l-2 4",
  slider: "M5 5h10v6H5zM2 13.5h16M5 13.5l-2 3M10 13.5l-2 3M15 13.5l-2 3",
  drive: "M4 14a7 7 0 1 1 12-1.5M16.6 8.6l-.4 4.4-4-1.6",
  undo: "M7 4L3.5 7.5 7 11M3.5 7.5H12a4.5 4.5 0 0 1 0 9H7",
  redo: "M13 4l3.5 3.5L13 11M16.5 7.5H8a4.5 4.5 0 0 0 0 9h5",
  remove: "M4 6h12M8 6V4h4v2M6 6l.7 10h6.6L14 6",
  snapping: "M3 7h14M3 13h14M7 3v14M13 3v14",
  closer: "M10 4v12M4 10h12",
  farther: "M4 10h12",
  fit: "M4 8V4h4M12 4h4v4M16 12v4h-4M8 16H4v-4",
};

function icon(name) {
  const svg = drawn("svg", { viewBox: "0 0 20 20", "aria-hidden": "true", class: "icon" });
  drawn("path", { d: ICONS[name] }, svg);
  return svg;
}

/** A button of the bar: a picture, a word, and in its title the word and the key. */
function barButton(id, word, key, action) {
  const element = button("", { className: `tool tool-${id}`, title: `${word} (${key})`, "aria-label": word }, action);
  element.append(icon(id));
  return element;
}

/** Builds the bar. @returns {{element: HTMLElement, update(state: any): void}} */
export function createBar(desk) {
  const tools = toolset.map((tool) => {
    const element = barButton(tool.id, tool.label, tool.key.toUpperCase(), () => desk.choose(tool));
    element.append(made("span", { className: "word" }, tool.label));
    return element;
  });
  const undo = barButton("undo", "Undo", "Ctrl+Z", desk.undo);
  const redo = barButton("redo", "Redo", "Ctrl+Y", desk.redo);
  const remove = barButton("remove", "Delete", "Del", desk.remove);
  const snapping = barButton("snapping", "Snap to the grid", "N", desk.toggleSnapping);
  const closer = barButton("closer", "Enlarge", "+", () => desk.zoom(1.25));
  const farther = barButton("farther", "Reduce", "−", () => desk.zoom(0.8));
  const fit = barButton("fit", "Show all", "F", desk.fit);
  const group = (label, ...buttons) =>
    made("div", { className: "tool-group", role: "group", "aria-label": label }, ...buttons);
  const element = made(
    "div",
    { className: "tool-bar" },
    group("Tools", ...tools),
    group("Changes", undo, redo, remove),
    group("View", snapping, farther, closer, fit),
  );
  return {
    element,
    update({ tool, canUndo, canRedo, selection, isSnapping }) {
      toolset.forEach((other, index) => tools[index].setAttribute("aria-pressed", String(other === tool)));
      undo.disabled = !canUndo;
      redo.disabled = !canRedo;
      remove.disabled = selection === null;
      snapping.setAttribute("aria-pressed", String(isSnapping));
    },
  };
}
