/** Position through snap over one common axis, with one cursor. */
import { axisOf, sharedPower, unitWithPower } from "./axes.mjs";
import { isBroken } from "./kinematics/drive.mjs";
import { change, drawn, line, setText, tenth } from "./elements.mjs";
import { inputText } from "./kinematics/marks.mjs";
import { numberText, steadyText, ticks, unitFactor, withUnit } from "./numbers.mjs";
import { placeOfReadout, readoutsOf } from "./readouts.mjs";
import { innerRows, rowBefore } from "./kinematics/sweep.mjs";
import { ROUNDING } from "./kinematics/tolerances.mjs";

const LEFT = 58;
const RIGHT = 16;
const HEAD = 30;
const FOOT = 34;

/**
 * @typedef {object} Plotted
 * @property {number} width
 * @property {number} height
 * @property {import("./curves.mjs").Curve[]} shown
 * @property {string[]} titles of the orders, one for each row
 * @property {boolean} degrees
 * @property {boolean} time
 * @property {[number, number]} zoom the part of the range that is seen
 * @property {import("./kinematics/sweep.mjs").Sweep} sweep
 * @property {import("./kinematics/sweep.mjs").Sweep | null} reference
 * @property {import("./kinematics/marks.mjs").Mark[]} marks
 * @property {number} speed
 * @property {boolean} brief whether values stand elsewhere, where they do not fit beside the titles
 */

