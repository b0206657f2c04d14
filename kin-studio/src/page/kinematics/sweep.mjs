/** The whole range of a design in one assembly: its poses, where it closes, and where it does not. */
import { pieceAt, samplesOf } from "./drive.mjs";
import { givenDesign, movedOn, sameDesign, solveAt, valuesNear } from "./model.mjs";
import { clamped, lastIndex, bisected } from "./search.mjs";
import {
  APART,
  ASTRAY,
  BESIDE_LIMIT,
  HALVED,
  PARTS,
  PARTS_OF_PIECE,
  ROUNDING,
  SMALLEST_STEP,
  same,
  sameLimit,
  UNBOUNDED,
} from "./tolerances.mjs";

/**
 * @typedef {{x: number, piece: number, pose: any, shifts: number[]}} Row shifts: the full revolutions of each angle, in
 * radians
 * @typedef {{from: number, to: number, rows: Row[]}} Span
 * @typedef {{from: number, to: number, check: string, block: string, margin: number, at: number, lost: boolean}} Gap
 * @typedef {object} Sweep
 * @property {import("./model.mjs").Design} design
 * @property {any} assembly as the report lists it
 * @property {boolean} given whether the design is that of the report
 * @property {boolean} reported whether the assembly is as well, so that the numbers of the report hold
 * @property {Span[]} spans where it closes
 * @property {Gap[]} gaps where it does not
 * @property {boolean} full whether it closes over a full revolution
 * @property {number[][]} travel the range of each slide
 * @property {number[][]} scales the size of each quantity's derivatives
 */

/** Solves the whole range. @returns {Sweep} */
export function createSweep(model, design, assembly) {
  const { spans, gaps } = model.frames
    ? stretchesOf(
        model.frames.map(({ x, piece, pose }) => ({
          x,
          piece,
          pose,
          shifts: [],
          ok: pose !== null,
          check: "does not close",
          block: "",
          margin: NaN,
        })),
      )
    : (model.coupled ? goOn : lookAround)(model, design, assembly);
  unwind(model, spans);
  const given = sameDesign(design, givenDesign(model));
  const reported = given && assembly === model.report.assemblies[model.report.assembly ?? 0];
  const full = gaps.length === 0 && spans.length === 1 && same(model, model.width, model.period);
  const sweep = { model, design, assembly, given, reported, spans, gaps, full, travel: [], scales: [] };
  sweep.travel = model.outline.slides.map((_, slide) => {
    const along = allRows(sweep).map(({ pose }) => alongSlide(model, pose, slide));
    return along.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]);
  });
  // apart from the rows next to limits, where rates grow beyond bounds
  const inner = innerRows(sweep);
  const sizeOfRate = (name, order) =>
    inner.reduce((size, { pose }) => Math.max(size, Math.abs(pose[name][order] ?? 0)), 0);
  sweep.scales = model.quantities.map(({ name }) => [0, 1, 2, 3, 4].map((order) => sizeOfRate(name, order)));
  return sweep;
}

/** Solves at samples all over the range, and finds by halving where the mechanism begins or ceases to close. */
function lookAround(model, design, { argument }) {
  const at = (x, piece = pieceAt(model.drive, x)) => ({
    x,
    piece,
    shifts: [],
    ...solveAt(model, design, x, argument, piece),
  });
  const samples = samplesOf(model.drive, model.from, model.to, PARTS, PARTS_OF_PIECE);
  const seen = samples.map(({ x, piece }) => at(x, piece));
  const edgeOf = (inside, outside) => bisected((x) => at(x).ok, inside.x, outside.x, HALVED * model.width);
  // denser towards a limit, where the motion goes like a square root
  const graded = (edge, inside) =>
    [0, 1, 2, 3, 4, 5, 6, 7].map((part) => at(edge + (inside.x - edge) * (part / 8) ** 2)).filter(({ ok }) => ok);
  const found = stretchesOf(seen, edgeOf, graded);
  for (const span of found.spans) {
    const size = sizeOf(span.rows[0].pose);
    span.rows = span.rows.flatMap((row, index) =>
      index === 0 ? [row] : [...between(at, span.rows[index - 1], row, size), row],
    );
  }
  return found;
}

