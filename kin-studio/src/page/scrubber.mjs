/** The range of the variable: where it closes, limits, dead points, poor transmission, and what is out of reach. */
import { change, drawn, line, setText, tenth } from "./elements.mjs";
import { inputText, kindText } from "./kinematics/marks.mjs";
import { sameLimit } from "./kinematics/tolerances.mjs";
import { ticks, unitFactor } from "./numbers.mjs";
import { shortfallOf } from "./reasons.mjs";

/** The classes of marks that are no limits. */
const MARK_CLASSES = { ChangePoint: "change-mark", Joint: "joint-mark" };
const SIDE = 22;
const TRACK = 40;
const THICK = 12;

export function createScrubber(svg, model) {
  let width = 0;
  const still = drawn("g", {}, svg);
  const handle = drawn("g", { class: "handle" }, svg);
  drawn("path", { d: `M0 ${TRACK - 12}V${TRACK + 12}`, class: "handle-line" }, handle);
  drawn("circle", { cx: 0, cy: TRACK, r: 9, class: "handle-knob" }, handle);
  const across = (x) => SIDE + ((x - model.from) / model.width) * (width - 2 * SIDE);

  return {
    draw({ width: whole, sweep, marks, poor, degrees, amount }) {
      width = whole;
      still.replaceChildren();
      for (const gap of sweep.gaps) {
        const { from, to, lost } = gap;
        const short = shortfallOf(gap);
        const [left, right] = [across(from), across(to)];
        const title = drawn(
          "title",
          {},
          drawn(
            "rect",
            { x: left, width: Math.max(1, right - left), y: TRACK - THICK / 2, height: THICK, class: "gap" },
            still,
          ),
        );
        const known = marks.some(
          (mark) => !mark.foundByPage && (sameLimit(model, mark.x, from) || sameLimit(model, mark.x, to)),
        );
        const text =
          lost && !known
            ? "assembly lost"
            : Number.isFinite(short)
              ? `out of reach by ${amount(short)}`
              : "does not close";
        title.textContent = text;
        let d = "";
        for (let x = left + 3; x < right - 2; x += 7) {
          d += line([
            [x, TRACK + 5],
            [x + 5, TRACK - 5],
          ]);
        }
        drawn("path", { d, class: "gap-hatch" }, still);
        const label =
          right - left > 6.2 * text.length
            ? text
            : right - left > 80 && Number.isFinite(short) && !lost
              ? `short by ${amount(short)}`
              : "";
        drawn("text", { x: tenth(0.5 * (left + right)), y: TRACK - 13, class: "quiet middle" }, still).textContent =
          label;
      }
      for (const { from, to } of sweep.spans) {
        drawn(
          "rect",
          {
            x: across(from),
            width: Math.max(1, across(to) - across(from)),
            y: TRACK - THICK / 2,
            height: THICK,
            class: "closes",
          },
          still,
        );
      }
      for (const [from, to] of poor) {
        const band = {
          x: across(from),
          width: Math.max(1, across(to) - across(from)),
          y: TRACK - THICK / 2,
          height: THICK,
          class: "poor",
        };
        drawn("title", {}, drawn("rect", band, still)).textContent = "transmission angle below 40°";
      }
      const factor = unitFactor(model.variable.dimension, degrees);
      for (const tick of ticks(model.from * factor, model.to * factor, (width - 2 * SIDE) / 90, factor !== 1)) {
        const x = across(tick / factor);
        drawn("path", { d: `M${tenth(x)} ${TRACK + 8}v4`, class: "axis-line" }, still);
        const text = inputText(model, tick / factor, degrees, 4);
        const at = { x: tenth(withinWidth(x, text)), y: TRACK + 25, class: "quiet middle" };
        drawn("text", at, still).textContent = text;
      }
      drawMarks(still, marks, degrees);
    },
    point(x, text) {
      change(handle, { transform: `translate(${tenth(across(x))} 0)` });
      const factor = unitFactor(model.variable.dimension, true);
      change(svg, { "aria-valuenow": Math.round(x * factor * 1000) / 1000, "aria-valuetext": text });
    },
    /** The variable at a coordinate of the picture. */
    inputAt: (x) => model.from + Math.min(1, Math.max(0, (x - SIDE) / (width - 2 * SIDE))) * model.width,
  };

  /** The middle of a text, as near to a coordinate as the text can stand without being cut. */
  function withinWidth(x, text) {
    const half = 3.6 * text.length;
    return Math.min(width - half - 2, Math.max(half + 2, x));
  }

  function drawMarks(parent, marks, degrees) {
    let last = -Infinity;
    for (const mark of marks) {
      const x = across(mark.x);
      const tick = drawn(
        "path",
        { d: `M${tenth(x)} ${TRACK - 12}V${TRACK + 10}`, class: MARK_CLASSES[mark.kind] ?? "limit-mark" },
        parent,
      );
      const text = `${kindText(mark)} ${inputText(model, mark.x, degrees)}`;
      drawn("title", {}, tick).textContent =
        mark.kind === "Joint"
          ? `${text}, where two pieces of a law meet`
          : `${text}${mark.text ? `: ${mark.text}` : ""}${mark.foundByPage ? " (found by the page)" : ""}`;
      const half = 3.6 * text.length;
      const at = withinWidth(x, text);
      if (at - half > last + 8) {
        last = at + half;
        const label = drawn("text", { x: tenth(at), y: 14, class: "mark-text middle" }, parent);
        setText(label, text);
      }
    }
  }
}