export function createPlots(svg, model) {
  let rows = [];
  let now = null;
  const still = drawn("g", {}, svg);
  const moving = drawn("g", {}, svg);
  const selection = drawn("rect", { class: "selection", display: "none" }, svg);
  const across = (x) => LEFT + ((x - now.zoom[0]) / (now.zoom[1] - now.zoom[0])) * (now.width - LEFT - RIGHT);
  const valueOf = (row, curve, order) => curve.value(row, order) * curve.factor(now.degrees);

  /** Everything but the cursor. */
  function draw(plotted) {
    now = plotted;
    still.replaceChildren();
    moving.replaceChildren();
    rows = [];
    const count = now.titles.length;
    const high = (now.height - FOOT) / count;
    for (let order = 0; order < count; order += 1) {
      rows.push(drawRow(order, order * high, high));
    }
    drawAxis(now.height - FOOT);
    rows.cursor = drawn("path", { class: "cursor" }, moving);
  }

  function drawRow(order, top, high) {
    const [first] = now.shown;
    const unit = first?.unit(order, now.degrees) ?? "";
    const inTurns = order === 0 && now.degrees && first?.factor(true) !== 1;
    const axis = boundsOf(order);
    const readouts = readoutsOf(
      now.shown.map(({ text }) => text),
      now.width - LEFT - RIGHT,
      high,
      now.brief,
    );
    const upper = top + HEAD + Math.max(0, readouts.high - 6);
    const lower = top + high - 6;
    const down = (value) => lower - ((value - axis.low) / (axis.high - axis.low)) * (lower - upper);
    const marks = ticks(axis.low, axis.high, (lower - upper) / 20, inTurns);
    const power = sharedPower(marks);
    const title = drawn("text", { x: LEFT, y: top + 14, class: "plot-title" }, still);
    title.textContent = now.titles[order];
    drawn("tspan", { class: "quiet", dx: 6 }, title).textContent = unitWithPower(unit, power);
    const clip = `clip-${order}`;
    const frame = {
      x: LEFT,
      y: upper - 3,
      width: Math.max(1, now.width - LEFT - RIGHT),
      height: Math.max(1, lower - upper + 6),
    };
    drawn("rect", frame, drawn("clipPath", { id: clip }, still));
    for (const value of marks) {
      const y = tenth(down(value));
      drawn("path", { d: `M${LEFT} ${y}H${now.width - RIGHT}`, class: value === 0 ? "zero-line" : "grid-line" }, still);
      const text = drawn("text", { x: LEFT - 7, y: y + 4, class: "quiet end" }, still);
      text.textContent = numberText(value / 10 ** power, 4);
    }
    for (const x of axisTicks()) {
      drawn("path", { d: `M${tenth(across(x))} ${upper}V${tenth(lower)}`, class: "grid-line" }, still);
    }
    for (const { x, kind } of now.marks) {
      if (x >= now.zoom[0] && x <= now.zoom[1]) {
        drawn(
          "path",
          { d: `M${tenth(across(x))} ${upper}V${tenth(lower)}`, class: kind === "Joint" ? "joint-line" : "limit-line" },
          still,
        );
      }
    }
    const curves = drawn("g", { "clip-path": `url(#${clip})` }, still);
    const limit = 4 * (lower - upper);
    const held = (value) => Math.max(lower - limit, Math.min(upper + limit, down(value)));
    if (now.reference) {
      curvesOf(now.reference, order, held, curves, " reference");
    }
    curvesOf(now.sweep, order, held, curves, "");
    if (order === 0) {
      drawPeaks(held);
    }
    sayBeyond(axis, unit, upper, lower);
    const dot = ({ colour }) => drawn("circle", { r: 3.2, class: `plot-dot c${colour}` }, moving);
    const [dots, dotsBefore] = [now.shown.map(dot), now.shown.map(dot)];
    const texts = drawReadouts(readouts, top);
    const scales = now.shown.map((curve) => scaleOf(curve, order));
    return {
      upper,
      lower,
      down: held,
      dots,
      dotsBefore,
      texts,
      wide: readouts.wide,
      scales,
      sizes: now.shown.map((curve) => naturalSize(curve, order)),
      visible: (y) => y >= upper - 3 && y <= lower + 3,
    };
  }

  /** The texts of the values at the cursor, still empty. */
  function drawReadouts(readouts, top) {
    const swatchOf = ({ colour }, attributes, parent) => {
      drawn("tspan", { class: `swatch c${colour}`, ...attributes }, parent).textContent = "●";
    };
    const beside =
      readouts.columns === 0
        ? drawn("text", { x: now.width - RIGHT, y: top + 14, class: "plot-values end" }, moving)
        : null;
    return now.shown.slice(0, readouts.count).map((curve, index) => {
      const [x, y] = beside ? [0, 0] : placeOfReadout(readouts, index);
      const parent =
        beside ?? drawn("text", { x: tenth(LEFT + x), y: top + 16 + y, class: "plot-values small" }, moving);
      swatchOf(curve, beside && index > 0 ? { dx: 7 } : {}, parent);
      return { element: drawn("tspan", { dx: 3 }, parent), name: readouts.named ? `${curve.text} ` : "" };
    });
  }

  /** Says how far the values go that lie beyond the axis. */
  function sayBeyond({ above, below }, unit, upper, lower) {
    const say = (text, y) => {
      const at = { x: now.width - RIGHT - 4, y: tenth(y), class: "quiet end halo beyond" };
      drawn("text", at, still).textContent = text;
    };
    const text = (value) => withUnit(numberText(value, 3), unit);
    if (above !== null) {
      say(`↑ up to ${text(above)}`, upper + 10);
    }
    if (below !== null) {
      say(`↓ down to ${text(below)}`, lower - 3);
    }
  }

  /** The size of a derivative that changes as slowly as the whole motion does. */
  const naturalSize = (curve, order) =>
    curve.scale(now.sweep, 0) *
    curve.factor(now.degrees) *
    ((2 * Math.PI * Math.abs(model.drive.overTime ? 1 : now.speed)) / model.width) ** order;

  const scaleOf = (curve, order) => curve.scale(now.sweep, order) * curve.factor(now.degrees);

  /** Marks the known peaks, and labels the largest with its value. */
  function drawPeaks(down) {
    const seen = now.shown.filter(({ peak }) => peak && peak.at >= now.zoom[0] && peak.at <= now.zoom[1]);
    const largest = seen.reduce((best, one) => (best && best.peak.value >= one.peak.value ? best : one), null);
    for (const curve of seen) {
      const [x, y] = [across(curve.peak.at), down(curve.peak.value * curve.factor(now.degrees))];
      const ring = drawn("circle", { cx: tenth(x), cy: tenth(y), r: 4.4, class: `plot-peak c${curve.colour}` }, still);
      const text = withUnit(numberText(curve.peak.value), curve.unit(0, now.degrees));
      drawn("title", {}, ring).textContent =
        `${curve.text}: ${text} at ${inputText(model, curve.peak.at, now.degrees)}`;
      if (curve === largest) {
        const right = x < 0.5 * (LEFT + now.width - RIGHT);
        const at = { x: tenth(x + (right ? 9 : -9)), y: tenth(y + 1), class: `plot-values halo${right ? "" : " end"}` };
        drawn("text", at, still).textContent = text;
      }
    }
  }

  function curvesOf(sweep, order, down, parent, style) {
    for (const curve of now.shown) {
      const { colour, dashed } = curve;
      for (const span of sweep.spans) {
        // where a derivative jumps, the curve has a gap
        const pieces = [[]];
        span.rows.forEach((row, index) => {
          if (index > 0 && isBroken(model.drive, span.rows[index - 1], row, order + curve.above)) {
            pieces.push([]);
          }
          const value = valueOf(row, curve, order);
          if (Number.isNaN(value)) {
            pieces.push([]);
          } else {
            pieces[pieces.length - 1].push([across(row.x), down(value)]);
          }
        });
        drawn(
          "path",
          {
            d: pieces.map((points) => line(points)).join(""),
            class: `curve c${colour}${dashed ? " dashed" : ""}${style}`,
          },
          parent,
        );
      }
    }
  }

  /** The axis of a row, for the part of the range that is seen. */
  function boundsOf(order) {
    const isSeen = ({ x }) => x >= now.zoom[0] && x <= now.zoom[1];
    const rows = [now.sweep, now.reference].flatMap((sweep) => (sweep ? innerRows(sweep).filter(isSeen) : []));
    const values = now.shown.flatMap((curve) => rows.map((row) => valueOf(row, curve, order)));
    return axisOf(values, Math.max(0, ...now.shown.map((curve) => naturalSize(curve, order))));
  }

  function axisTicks() {
    const count = (now.width - LEFT - RIGHT) / 70;
    if (now.time) {
      const [from, to] = now.zoom.map((x) => (x - model.from) / now.speed);
      return ticks(Math.min(from, to), Math.max(from, to), count).map((time) => model.from + time * now.speed);
    }
    const factor = unitFactor(model.variable.dimension, now.degrees);
    return ticks(now.zoom[0] * factor, now.zoom[1] * factor, count, factor !== 1).map((x) => x / factor);
  }

  function drawAxis(y) {
    drawn("path", { d: `M${LEFT} ${y}H${now.width - RIGHT}`, class: "axis-line" }, still);
    for (const x of axisTicks()) {
      const at = across(x);
      const ofVariable = model.drive.overTime ? numberText(x, 4) : inputText(model, x, now.degrees, 4);
      const text = now.time ? numberText((x - model.from) / now.speed, 4) : ofVariable;
      const middle = Math.min(at, now.width - 4 * text.length);
      drawn("text", { x: tenth(middle), y: y + 14, class: "quiet middle" }, still).textContent = text;
      drawn("path", { d: `M${tenth(at)} ${y}v4`, class: "axis-line" }, still);
    }
    const label = drawn("text", { x: now.width - RIGHT, y: y + 29, class: "quiet end" }, still);
    label.textContent = now.time || model.drive.overTime ? withUnit("time,", model.units.time) : model.variable.text;
  }

  /** The cursor and the values at it. */
  function point(row) {
    if (now === null) {
      return;
    }
    const x = across(row.x);
    const inside = x >= LEFT - 0.5 && x <= now.width - RIGHT + 0.5;
    change(rows.cursor, {
      d: rows.map(({ upper, lower }) => `M${tenth(x)} ${tenth(upper)}V${tenth(lower)}`).join(""),
      display: inside ? "inline" : "none",
    });
    // at a joint there are two values, before it and behind it
    const before = rowBefore(now.sweep, row);
    rows.forEach(({ down, dots, dotsBefore, texts, wide, scales, sizes, visible }, order) => {
      now.shown.forEach((curve, index) => {
        const jumps = before !== null && isBroken(model.drive, before, row, order + curve.above);
        const put = (element, shownRow, shown) => {
          const value = valueOf(shownRow, curve, order);
          const y = Number.isNaN(value) ? Infinity : down(value);
          const isSeen = shown && inside && visible(y);
          change(element, { cx: tenth(x), ...(isSeen ? { cy: tenth(y) } : {}), display: isSeen ? "inline" : "none" });
        };
        put(dots[index], row, true);
        put(dotsBefore[index], before ?? row, jumps);
        if (texts[index]) {
          const rounded = (value) => (Math.abs(value) < ROUNDING * sizes[index] ? 0 : value);
          const text = (shownRow) =>
            curve.isUnbounded(now.sweep, shownRow, order)
              ? "unbounded"
              : steadyText(rounded(valueOf(shownRow, curve, order)), scales[index]);
          const both = jumps && wide;
          setText(texts[index].element, `${texts[index].name}${both ? `${text(before)} → ` : ""}${text(row)}`);
        }
      });
    });
  }

  const inputAt = (x) => {
    const part = Math.min(1, Math.max(0, (x - LEFT) / (now.width - LEFT - RIGHT)));
    return now.zoom[0] + part * (now.zoom[1] - now.zoom[0]);
  };

  return {
    draw,
    point,
    inputAt,
    /** Marks a part that is being chosen; none for null. */
    select(part) {
      if (part === null) {
        change(selection, { display: "none" });
        return;
      }
      const [from, to] = part.map((x) => across(x));
      const box = {
        x: Math.min(from, to),
        width: Math.abs(to - from),
        y: HEAD - 6,
        height: now.height - FOOT - HEAD + 6,
      };
      change(selection, { ...box, display: "inline" });
    },
  };
}
