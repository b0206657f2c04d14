/** The mechanism as the page sees it: its quantities, and its solver. */

/** The newest form of a report that this page reads. */
export const FORMAT = 1;

/**
 * Dimensions, places of the inputs that stand still, and the speed of the input that moves.
 * @typedef {{parameters: Record<string, number>, standing: Record<string, number>, speed: number}} Design
 * @typedef {Record<string, any>} Pose
 * @typedef {{ok: true, pose: Pose} | {ok: false, check: string, block: string, margin: number}} Solved
 * @typedef {{name: string, text: string, documentation: string, dimension: string, colour: number}} Quantity
 */

/**
 * What is wrong with a report, or an empty text.
 * @param {any} report
 */
export function reasonToRefuse(report) {
  if (typeof report?.format !== "number") {
    return "This page holds no report.";
  }
  if (report.format > FORMAT) {
    return `The report has format ${report.format}; this page reads formats up to ${FORMAT}. Write the page again with the kin that wrote the report.`;
  }
  return "";
}

/**
 * @param {any} report
 * @param {any} solver
 */
export function createModel(report, solver) {
  // the solver's own names are used throughout; the declared ones are for the reader
  const named = (quantity) => ({ ...quantity, name: quantity.key ?? quantity.name, declared: quantity.name, text: quantity.text || quantity.name });
  const inputs = report.inputs.map(named);
  const moving = inputs[report.moving] ?? inputs[0];
  const unknowns = report.unknowns.map(named);
  const quantities = [...unknowns, ...report.outputs.map(named)].map((quantity, index) => ({
    ...quantity,
    colour: index % 6,
    dashed: index >= 6,
  }));
  return {
    report,
    solver,
    inputs,
    moving,
    parameters: report.parameters.map(named),
    unknowns,
    quantities,
    frames: solver ? null : framesOf(report, quantities),
    outline: report.outline ?? solver?.OUTLINE ?? { ground: [], bodies: [], slides: [], points: [] },
    from: report.range[0],
    to: report.range[1],
    period: report.period ?? 0,
    orders: Math.min(4, report.order ?? 4),
    coupled: Boolean(report.coupled),
    space: Boolean(report.space),
    degrees: Boolean(report.degrees ?? true),
    units: report.units ?? { length: "", time: "s" },
  };
}

/** The poses of a mechanism without a solver, in the shape in which a solver gives them. */
function framesOf({ frames }, quantities) {
  return (frames ?? []).map(({ input, values, joints, slides }) => {
    const entries = quantities.map(({ name }, index) => [name, values[index]]);
    return { x: input, pose: values.length > 0 ? { ...Object.fromEntries(entries), joints, slides } : null };
  });
}

/** @typedef {ReturnType<typeof createModel>} Model */

/**
 * The design of the report.
 * @param {Model} model
 * @returns {Design}
 */
export function givenDesign(model) {
  return {
    parameters: Object.fromEntries(model.parameters.map(({ name, value }) => [name, value])),
    standing: Object.fromEntries(model.inputs.map(({ name, value }) => [name, value ?? 0])),
    speed: model.report.speed || 1,
  };
}

/**
 * @param {Design} one
 * @param {Design} other
 */
export function sameDesign(one, other) {
  const same = (left, right) => Object.keys(left).every((name) => left[name] === right[name]);
  return one.speed === other.speed && same(one.parameters, other.parameters) && same(one.standing, other.standing);
}

/**
 * The pose where the moving input has a value.
 * @param {Model} model
 * @param {Design} design
 * @param {number} input
 * @param {any} argument the assembly, or values nearby
 * @returns {Solved}
 */
export function solveAt(model, design, input, argument) {
  const inputs = {};
  for (const { name, speed = 0 } of model.inputs) {
    const time = (input - model.from) / design.speed;
    inputs[name] =
      name === model.moving.name
        ? [input, design.speed, 0, 0, 0]
        : [design.standing[name] + (speed ? speed * time : 0), speed || 0, 0, 0, 0];
  }
  return model.solver.solve(design.parameters, inputs, argument);
}

/**
 * The unknowns of a pose as values nearby, moved on by a change of the input.
 * @param {Model} model
 * @param {Design} design
 * @param {Pose} pose
 * @param {number} change
 */
export function valuesNear(model, design, pose, change = 0) {
  const time = change / design.speed;
  return Object.fromEntries(model.unknowns.map(({ name }) => [name, movedOn(pose[name], time)]));
}

/**
 * A Taylor polynomial.
 * @param {number[]} rates
 * @param {number} time
 */
export function movedOn(rates, time) {
  let sum = 0;
  for (let order = rates.length - 1; order >= 0; order -= 1) {
    sum = rates[order] + (sum * time) / (order + 1);
  }
  return sum;
}

/**
 * The names of a block with the texts of its unknowns.
 * @param {Model} model
 * @param {string} block
 */
export function blockText(model, block) {
  const text = (name) => model.quantities.find((quantity) => quantity.declared === name || quantity.name === name)?.text ?? name;
  return block.split(", ").map(text).join(", ");
}
