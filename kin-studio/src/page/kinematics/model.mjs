/** The mechanism as the page sees it: its quantities, its drive, and its solver. */
import { driveOf, motionOf, pieceAt } from "./drive.mjs";

/** The newest form of a report that this page reads. */
export const FORMAT = 3;

/**
 * Dimensions, values of the inputs that stand, and the change of the variable for each unit of time.
 * @typedef {{parameters: Record<string, number>, standing: Record<string, number>, speed: number}} Design
 * @typedef {Record<string, any>} Pose
 * @typedef {{ok: true, pose: Pose} | {ok: false, check: string, block: string, margin: number}} Solved
 * @typedef {{name: string, text: string, documentation: string, dimension: string, colour: number}} Quantity
 */

/** The mistake in a report, or an empty text. */
export function reasonToRefuse(report) {
  if (typeof report?.format !== "number") {
    return "This page holds no report.";
  }
  if (report.format > FORMAT) {
    const both = `The report has format ${report.format}; this page reads formats up to ${FORMAT}.`;
    return `${both} Write the page again with the kin that wrote the report.`;
  }
  if (report.format < FORMAT) {
    return `The report has format ${report.format}; this page reads format ${FORMAT}. Make the report again.`;
  }
  return "";
}

/** The time as a quantity. */
const TIME = { name: "time", declared: "time", text: "time", documentation: "", dimension: "time" };

/** The mechanism of a report. */
export function createModel(report, solver) {
  // the solver's own names are used throughout; the declared ones are for the reader
  const named = (quantity) => ({
    ...quantity,
    name: quantity.key ?? quantity.name,
    declared: quantity.name,
    text: quantity.text || quantity.name,
  });
  const drive = driveOf(report);
  const inputs = report.inputs.map((input, index) => ({
    ...named(input),
    index,
    moves: typeof input.value !== "number",
  }));
  const moving = inputs.filter(({ moves }) => moves);
  const variable = drive.overTime ? TIME : inputs[report.moving];
  const unknowns = report.unknowns.map(named);
  // over time the inputs are plotted as well
  const plotted = drive.overTime ? moving.map((input) => ({ ...input, isInput: true })) : [];
  const quantities = [...unknowns, ...report.outputs.map(named), ...plotted].map((quantity, index) => ({
    isInput: false,
    ...quantity,
    colour: index % 6,
    dashed: index >= 6,
  }));
  return {
    report,
    solver,
    inputs,
    /** The inputs that move. */
    moving,
    drive,
    /** The moving inputs that are neither the variable nor, over time, among the quantities. */
    others: drive.overTime ? [] : moving.filter(({ name }) => name !== variable.name),
    /** The variable of the range. */
    variable,
    parameters: report.parameters.map(named),
    unknowns,
    quantities,
    frames: solver ? null : framesOf(report, drive, quantities),
    outline: report.outline,
    from: report.range[0],
    to: report.range[1],
    width: report.range[1] - report.range[0],
    period: report.period ?? 0,
    orders: Math.min(4, report.order ?? 4),
    coupled: Boolean(report.coupled),
    space: Boolean(report.space),
    degrees: Boolean(report.degrees ?? true),
    units: report.units ?? { length: "", time: "s" },
  };
}

/** The poses of a mechanism without a solver, in the shape in which a solver gives them. */
function framesOf({ frames, order, speed }, drive, quantities) {
  return (frames ?? []).map(({ input, values, joints, slides }) => {
    const piece = pieceAt(drive, input);
    const entries = quantities.map(({ name, isInput, index: position }, index) => [
      name,
      isInput ? motionOf(drive, position, input, piece, speed, order) : values[index],
    ]);
    return { x: input, piece, pose: values.length > 0 ? { ...Object.fromEntries(entries), joints, slides } : null };
  });
}

/** The design of the report. @returns {Design} */
export function givenDesign(model) {
  return {
    parameters: Object.fromEntries(model.parameters.map(({ name, value }) => [name, value])),
    standing: Object.fromEntries(model.inputs.filter(({ moves }) => !moves).map(({ name, value }) => [name, value])),
    speed: model.report.speed || 1,
  };
}

/** Whether two designs have the same numbers. */
export function sameDesign(one, other) {
  const same = (left, right) => Object.keys(left).every((name) => left[name] === right[name]);
  return one.speed === other.speed && same(one.parameters, other.parameters) && same(one.standing, other.standing);
}

/**
 * The pose at a value of the variable.
 * @param {any} argument the assembly, or values nearby
 * @param {number} piece the piece of the drive
 * @returns {Solved}
 */
export function solveAt(model, design, x, argument, piece = pieceAt(model.drive, x)) {
  const orders = Math.max(4, model.report.order ?? 4);
  const inputs = {};
  for (const { name, index, moves } of model.inputs) {
    inputs[name] = moves
      ? motionOf(model.drive, index, x, piece, design.speed, orders)
      : [design.standing[name], ...Array(orders).fill(0)];
  }
  const solved = model.solver.solve(design.parameters, inputs, argument);
  if (solved.ok) {
    model.quantities.filter(({ isInput }) => isInput).forEach(({ name }) => (solved.pose[name] = inputs[name]));
  }
  return solved;
}

/** The unknowns of a pose as values nearby, moved on by a change of the variable. */
export function valuesNear(model, design, pose, change = 0) {
  const time = change / design.speed;
  return Object.fromEntries(model.unknowns.map(({ name }) => [name, movedOn(pose[name], time)]));
}

/** A Taylor polynomial. */
export function movedOn(rates, time) {
  let sum = 0;
  for (let order = rates.length - 1; order >= 0; order -= 1) {
    sum = rates[order] + (sum * time) / (order + 1);
  }
  return sum;
}

/** The names of a block with the texts of its unknowns. */
export function blockText(model, block) {
  const text = (name) =>
    model.quantities.find((quantity) => quantity.declared === name || quantity.name === name)?.text ?? name;
  return block.split(", ").map(text).join(", ");
}