/** Divides rows into stretches that close and stretches that do not, with an edge between them and rows up to it. */
function stretchesOf(rows, edgeOf = (inside) => inside.x, upTo = () => []) {
  const all = [];
  for (const row of rows) {
    const last = all.at(-1);
    if (last?.ok === row.ok) {
      last.rows.push(row);
      last.to = row.x;
    } else {
      all.push({ ok: row.ok, from: row.x, to: row.x, rows: [row] });
    }
  }
  for (let index = 1; index < all.length; index += 1) {
    const [before, behind] = [all[index - 1], all[index]];
    const [last, first] = [before.rows.at(-1), behind.rows[0]];
    const edge = behind.ok ? edgeOf(first, last) : edgeOf(last, first);
    before.to = behind.from = edge;
    if (behind.ok) {
      behind.rows.unshift(...upTo(edge, first));
    } else {
      before.rows.push(...upTo(edge, last).reverse());
    }
  }
  const gapOf = ({ from, to, rows }) => {
    const { check, block, margin, x } = rows.reduce((worst, row) => (row.margin < worst.margin ? row : worst));
    return { from, to, check, block, margin, at: x, lost: false };
  };
  return { spans: all.filter(({ ok }) => ok), gaps: all.filter(({ ok }) => !ok).map(gapOf) };
}

/** Rows between two others if joints move fast there. */
function between(at, before, row, size) {
  const moved = row.pose.joints.map((joint, index) =>
    Math.max(...joint.map((value, axis) => Math.abs(value - before.pose.joints[index][axis]))),
  );
  const parts = Math.min(6, Math.ceil(Math.max(...moved) / size / APART));
  const rows = [];
  for (let part = 1; part < parts; part += 1) {
    rows.push(at(before.x + ((row.x - before.x) * part) / parts));
  }
  return rows.filter(({ ok }) => ok);
}

/** Goes on from pose to pose on both sides of the value at which the assembly is given. */
function goOn(model, design, assembly) {
  const start = clamped(assembly.at ?? model.from, model.from, model.to);
  const piece = pieceAt(model.drive, start);
  const { ok, pose, check, block, margin } = solveAt(model, design, start, assembly.argument, piece);
  if (!ok) {
    return { spans: [], gaps: [{ from: model.from, to: model.to, check, block, margin, at: start, lost: false }] };
  }
  const row = { x: start, piece, pose, shifts: [] };
  const [back, on] = [walk(model, design, row, -1), walk(model, design, row, 1)];
  const rows = [...back.rows.reverse(), row, ...on.rows];
  return { spans: [{ from: rows[0].x, to: rows.at(-1).x, rows }], gaps: [...back.gaps, ...on.gaps] };
}

/** Goes on in one direction, to the end of the range or to where the assembly is lost. */
function walk(model, design, start, sign) {
  const size = sizeOf(start.pose);
  const rows = [];
  const whole = model.width / PARTS;
  const isAhead = ({ x, piece }) =>
    same(model, x, start.x) ? x === start.x && sign * (piece - start.piece) > 0 : sign * (x - start.x) > 0;
  const ahead = samplesOf(model.drive, model.from, model.to, PARTS, PARTS_OF_PIECE).filter(isAhead);
  let last = start;
  let step = whole;
  for (const aim of sign > 0 ? ahead : ahead.reverse()) {
    while (last.x !== aim.x || last.piece !== aim.piece) {
      const isShort = step < whole && Math.abs(aim.x - last.x) > step;
      const x = isShort ? last.x + sign * step : aim.x;
      const piece = isShort ? pieceAt(model.drive, x) : aim.piece;
      const found = solveAt(model, design, x, valuesNear(model, design, last.pose, x - last.x), piece);
      if (found.ok && isNextTo(model, design, last, { x, pose: found.pose }, size)) {
        last = { x, piece, pose: found.pose, shifts: [] };
        rows.push(last);
        step = Math.min(whole, 2 * step);
      } else if (step > whole * SMALLEST_STEP) {
        step *= 0.5;
      } else {
        const { check, block, margin } = found.ok ? { check: "", block: "", margin: 0 } : found;
        const [from, to] = sign > 0 ? [last.x, model.to] : [model.from, last.x];
        return { rows, gaps: [{ from, to, check, block, margin, at: x, lost: true }] };
      }
    }
  }
  return { rows, gaps: [] };
}

