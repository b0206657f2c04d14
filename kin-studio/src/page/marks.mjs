/** The ends of what closes, and the places within it that matter: exact ones of the report, or the page's own; and the joints of laws. */
import { numberText, ORDERS, unitFactor, unitText, withUnit } from "./numbers.mjs";
import { blockText } from "./model.mjs";
import { gapText } from "./reasons.mjs";

const KINDS = {
  Limit: "Limit",
  TurningPoint: "Limit",
  ChangePoint: "Change point",
  End: "End of the domain",
  Pole: "Pole",
  Range: "End of the range",
  Lost: "Lost",
};

/**
 * @param {import("./model.mjs").Model} model
 * @param {import("./sweep.mjs").Sweep} sweep
 * @param {number} assembly
 * @param {boolean} given whether the design is that of the report
 * @returns {import("./sweep.mjs").Mark[]}
 */
export function marksOf(model, sweep, assembly, given) {
  const exact = given ? exactMarks(model, assembly) : [];
  const marks = [...exact];
  for (const gap of sweep.gaps) {
    for (const x of [gap.from, gap.to]) {
      const inside = x > model.from + 1e-9 && x < model.to - 1e-9;
      if (inside && !exact.some((mark) => isThere(model, mark, x))) {
        marks.push({ x, kind: gap.lost ? "Lost" : "Limit", text: gapText(model, gap, null), own: true });
      }
    }
  }
  for (const { at, order } of model.drive.joints) {
    marks.push({ x: at, kind: "Joint", text: `${ORDERS[order][0].toUpperCase()}${ORDERS[order].slice(1)} jumps at`, own: false });
  }
  return marks.sort((one, other) => one.x - other.x);
}

/** Why a branch ends, with the names as they are printed. */
function reasonOf(model, kind, block) {
  const words = { TurningPoint: "limit position of", ChangePoint: "branches cross in", Pole: "pole of", End: "end of a domain or range of" };
  return words[kind] && block ? `${words[kind]} ${blockText(model, block)}` : "";
}

/** Whether a mark is at a place, up to the accuracy with which the page finds ends itself. */
function isThere(model, mark, x) {
  return Math.abs(mark.x - x) < 1e-5 * (model.to - model.from);
}

function exactMarks(model, assembly) {
  const marks = [];
  const branches = model.report.cycle?.branches ?? [];
  for (const branch of branches) {
    if (branch.assembly !== assembly) {
      continue;
    }
    for (const end of branch.ends) {
      const x = intoRange(model, end.input);
      const kind = end.kind.Limit ?? end.kind;
      const known = kind === "FullTurn" || kind === "Range" || x === null;
      if (!known && !marks.some((mark) => Math.abs(mark.x - x) < 1e-9 && mark.kind === kind)) {
        marks.push({ x, kind, text: reasonOf(model, kind, end.block), own: false });
      }
    }
  }
  return marks;
}

/** An input of the cycle as one of the page's range, or null. */
function intoRange(model, input) {
  let x = input;
  if (model.period > 0) {
    x -= model.period * Math.floor((x - model.from) / model.period + 1e-12);
  }
  return x >= model.from - 1e-9 && x <= model.to + 1e-9 ? x : null;
}

/**
 * What a mark is, in words.
 * @param {import("./sweep.mjs").Mark} mark
 */
export function kindText({ kind, text }) {
  return kind === "Joint" ? text : (KINDS[kind] ?? kind);
}

/**
 * A value of the variable, with its unit.
 * @param {import("./model.mjs").Model} model
 * @param {number} x
 * @param {boolean} degrees
 * @param {number} digits
 */
export function inputText(model, x, degrees, digits = 6) {
  const { dimension } = model.variable;
  return withUnit(numberText(x * unitFactor(dimension, degrees), digits), unitText(dimension, 0, model.units, degrees));
}

/**
 * What is said where the mechanism stops.
 * @param {import("./model.mjs").Model} model
 * @param {import("./sweep.mjs").Mark[]} marks
 * @param {import("./sweep.mjs").Gap[]} gaps
 * @param {number} x
 * @param {boolean} degrees
 */
export function stopText(model, marks, gaps, x, degrees) {
  const mark = marks.find((one) => one.kind !== "Joint" && isThere(model, one, x));
  const place = `${model.variable.text} = ${inputText(model, mark?.x ?? x, degrees)}`;
  if (!mark) {
    return `End of the range at ${place}.`;
  }
  const gap = gaps.find(({ from, to }) => Math.abs(from - x) < 1e-6 || Math.abs(to - x) < 1e-6);
  const reason = mark.text || (gap ? gapText(model, gap, null) : "");
  return `${kindText(mark)} at ${place}${reason ? `: ${reason}` : ""}.`;
}
