/** The marks of a sweep: limits and special positions, by the report or found by the page, and joints of laws. */
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

/** @typedef {{x: number, kind: string, text: string, foundByPage: boolean}} Mark */

/** The marks of a sweep in the order of the variable. @returns {Mark[]} */
export function marksOf(sweep) {
  const { model, gaps } = sweep;
  const exact = sweep.given ? exactMarks(sweep) : [];
  const found = gaps.flatMap((gap) => {
    const ends = [gap.from, gap.to].filter((x) => !same(model, x, model.from) && !same(model, x, model.to));
    const unknown = ends.filter((x) => !exact.some((mark) => sameLimit(model, mark.x, x)));
    const kind = gap.lost ? "Lost" : "Limit";
    return unknown.map((x) => ({ x, kind, text: gapText(model, gap, null), foundByPage: true }));
  });
  const joints = model.drive.joints.map(({ at, order }) => {
    return { x: at, kind: "Joint", text: `${capital(ORDERS[order])} jumps at`, foundByPage: false };
  });
  return [...exact, ...found, ...joints].sort((one, other) => one.x - other.x);
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
      const name = kind.Limit ?? kind;
      return { x: intoRange(model, input), kind: name, text: reasonOf(model, name, block), foundByPage: false };
    });
  const known = marks.filter(({ kind, x }) => kind !== "FullTurn" && kind !== "Range" && x !== null);
  return known.filter(
    (mark, index) => known.findIndex(({ x, kind }) => same(model, x, mark.x) && kind === mark.kind) === index,
  );
}

/** An input of the cycle, moved by whole periods into the range of the page, or null. */
function intoRange(model, input) {
  const periods = model.period > 0 ? Math.floor((input - model.from) / model.period + SAME) : 0;
  const x = input - model.period * periods;
  return same(model, clamped(x, model.from, model.to), x) ? x : null;
}

/** The kind of a mark in words. */
export function kindText({ kind, text }) {
  return kind === "Joint" ? text : (KINDS[kind] ?? kind);
}

/** A value of the variable, with its unit. */
export function inputText(model, x, degrees, digits = 6) {
  return quantityText(same(model, x, 0) ? 0 : x, model.variable, model, degrees, digits);
}

/** The message where the mechanism stops. */
export function stopText({ model, gaps }, marks, x, degrees) {
  const mark = marks.find((one) => one.kind !== "Joint" && sameLimit(model, one.x, x));
  const position = `${model.variable.text} = ${inputText(model, mark?.x ?? x, degrees)}`;
  if (!mark) {
    return `End of the range at ${position}.`;
  }
  const gap = gaps.find(({ from, to }) => sameLimit(model, from, x) || sameLimit(model, to, x));
  const reason = mark.text || (gap ? gapText(model, gap, null) : "");
  return `${kindText(mark)} at ${position}${reason ? `: ${reason}` : ""}.`;
}
