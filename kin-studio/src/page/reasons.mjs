/** Why a mechanism does not close somewhere, in words, and by how much. */
import { blockText } from "./kinematics/model.mjs";

/** The checks of links that reach or do not, whose margin is a length. */
const REACHES = [
  "reach of two circles",
  "reach of a circle and a line",
  "reach of a circle and an axis",
  "reach of a link",
  "reach of an offset slide",
];
/** The checks whose margin is the square of a length. */
const SQUARES = ["sqrt", "positive square"];
/** The check of Newton's method, whose margin is a residual. */
const SEARCH = "root of coupled equations";

/** The length that is missing, or NaN where the margin of the check is none. */
export function shortfallOf({ check, margin }) {
  if (!(margin < 0) || !Number.isFinite(margin)) {
    return NaN;
  }
  return REACHES.includes(check) ? -margin : SQUARES.includes(check) ? Math.sqrt(-margin) : NaN;
}

/**
 * The reason for a gap, in words.
 * @param {((length: number) => string) | null} amount a length in words; null to leave it out
 */
export function gapText(model, gap, amount) {
  const { check, block, lost } = gap;
  const unknowns = block ? blockText(model, block) : "";
  const of = unknowns ? ` (${unknowns})` : "";
  if (lost) {
    return `the assembly is lost here${check ? `: ${check}${of}` : ""}`;
  }
  if (check === SEARCH) {
    return `no position is found${unknowns ? ` for ${unknowns}` : ""}`;
  }
  const short = shortfallOf(gap);
  const meets = unknowns && Number.isFinite(short) ? `the links of ${unknowns} do not meet` : `${check}${of}`;
  return `${meets}${amount && Number.isFinite(short) ? `: short by ${amount(short)}` : ""}`;
}