/** Whether the rates of each of two poses lead to the other. */
function isNextTo(model, design, one, other, size) {
  const time = (other.x - one.x) / design.speed;
  return model.unknowns.every(({ name, dimension }) => {
    const allowed = ASTRAY * (dimension === "length" ? size : 1);
    const isNear = (value, wanted) =>
      Math.abs(value - wanted + (dimension === "angle" ? revolutionsBetween(value, wanted) : 0)) <= allowed;
    return (
      isNear(movedOn(one.pose[name], time), other.pose[name][0]) &&
      isNear(movedOn(other.pose[name], -time), one.pose[name][0])
    );
  });
}

/** The largest distance of two joints. */
export function sizeOf({ joints }) {
  return Math.max(
    1e-300,
    ...joints.flatMap((one) => joints.map((other) => Math.hypot(...one.map((value, axis) => value - other[axis])))),
  );
}

/**
 * Unwraps angles from row to row, so that curves do not jump. Behind a gap they go on from the last row of the grid
 * before the gap, as in kin's tables.
 */
function unwind(model, spans) {
  const isOnGrid = ({ x }) => {
    const part = ((x - model.from) / model.width) * PARTS;
    return same(model, (part - Math.round(part)) * model.width, 0);
  };
  let last = null;
  for (const { rows } of spans) {
    const onGrid = rows.filter(isOnGrid);
    const first = Math.max(0, rows.indexOf(onGrid[0]));
    const count = (index, before) => (rows[index].shifts = shiftsBeside(model, rows[index].pose, before));
    count(first, last);
    for (let index = first - 1; index >= 0; index -= 1) {
      count(index, rows[index + 1]);
    }
    for (let index = first + 1; index < rows.length; index += 1) {
      count(index, rows[index - 1]);
    }
    last = onGrid.at(-1) ?? rows.at(-1);
  }
}

/** The full revolutions, in radians, to add to each angle of a pose so that it comes nearest to that of a row. */
function shiftsBeside(model, pose, row) {
  return model.quantities.map(({ name, dimension }, index) =>
    row === null || dimension !== "angle"
      ? 0
      : revolutionsBetween(pose[name][0], row.pose[name][0] + row.shifts[index]),
  );
}

function revolutionsBetween(angle, wanted) {
  return 2 * Math.PI * Math.round((wanted - angle) / (2 * Math.PI)) || 0;
}

/** The shift of a slide's joint along its line, from the first joint of the body that guides it, or from the origin. */
export function alongSlide(model, pose, slide) {
  const { joint, guide } = model.outline.slides[slide];
  const direction = pose.slides[slide];
  const origin = guide === null ? null : pose.joints[model.outline.bodies[guide].joints[0]];
  const length = Math.hypot(...direction);
  return pose.joints[joint].reduce(
    (sum, value, axis) => sum + ((value - (origin?.[axis] ?? 0)) * direction[axis]) / length,
    0,
  );
}

/** A derivative of a quantity, by its index, at a row; angles are unwrapped. */
export function valueAt(model, { pose, shifts }, index, order) {
  return pose[model.quantities[index].name][order] + (order === 0 ? shifts[index] : 0);
}

/** All rows in the order of the variable. @returns {Row[]} */
export function allRows(sweep) {
  return sweep.spans.flatMap((span) => span.rows);
}

/** The rows that are not next to a limit. @returns {Row[]} */
export function innerRows(sweep) {
  if (sweep.full) {
    return allRows(sweep);
  }
  return sweep.spans.flatMap(({ from, to, rows }) => {
    const margin = (edge) => (isAtLimit(sweep, edge) ? BESIDE_LIMIT * (to - from) : 0);
    const [low, high] = [from + margin(from), to - margin(to)];
    return rows.filter(({ x }) => x >= low && x <= high);
  });
}

