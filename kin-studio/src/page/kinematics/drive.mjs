/** The motion of the inputs over the variable: power series, piece by piece. */
import { lastIndex } from "./search.mjs";
import { SAME } from "./tolerances.mjs";

/**
 * A value of the variable at which derivatives jump, from an order on, with the index of the piece that begins there.
 * @typedef {{at: number, order: number, piece: number}} Joint
 */

/** The drive of a report, with the pieces that begin at joints. */
export function driveOf({ drive }) {
  const pieces = drive.pieces;
  const joints = drive.joints.map(({ at, order }) => ({
    at,
    order,
    piece: pieces.findIndex(({ from }) => from === at),
  }));
  return { overTime: drive.variable === "time", pieces, joints };
}

/** The index of the piece to which a value of the variable belongs. Where two pieces meet, it is the later piece. */
export function pieceAt({ pieces }, x) {
  return lastIndex(pieces, x, ({ from }) => from);
}

/**
 * An input, by its index, with its derivatives by time, by the series of one piece, which goes on beyond its ends.
 * @param {number} speed the change of the variable for each unit of time
 */
export function motionOf({ pieces }, input, x, piece, speed, orders) {
  const { at, inputs } = pieces[piece];
  const terms = inputs[input];
  const motion = [];
  let rate = 1;
  for (let order = 0; order <= orders; order += 1) {
    let sum = 0;
    for (let power = terms.length - 1; power >= order; power -= 1) {
      let factor = 1;
      for (let below = 0; below < order; below += 1) {
        factor *= power - below;
      }
      sum = sum * (x - at) + factor * terms[power];
    }
    motion.push(rate * sum);
    rate *= speed;
  }
  return motion;
}

/** The value of an input, by its index, at a sample. */
export function inputAt(drive, input, { x, piece }) {
  return motionOf(drive, input, x, piece, 1, 0)[0];
}

/**
 * Samples from the beginning of the range to its end: at parts of the range, some in each short piece, and on both
 * sides of every joint.
 * @param {number} least the parts of each piece
 * @returns {{x: number, piece: number}[]}
 */
export function samplesOf(drive, from, to, parts, least) {
  const width = to - from;
  const values = [];
  for (let index = 0; index <= parts; index += 1) {
    values.push(from + (width * index) / parts);
  }
  for (const piece of drive.pieces) {
    const length = piece.to - piece.from;
    for (let index = 1; index < least && length * parts < least * width; index += 1) {
      values.push(piece.from + (length * index) / least);
    }
  }
  const apart = (x) => drive.joints.every(({ at }) => Math.abs(x - at) > SAME * width);
  const all = values.filter(apart).map((x) => ({ x, piece: pieceAt(drive, x) }));
  for (const { at, piece } of drive.joints) {
    all.push({ x: at, piece: piece - 1 }, { x: at, piece });
  }
  all.sort((one, other) => one.x - other.x || one.piece - other.piece);
  return all.filter(
    ({ x, piece }, index) => index === 0 || x - all[index - 1].x > SAME * width || piece !== all[index - 1].piece,
  );
}

/** Whether a derivative jumps between two samples, so that no line leads from one to the other. */
export function isBroken(drive, one, other, order) {
  const [low, high] = [Math.min(one.piece, other.piece), Math.max(one.piece, other.piece)];
  return low < high && drive.joints.some((joint) => low < joint.piece && joint.piece <= high && joint.order <= order);
}
