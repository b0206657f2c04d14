/** A motion as one file: a picture that moves by itself, in any browser and without a script. */
import { change, drawn } from "./elements.mjs";
import { asFile, isDrawn, styleOf } from "./saving.mjs";

/** What changes from frame to frame. */
const MOVING = ["d", "cx", "cy", "r", "x", "y", "transform"];

/**
 * What is known of an element in one of its classes: the text of each frame, or none where it is not drawn.
 * @typedef {{still: Record<string, string>, texts: string[], moving: Record<string, string[]>}} Record
 */

/**
 * Puts frames of a picture together.
 * @param {SVGElement} svg the picture
 * @param {(() => void)[]} frames each draws a frame
 * @param {number} seconds the time from the first frame to the last
 */
export function movingPicture(svg, frames, seconds, title) {
  /** @type {Map<Element, Map<string, Record>>} */
  const seen = new Map();
  frames.forEach((draw, number) => {
    draw();
    record(svg, seen, number);
  });
  const copy = svg.cloneNode(false);
  for (const element of svg.querySelectorAll("*")) {
    for (const { still, texts, moving } of seen.get(element)?.values() ?? []) {
      // each text is an element of its own
      for (const text of new Set(texts.filter((one) => one !== undefined))) {
        const isHere = frames.map((_, number) => texts[number] === text);
        const shown = drawn(element.localName, still, copy);
        shown.textContent = text;
        move(shown, moving, isHere, `${Number(seconds.toPrecision(4))}s`);
      }
    }
  }
  return asFile(copy, svg, title);
}

/** Writes down what is drawn in a frame: by element and by class, because the classes have the styles. */
function record(svg, seen, number) {
  for (const element of svg.querySelectorAll("*")) {
    if (element.localName === "g" || element.localName === "title" || !isDrawn(element)) {
      continue;
    }
    const name = element.getAttribute("class") ?? "";
    const classes = seen.get(element) ?? new Map();
    seen.set(element, classes);
    if (!classes.has(name)) {
      classes.set(name, { still: styleOf(element), texts: [], moving: {} });
    }
    const { texts, moving } = classes.get(name);
    texts[number] = element.localName === "text" ? element.textContent : "";
    for (const attribute of MOVING.filter((one) => element.hasAttribute(one))) {
      (moving[attribute] ??= [])[number] = element.getAttribute(attribute);
    }
  }
}

/** Lets the attributes of an element run through their values, and hides it in the frames that it is not in. */
function move(shown, moving, isHere, dur) {
  const time = { dur, repeatCount: "indefinite" };
  if (isHere.includes(false)) {
    const values = isHere.map((here) => (here ? "inline" : "none")).join(";");
    drawn("animate", { attributeName: "display", calcMode: "discrete", values, ...time }, shown);
  }
  for (const [attributeName, values] of Object.entries(moving)) {
    const first = values[isHere.indexOf(true)];
    const all = isHere.reduce(
      (before, here, number) => [...before, (here && values[number]) || (before.at(-1) ?? first)],
      [],
    );
    change(shown, { [attributeName]: first });
    if (all.some((value) => value !== first)) {
      // paths of different shape cannot be blended
      const shapes = new Set(all.map((value) => value.replace(/-?[\d.]+/g, "0")));
      const calcMode = shapes.size > 1 ? "discrete" : "linear";
      drawn("animate", { attributeName, calcMode, values: all.join(";"), ...time }, shown);
    }
  }
}
