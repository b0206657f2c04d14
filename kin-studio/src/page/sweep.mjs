/** The whole turn of a design in one assembly: its poses, where it closes, and where it does not. */
import { pieceAt, placesOf } from "./drive.mjs";
import { movedOn, solveAt, valuesNear } from "./model.mjs";

/** Parts of the range. */
const PARTS = 360;
/** The parts of a piece of the drive. */
const ROWS_OF_PIECE = 8;
/** How far a limit is bisected, in units of the variable. */
const BISECTED = 1e-9;
/** The part of its size by which a joint may move from row to row; rows are put between where it moves further. */
const APART = 0.03;
/** The smallest step of a coupled mechanism, in parts of the usual one. */
const SMALLEST = 2 ** -22;
/** How far the position of a coupled mechanism may be from the one that its rates before lead to: radians, or parts of its size. */
const ASTRAY = 1e-3;

/**
 * @typedef {{x: number, piece: number, pose: any, shifts: number[]}} Row
 * @typedef {{x: number, kind: string, text: string, own: boolean}} Mark
 * @typedef {{from: number, to: number, rows: Row[]}} Span
 * @typedef {{from: number, to: number, check: string, block: string, margin: number, at: number, lost: boolean}} Gap
 * @typedef {{spans: Span[], gaps: Gap[], full: boolean, travel: number[][], scales: number[][]}} Sweep
 */

/**
 * @param {import("./model.mjs").Model} model
 * @param {import("./model.mjs").Design} design
 * @param {any} assembly as the report lists it
 * @returns {Sweep}
 */
export function sweepDesign(model, design, assembly) {
  const found = model.frames ? standing(model) : model.coupled ? goOn(model, design, assembly) : lookAround(model, design, assembly.argument);
  const { spans, gaps } = found;
  unwind(model, spans);
  const full = gaps.length === 0 && spans.length === 1 && Math.abs(model.to - model.from - model.period) < 1e-9;
  const sweep = { spans, gaps, full, travel: [], scales: [] };
  sweep.travel = model.outline.slides.map((_, slide) => travelOf(model, sweep, slide));
  sweep.scales = model.quantities.map(({ name }) => [0, 1, 2, 3, 4].map((order) => scaleOf(sweep, name, order)));
  return sweep;
}

/** The frames of a mechanism without a solver. */
function standing(model) {
  const [spans, gaps] = [[], []];
  let before = null;
  for (const { x, piece, pose } of model.frames) {
    const closes = pose !== null;
    if (before === null || before.closes !== closes) {
      const from = before?.x ?? x;
      (closes ? spans : gaps).push(closes ? { from: x, to: x, rows: [] } : newGap(from, { check: "does not close", block: "", margin: NaN }));
    }
    const last = closes ? spans[spans.length - 1] : gaps[gaps.length - 1];
    last.to = x;
    last.rows?.push({ x, piece, pose, shifts: [] });
    before = { x, closes };
  }
  return { spans, gaps };
}

/** Looks at every part of the range for itself, and bisects where the check changes its sign. */
function lookAround(model, design, argument) {
  const solved = (x, piece = pieceAt(model.drive, x)) => ({ ...solveAt(model, design, x, argument, piece), piece });
  const spans = [];
  const gaps = [];
  let span = null;
  let gap = null;
  let before = null;
  for (const { x, piece } of placesOf(model.drive, model.from, model.to, PARTS, ROWS_OF_PIECE)) {
    const found = solved(x, piece);
    if (before !== null && found.ok !== before.found.ok) {
      const edge = bisect(solved, before, { x, found });
      const inner = graded(solved, edge, found.ok ? x : before.x);
      if (found.ok) {
        gap.to = edge.x;
        span = { from: edge.x, to: x, rows: [edge, ...inner] };
        spans.push(span);
      } else {
        span.rows.push(...inner.reverse(), edge);
        span.to = edge.x;
        gap = newGap(edge.x, found);
        gaps.push(gap);
      }
    } else if (before === null) {
      span = found.ok ? { from: x, to: x, rows: [] } : null;
      gap = found.ok ? null : newGap(x, found);
      (found.ok ? spans : gaps).push(span ?? gap);
    }
    if (found.ok) {
      span.rows.push(rowOf(x, found));
      span.to = x;
    } else {
      worsen(gap, x, found);
      gap.to = x;
    }
    before = { x, found };
  }
  for (const one of spans) {
    one.rows = fine(model, solved, one.rows);
  }
  return { spans, gaps };
}

