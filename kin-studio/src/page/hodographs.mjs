/** The path that the force in each joint takes over the motion, as a vector: a polar diagram for each. */
import { change, drawn, line, tenth } from "./elements.mjs";
import { angleOf } from "./kinematics/anatomy.mjs";
import { forcesAt } from "./kinematics/forces.mjs";
import { allRows } from "./kinematics/sweep.mjs";
import { numberText, ticks } from "./numbers.mjs";
import { arrowHead } from "./notation.mjs";

const HEAD = 34;
const GAP = 14;

/**
 * @typedef {object} Hodographs
 * @property {number} width
 * @property {number} top
 * @property {number} height
 * @property {import("./curves.mjs").Curve[]} shown those of joints
 * @property {boolean} turning whether the axes are those of the body on which the force acts
 * @property {import("./kinematics/sweep.mjs").Sweep} sweep
 */

export function createHodographs(svg, model) {
  const still = drawn("g", { class: "hodographs" }, svg);
  const moving = drawn("g", {}, svg);
  let cells = [];

  /** A force at a row, y downwards; null if it is not known. */
  const vectorOf = (row, joint, turning) => {
    const force = forcesAt(model, row).forces[joint];
    const { on } = model.report.forces.joints[joint];
    const angle = turning && on !== null ? angleOf(model, row.pose, on) : 0;
    const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
    return force && [cosine * force[0] + sine * force[1], sine * force[0] - cosine * force[1]];
  };

  /** @param {Hodographs} hodographs */
  function draw({ width, top, height, shown, turning, sweep }) {
    still.replaceChildren();
    moving.replaceChildren();
    cells = [];
    if (shown.length === 0 || height < 80) {
      return;
    }
    const title = drawn("text", { x: 8, y: top + 14, class: "plot-title" }, still);
    title.textContent = "Direction";
    drawn("tspan", { class: "quiet", dx: 6 }, title).textContent = turning
      ? "in the axes of the body"
      : "in fixed axes";
    const columns = columnsOf(shown.length, width, height);
    const rows = Math.ceil(shown.length / columns);
    const [wide, high] = [(width - 8) / columns, (height - 22) / rows];
    const radius = Math.max(8, 0.5 * Math.min(wide - GAP, high - HEAD));
    const sweepRows = allRows(sweep);
    shown.forEach((curve, index) => {
      const paths = sweepRows.map((row) => vectorOf(row, curve.joint, turning));
      const size = paths.reduce((most, force) => Math.max(most, force ? Math.hypot(...force) : 0), 0);
      const centre = [8 + wide * ((index % columns) + 0.5), top + 22 + high * Math.floor(index / columns) + HEAD - 4];
      centre[1] += radius;
      const scale = size > 0 ? radius / size : 0;
      const onPage = (force) => [centre[0] + scale * force[0], centre[1] + scale * force[1]];
      const name = drawn("text", { x: tenth(centre[0]), y: tenth(centre[1] - radius - 18), class: "middle" }, still);
      const swatch = drawn("tspan", { class: `swatch c${curve.colour}` }, name);
      swatch.textContent = "●";
      drawn("tspan", { dx: 3 }, name).textContent = fitting(curve.text, wide);
      const body = { x: tenth(centre[0]), y: tenth(centre[1] - radius - 5), class: "quiet middle" };
      drawn("text", body, still).textContent = fitting(curve.documentation.split(",")[0], wide);
      // circles at round values, and the axes
      const rings = ticks(0, size, 3).filter((value) => value > 0);
      for (const ring of rings) {
        const circle = { cx: tenth(centre[0]), cy: tenth(centre[1]), r: tenth(ring * scale), class: "grid-line" };
        drawn("circle", circle, still);
      }
      const axes = `M${tenth(centre[0] - radius)} ${tenth(centre[1])}h${tenth(2 * radius)}M${tenth(centre[0])} ${tenth(
        centre[1] - radius,
      )}v${tenth(2 * radius)}`;
      drawn("path", { d: axes, class: "grid-line" }, still);
      let d = "";
      let run = [];
      const end = () => {
        d += line(run);
        run = [];
      };
      paths.forEach((force) => (force ? run.push(onPage(force)) : end()));
      end();
      drawn("path", { d, class: `curve c${curve.colour}` }, still);
      const last = rings[rings.length - 1];
      if (last !== undefined) {
        // on the side where the path is not, and within the cell
        const side = paths.reduce((sum, force) => sum + (force?.[0] ?? 0), 0) <= 0 ? 1 : -1;
        const text = `${numberText(last, 3)} N`;
        const out = Math.min(0.71 * last * scale, 0.5 * wide - 7.5 * text.length - 3);
        const at = { x: tenth(centre[0] + side * out), y: tenth(centre[1] + 0.71 * last * scale + 11) };
        drawn("text", { ...at, class: `quiet halo${side > 0 ? "" : " end"}` }, still).textContent = text;
      }
      const arrow = drawn("path", { class: "arrow force" }, moving);
      const head = drawn("path", { class: "arrow-head force" }, moving);
      cells.push({ centre, onPage, arrow, head, joint: curve.joint, turning });
    });
  }

  function point(row) {
    for (const { centre, onPage, arrow, head, joint, turning } of cells) {
      const force = row && vectorOf(row, joint, turning);
      const tip = force && onPage(force);
      const isSeen = Boolean(tip) && Math.hypot(tip[0] - centre[0], tip[1] - centre[1]) > 5;
      for (const element of [arrow, head]) {
        change(element, { display: isSeen ? "inline" : "none" });
      }
      if (isSeen) {
        const back = shortened(centre, tip, 4);
        change(arrow, { d: line([centre, back]) });
        change(head, { d: arrowHead(back, centre) });
      }
    }
  }

  return { draw, point };
}

/** A text that is cut where it is wider than a cell. */
function fitting(text, wide) {
  const most = Math.max(4, Math.floor(wide / 7) - 3);
  return text.length > most ? `${text.slice(0, most - 1)}…` : text;
}

/** The end of a line, a little nearer to its beginning. */
function shortened(from, to, by) {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  return [0, 1].map((axis) => to[axis] - ((to[axis] - from[axis]) / length) * by);
}

/** The number of columns with which cells are largest. */
function columnsOf(count, width, height) {
  const sizes = [...Array(count).keys()].map((index) => {
    const columns = index + 1;
    return Math.min(width / columns - GAP, (height - 22) / Math.ceil(count / columns) - HEAD);
  });
  return 1 + sizes.reduce((best, size, index) => (size > sizes[best] + 1e-9 ? index : best), 0);
}
