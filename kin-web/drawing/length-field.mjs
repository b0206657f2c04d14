/** A field at a link in the picture, into which its length is typed. */
import { within } from "../../kin-studio/src/page/gesture.mjs";
import { made } from "../../kin-studio/src/page/elements.mjs";
import { lengthOf, sidesOf } from "./model/lengths.mjs";
import { fromSegment } from "./model/picking.mjs";
import { at } from "./model/sketch.mjs";
import { isLength, numberIn, typed } from "./typing.mjs";

/** @returns {(link: number, first: string) => boolean} opens the field of a link with the first letter that is typed */
export function createLengthField(svg, desk) {
  const input = made("input", {
    type: "text",
    inputMode: "decimal",
    autocomplete: "off",
    className: "at-link",
    hidden: true,
  });
  let side = null;
  svg.after(input);

  /** The sides of a link, with their ends in the picture. */
  function sidesIn(link) {
    const sketch = desk.sketch();
    return sidesOf(sketch.links[link]).map(([from, to]) => ({
      from,
      to,
      ends: [from, to].map((point) => desk.toPicture(at(sketch, point))),
    }));
  }

  function open(link, { from, to, ends }, text) {
    const sketch = desk.sketch();
    const [left, top] = [0, 1].map((axis) => 0.5 * (ends[0][axis] + ends[1][axis]));
    const box = svg.getBoundingClientRect();
    input.style.left = `${box.left + left}px`;
    input.style.top = `${box.top + top}px`;
    const length = typed(lengthOf(sketch, from, to));
    side = { link, from, to, length };
    input.setAttribute("aria-label", `Length ${sketch.points[from].name}–${sketch.points[to].name}`);
    input.value = text || length;
    input.hidden = false;
    input.focus();
    input.setSelectionRange(text.length, input.value.length);
  }

  /** Gives the link its length, if one was typed. */
  function close() {
    if (side === null) {
      return;
    }
    const { link, from, to, length } = side;
    side = null;
    const number = numberIn(input.value);
    input.hidden = true;
    if (input.value !== length && isLength(number)) {
      desk.setLength(link, from, to, number);
    }
  }

  /** Closes the field by a key, which hands the focus back to the link. */
  function finish() {
    const part = { kind: "link", index: side.link };
    close();
    desk.show(part);
  }

  input.addEventListener("keydown", (event) => {
    if (event.key === "Escape") {
      input.value = side.length;
    }
    if (event.key === "Escape" || event.key === "Enter") {
      event.preventDefault();
      finish();
    }
  });
  input.addEventListener("blur", close);
  svg.addEventListener("dblclick", (event) => {
    const place = within(svg, event);
    const part = desk.tool().id === "select" ? desk.pick(place) : null;
    if (part?.kind === "link") {
      const far = (one) => fromSegment(place, ...one.ends).distance;
      const sides = sidesIn(part.index).sort((one, other) => far(one) - far(other));
      sides.slice(0, 1).forEach((nearest) => open(part.index, nearest, ""));
    }
  });

  return (link, first) => {
    const [side] = sidesIn(link);
    if (side !== undefined) {
      open(link, side, first);
    }
    return side !== undefined;
  };
}