/** The rows, with others between them where joints move fast. */
function fine(model, solved, rows) {
  if (rows.length === 0) {
    return rows;
  }
  const size = sizeOf(model, rows[0].pose);
  const all = [rows[0]];
  for (let index = 1; index < rows.length; index += 1) {
    const [before, row] = [rows[index - 1], rows[index]];
    let moved = 0;
    row.pose.joints.forEach((joint, place) => {
      const other = before.pose.joints[place];
      moved = Math.max(moved, Math.abs(joint[0] - other[0]), Math.abs(joint[1] - other[1]), Math.abs((joint[2] ?? 0) - (other[2] ?? 0)));
    });
    const parts = Math.min(6, Math.ceil(moved / size / APART));
    for (let part = 1; part < parts; part += 1) {
      const x = before.x + ((row.x - before.x) * part) / parts;
      const found = solved(x);
      if (found.ok) {
        all.push(rowOf(x, found));
      }
    }
    all.push(row);
  }
  return all;
}

function rowOf(x, { pose, piece }) {
  return { x, piece, pose, shifts: [] };
}

function newGap(x, { check, block, margin }) {
  return { from: x, to: x, check, block, margin, at: x, lost: false };
}

function worsen(gap, x, { check, block, margin }) {
  if (margin < gap.margin) {
    Object.assign(gap, { check, block, margin, at: x });
  }
}

/** The last place that closes between one that does and one that does not. */
function bisect(solved, one, other) {
  let [inside, outside] = one.found.ok ? [one, other] : [other, one];
  while (Math.abs(inside.x - outside.x) > BISECTED) {
    const x = 0.5 * (inside.x + outside.x);
    const found = solved(x);
    if (found.ok) {
      inside = { x, found };
    } else {
      outside = { x, found };
    }
  }
  return rowOf(inside.x, inside.found);
}

/** Rows between a limit and a place inside, denser towards the limit, where the motion goes like a square root. */
function graded(solved, edge, inside) {
  const rows = [];
  for (let part = 1; part < 8; part += 1) {
    const x = edge.x + (inside - edge.x) * (part / 8) ** 2;
    const found = solved(x);
    if (found.ok) {
      rows.push(rowOf(x, found));
    }
  }
  return rows;
}

/** Goes on from pose to pose on both sides of the place where the assembly is given. */
function goOn(model, design, assembly) {
  const start = Math.min(model.to, Math.max(model.from, assembly.at ?? model.from));
  const first = solveAt(model, design, start, assembly.argument);
  if (!first.ok) {
    return { spans: [], gaps: [{ ...newGap(model.from, first), to: model.to, at: start }] };
  }
  const row = { x: start, piece: pieceAt(model.drive, start), pose: first.pose, shifts: [] };
  const back = walk(model, design, row, model.from);
  const on = walk(model, design, row, model.to);
  const rows = [...back.rows.reverse(), row, ...on.rows];
  const gaps = [back.gap, on.gap].filter((gap) => gap !== null);
  return { spans: [{ from: rows[0].x, to: rows[rows.length - 1].x, rows }], gaps };
}

function walk(model, design, start, end) {
  const size = sizeOf(model, start.pose);
  const rows = [];
  const whole = (model.to - model.from) / PARTS;
  const sign = end >= start.x ? 1 : -1;
  const isAhead = ({ x, piece }) => sign * (x - start.x) > 1e-12 || (x === start.x && sign * (piece - start.piece) > 0);
  const ahead = placesOf(model.drive, model.from, model.to, PARTS, ROWS_OF_PIECE).filter(isAhead);
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
      } else if (step > whole * SMALLEST) {
        step *= 0.5;
      } else {
        const reason = found.ok ? { check: "", block: "", margin: 0 } : found;
        const [from, to] = sign > 0 ? [last.x, end] : [end, last.x];
        return { rows, gap: { ...newGap(last.x, reason), from, to, at: x, lost: true } };
      }
    }
  }
  return { rows, gap: null };
}