/**
 * The names of the quantities that move in proportion to the variable, as behind a gear. Beside others of their
 * dimension their lines tell nothing, and squash the other curves.
 */
export function straightNames(sweep) {
  const { model, scales } = sweep;
  const isStraight = ({ isInput }, index) =>
    !isInput &&
    scales[index][1] > 0 &&
    [2, 3, 4].slice(0, model.orders - 1).every((order) => scales[index][order] <= ROUNDING * scales[index][1]);
  const straight = model.quantities.filter(isStraight);
  const others = model.quantities.filter((one) => !straight.includes(one));
  return straight.filter(({ dimension }) => others.some((one) => one.dimension === dimension)).map(({ name }) => name);
}

/** The stretch that holds a value of the variable, or null. @returns {Span | null} */
export function spanAt({ model, spans }, x) {
  return spans.find(({ from, to }) => same(model, clamped(x, from, to), x)) ?? null;
}

/** Whether a value of the variable is a limit, at which the mechanism ceases to close. */
export function isAtLimit({ model, gaps }, x) {
  return gaps.some(({ from, to }) => sameLimit(model, from, x) || sameLimit(model, to, x));
}

/** Whether a derivative grows beyond bounds at a row: at a limit it is far larger than anywhere else. */
export function isUnbounded(sweep, { x, pose }, index, order) {
  return (
    isAtLimit(sweep, x) &&
    Math.abs(pose[sweep.model.quantities[index].name][order]) > UNBOUNDED * sweep.scales[index][order]
  );
}

/** At a joint of laws, the row before it, at the same value; otherwise null. @returns {Row | null} */
export function rowBefore(sweep, { x, piece }) {
  const isJoint = sweep.model.drive.joints.some((joint) => joint.at === x && joint.piece === piece);
  return (isJoint && spanAt(sweep, x)?.rows.find((one) => one.x === x && one.piece < piece)) || null;
}

/** The pose at a value of the variable, with unwrapped angles; null where it does not close. @returns {Row | null} */
export function rowAt(sweep, x) {
  const { model, design, assembly } = sweep;
  const rows = spanAt(sweep, x)?.rows;
  if (!rows) {
    return null;
  }
  const low = lastIndex(rows, x, (row) => row.x);
  const [before, behind] = [rows[low], rows[low + 1]];
  const near = behind && behind.x - x < x - before.x ? behind : before;
  if (near.x === x || model.frames) {
    return near;
  }
  const argument = model.coupled ? valuesNear(model, design, near.pose, x - near.x) : assembly.argument;
  const piece = pieceAt(model.drive, x);
  const found = solveAt(model, design, x, argument, piece);
  return found.ok ? { x, piece, pose: found.pose, shifts: shiftsBeside(model, found.pose, near) } : near;
}

/** The nearest value at which the mechanism closes. */
export function heldInput(sweep, x) {
  const held = sweep.spans.map(({ from, to }) => clamped(x, from, to));
  return held.reduce((best, one) => (Math.abs(one - x) < Math.abs(best - x) ? one : best), held[0] ?? x);
}

/**
 * The value that the variable reaches by a motion: it stops at limits, and passes from the end of a revolution to its
 * beginning.
 * @returns {{x: number, stopped: boolean}}
 */
export function movedInput(sweep, x, change) {
  const { model } = sweep;
  const span = spanAt(sweep, x);
  if (span === null) {
    return { x, stopped: true };
  }
  const aim = x + change;
  const held = clamped(aim, span.from, span.to);
  const [end, begin] = aim > model.to ? [model.to, model.from] : [model.from, model.to];
  const isPast = aim > model.to || aim < model.from;
  const next = isPast && model.period > 0 && same(model, held, end) ? spanAt(sweep, begin) : null;
  if (next !== null) {
    return { x: clamped(aim - Math.sign(change) * model.period, next.from, next.to), stopped: false };
  }
  return { x: held, stopped: !same(model, held, aim) };
}
