/** The ends of what closes and the places in it that matter, of the report or the page's own, and joints of laws. */
import { capital, ORDERS, quantityText } from "../numbers.mjs";
import { gapText } from "../reasons.mjs";
import { blockText } from "./model.mjs";
import { clamped } from "./search.mjs";
import { SAME, same, sameLimit } from "./tolerances.mjs";

const KINDS = {
  Limit: "Limit",
  TurningPoint: "Limit",
  ChangePoint: "Change point",
  End: "End of the domain",
  Pole: "Pole",
  Range: "End of the range",
  Lost: "Lost",
};

/** @typedef {{x: number, kind: string, text: string, own: boolean}} Mark own: found by the page */

/** The marks of a sweep in the order of the variable. @returns {Mark[]} */
export function marksOf(sweep) {
  const { model, gaps } = sweep;
  const exact = sweep.given ? exactMarks(sweep) : [];
  const own = gaps.flatMap((gap) => {
    const ends = [gap.from, gap.to].filter((x) => !same(model, x, model.from) && !same(model, x, model.to));
    const unknown = ends.filter((x) => !exact.some((mark) => sameLimit(model, mark.x, x)));
    return unknown.map((x) => ({ x, kind: gap.lost ? "Lost" : "Limit", text: gapText(model, gap, null), own: true }));
  });
  const joints = model.drive.joints.map(({ at, order }) => {
    return { x: at, kind: "Joint", text: `${capital(ORDERS[order])} jumps at`, own: false };
  });
  return [...exact, ...own, ...joints].sort((one, other) => one.x - other.x);
}

/** Why a branch ends, with the names as they are printed. */
function reasonOf(model, kind, block) {
  const words = {
    TurningPoint: "limit position of",
    ChangePoint: "branches cross in",
    Pole: "pole of",
    End: "end of a domain or range of",
  };
  return words[kind] && block ? `${words[kind]} ${blockText(model, block)}` : "";
}

/** The ends of the report's branches of the assembly. */
function exactMarks({ model, assembly }) {
  const { cycle, assemblies } = model.report;
  const branches = (cycle?.branches ?? []).filter((branch) => assemblies[branch.assembly] === assembly);
  const marks = branches
    .flatMap(({ ends }) => ends)
    .map(({ kind, input, block }) => {
      const own = kind.Limit ?? kind;
      return { x: intoRange(model, input), kind: own, text: reasonOf(model, own, block), own: false };
    });
  const known = marks.filter(({ kind, x }) => kind !== "FullTurn" && kind !== "Range" && x !== null);
  return known.filter(
    (mark, index) => known.findIndex(({ x, kind }) => same(model, x, mark.x) && kind === mark.kind) === index,
  );
}

/** An input of the cycle as one of the page's range, or null. */
function intoRange(model, input) {
  const turns = model.period > 0 ? Math.floor((input - model.from) / model.period + SAME) : 0;
  const x = input - model.period * turns;
  return same(model, clamped(x, model.from, model.to), x) ? x : null;
}

/** What a mark is, in words. */
export function kindText({ kind, text }) {
  return kind === "Joint" ? text : (KINDS[kind] ?? kind);
}

/** A value of the variable, with its unit. */
export function inputText(model, x, degrees, digits = 6) {
  return quantityText(x, model.variable, model, degrees, digits);
}

/** What is said where the mechanism stops. */
export function stopText({ model, gaps }, marks, x, degrees) {
  const mark = marks.find((one) => one.kind !== "Joint" && sameLimit(model, one.x, x));
  const place = `${model.variable.text} = ${inputText(model, mark?.x ?? x, degrees)}`;
  if (!mark) {
    return `End of the range at ${place}.`;
  }
  const gap = gaps.find(({ from, to }) => sameLimit(model, from, x) || sameLimit(model, to, x));
  const reason = mark.text || (gap ? gapText(model, gap, null) : "");
  return `${kindText(mark)} at ${place}${reason ? `: ${reason}` : ""}.`;
}