/** Whether the rates of each of two poses lead to the other. */
function isNextTo(model, design, one, other, size) {
  const time = (other.x - one.x) / design.speed;
  return model.unknowns.every(({ name, dimension }) => {
    const allowed = ASTRAY * (dimension === "length" ? size : 1);
    const ahead = distanceOf(movedOn(one.pose[name], time), other.pose[name][0], dimension);
    const behind = distanceOf(movedOn(other.pose[name], -time), one.pose[name][0], dimension);
    return ahead <= allowed && behind <= allowed;
  });
}

function distanceOf(one, other, dimension) {
  const distance = Math.abs(one - other);
  return dimension === "angle" ? Math.abs(distance - 2 * Math.PI * Math.round(distance / (2 * Math.PI))) : distance;
}

function sizeOf(model, pose) {
  let size = 1e-9;
  for (const joint of pose.joints ?? []) {
    for (const other of pose.joints) {
      size = Math.max(size, Math.hypot(...joint.map((value, axis) => value - other[axis])));
    }
  }
  return size;
}

/**
 * Counts the turns of angles from row to row, so that curves do not jump. Behind a gap they go on from the last row of the grid before it,
 * as the rows of kin's tables do.
 */
function unwind(model, spans) {
  let last = null;
  for (const { rows } of spans) {
    const shiftsOf = (row, before) =>
      model.quantities.map(({ name, dimension }, index) => {
        if (before === null || dimension !== "angle") {
          return 0;
        }
        return turnsBetween(row.pose[name][0], before.pose[name][0] + before.shifts[index]);
      });
    const onGrid = rows.filter(({ x }) => isOnGrid(model, x));
    const first = Math.max(0, rows.indexOf(onGrid[0]));
    if (rows.length > 0) {
      rows[first].shifts = shiftsOf(rows[first], last);
    }
    for (let index = first - 1; index >= 0; index -= 1) {
      rows[index].shifts = shiftsOf(rows[index], rows[index + 1]);
    }
    for (let index = first + 1; index < rows.length; index += 1) {
      rows[index].shifts = shiftsOf(rows[index], rows[index - 1]);
    }
    last = onGrid[onGrid.length - 1] ?? rows[rows.length - 1] ?? last;
  }
}

function isOnGrid(model, x) {
  const place = ((x - model.from) / (model.to - model.from)) * PARTS;
  return Math.abs(place - Math.round(place)) < 1e-9;
}

/**
 * The turns, in radians, to add to an angle so that it comes nearest to another.
 * @param {number} angle
 * @param {number} wanted
 */
export function turnsBetween(angle, wanted) {
  return 2 * Math.PI * Math.round((wanted - angle) / (2 * Math.PI)) || 0;
}

function travelOf(model, sweep, slide) {
  const travel = [Infinity, -Infinity];
  for (const row of allRows(sweep)) {
    const along = alongSlide(model, row.pose, slide);
    travel[0] = Math.min(travel[0], along);
    travel[1] = Math.max(travel[1], along);
  }
  return travel;
}

/**
 * How far a slide's joint is along its line, from the first joint of the body that guides it, or from the origin.
 * @param {import("./model.mjs").Model} model
 * @param {any} pose
 * @param {number} slide
 */
export function alongSlide(model, pose, slide) {
  const { joint, guide } = model.outline.slides[slide];
  const direction = pose.slides[slide];
  const origin = guide === null ? null : pose.joints[model.outline.bodies[guide].joints[0]];
  const length = Math.hypot(...direction);
  return pose.joints[joint].reduce((sum, value, axis) => sum + ((value - (origin?.[axis] ?? 0)) * direction[axis]) / length, 0);
}

/** The size of a quantity's values, apart from the rows next to limits, where rates grow beyond bounds. */
function scaleOf(sweep, name, order) {
  let size = 0;
  for (const { x, pose } of innerRows(sweep)) {
    size = Math.max(size, Math.abs(pose[name][order] ?? 0));
  }
  return size;
}

/**
 * All rows in the order of the variable.
 * @param {Sweep} sweep
 * @returns {Row[]}
 */
export function allRows(sweep) {
  return sweep.spans.flatMap((span) => span.rows);
}

/**
 * The rows that are not next to a limit.
 * @param {Sweep} sweep
 * @returns {Row[]}
 */
export function innerRows(sweep) {
  if (sweep.full) {
    return allRows(sweep);
  }
  return sweep.spans.flatMap(({ from, to, rows }) => {
    const limits = sweep.gaps.flatMap((gap) => [gap.from, gap.to]);
    const margin = (edge) => (limits.some((limit) => Math.abs(limit - edge) < 1e-6) ? 0.04 * (to - from) : 0);
    const [low, high] = [from + margin(from), to - margin(to)];
    return rows.filter(({ x }) => x >= low && x <= high);
  });
}

/**
 * The stretch on which a place lies.
 * @param {Sweep} sweep
 * @param {number} x
 */
export function spanAt(sweep, x) {
  return sweep.spans.find(({ from, to }) => x >= from - 1e-9 && x <= to + 1e-9) ?? null;
}

/**
 * The row nearest to a place, within its stretch.
 * @param {Sweep} sweep
 * @param {number} x
 * @returns {Row | null}
 */
export function rowNear(sweep, x) {
  const rows = spanAt(sweep, x)?.rows;
  if (!rows || rows.length === 0) {
    return null;
  }
  let low = 0;
  let high = rows.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (rows[middle].x <= x) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return x - rows[low].x <= rows[high].x - x ? rows[low] : rows[high];
}

/**
 * At a joint of laws, the row before it, at the same place; otherwise null.
 * @param {import("./model.mjs").Model} model
 * @param {Sweep} sweep
 * @param {Row} row
 * @returns {Row | null}
 */
export function rowBefore(model, sweep, row) {
  const isThere = model.drive.joints.some(({ at, piece }) => at === row.x && piece === row.piece);
  return (isThere && spanAt(sweep, row.x)?.rows.find((one) => one.x === row.x && one.piece < row.piece)) || null;
}

/**
 * The pose at a place, with the turns of its angles.
 * @param {import("./model.mjs").Model} model
 * @param {import("./model.mjs").Design} design
 * @param {Sweep} sweep
 * @param {any} assembly
 * @param {number} x
 * @returns {Row | null}
 */
export function rowAt(model, design, sweep, assembly, x) {
  const near = rowNear(sweep, x);
  if (near === null) {
    return null;
  }
  if (near.x === x || model.frames) {
    return near;
  }
  const argument = model.coupled ? valuesNear(model, design, near.pose, x - near.x) : assembly.argument;
  const piece = pieceAt(model.drive, x);
  const found = solveAt(model, design, x, argument, piece);
  if (!found.ok) {
    return near;
  }
  const shifts = model.quantities.map(({ name, dimension }, index) =>
    dimension === "angle" ? turnsBetween(found.pose[name][0], near.pose[name][0] + near.shifts[index]) : 0,
  );
  return { x, piece, pose: found.pose, shifts };
}

/**
 * Where the variable comes to when it moves: it stops at limits, and passes from the end of a turn to its beginning.
 * @param {import("./model.mjs").Model} model
 * @param {Sweep} sweep
 * @param {number} x
 * @param {number} change
 * @returns {{x: number, stopped: boolean}}
 */
export function movedInput(model, sweep, x, change) {
  const span = spanAt(sweep, x);
  if (span === null) {
    return { x, stopped: true };
  }
  let aim = x + change;
  if (model.period > 0 && (aim > model.to || aim < model.from)) {
    const wrapped = aim > model.to ? aim - model.period : aim + model.period;
    const edge = aim > model.to ? model.from : model.to;
    if (spanAt(sweep, edge) !== null && (aim > model.to ? span.to >= model.to - 1e-9 : span.from <= model.from + 1e-9)) {
      const next = spanAt(sweep, edge);
      return { x: Math.min(next.to, Math.max(next.from, wrapped)), stopped: false };
    }
  }
  const held = Math.min(span.to, Math.max(span.from, aim));
  return { x: held, stopped: Math.abs(held - aim) > 1e-12 };
}

/**
 * Whether a place is at an end of what closes, apart from those of the range.
 * @param {Sweep} sweep
 * @param {number} x
 */
export function isAtLimit(sweep, x) {
  return sweep.gaps.some(({ from, to }) => Math.abs(from - x) < 1e-6 || Math.abs(to - x) < 1e-6);
}
