/** The curves of the plots: quantities with their rates, and forces with theirs. */
import { ABOVE, forcesAt, sizeOf } from "./kinematics/forces.mjs";
import { isUnbounded, valueAt } from "./kinematics/sweep.mjs";
import { capital, ORDERS, unitFactor, unitText } from "./numbers.mjs";

/**
 * @typedef {object} Curve
 * @property {string} name
 * @property {string} column its name in tables
 * @property {string} text
 * @property {string} documentation
 * @property {number} colour
 * @property {boolean} dashed
 * @property {number} above so many orders the drive must have more for a derivative to be continuous
 * @property {{value: number, at: number} | null} peak that is marked
 * @property {(row: any, order: number) => number} value
 * @property {(degrees: boolean) => number} factor from the value to the one that is shown
 * @property {(order: number, degrees: boolean) => string} unit
 * @property {(sweep: any, order: number) => number} scale the size of a derivative
 * @property {(sweep: any, row: any, order: number) => boolean} isUnbounded
 */

/** The groups of curves, each with its words. */
const WORDS = { angle: "Angles", length: "Lengths", number: "Numbers", force: "Forces", moment: "Moments" };

/** The curves of a mechanism by their groups, with the titles of their rows. */
export function curvesOf(model) {
  const groups = [...new Set(model.quantities.map(({ dimension }) => dimension))].map((name) => ({
    name,
    words: WORDS[name] ?? name,
    titles: ORDERS.slice(0, model.orders + 1).map(capital),
    curves: model.quantities.flatMap((quantity, index) =>
      quantity.dimension === name ? [ofQuantity(model, quantity, index)] : [],
    ),
  }));
  const forces = model.report.forces ? [forceGroup(model), momentGroup(model)] : [];
  return [...groups, ...forces.filter(({ curves }) => curves.length > 0)];
}

function ofQuantity(model, quantity, index) {
  const { name, text, documentation, colour, dashed, dimension } = quantity;
  return {
    name,
    column: quantity.declared,
    text,
    documentation,
    colour,
    dashed,
    above: 0,
    peak: null,
    value: (row, order) => valueAt(model, row, index, order),
    factor: (degrees) => unitFactor(dimension, degrees),
    unit: (order, degrees) => unitText(dimension, order, model.units, degrees),
    scale: (sweep, order) => sweep.scales[index][order],
    isUnbounded: (sweep, row, order) => isUnbounded(sweep, row, index, order),
  };
}

/** The curve of a force, whose value and rate come from those at a row. */
function ofForce(model, { column, text, documentation, unit, peak }, index, valueOf) {
  const value = (row, order) => valueOf(forcesAt(model, row))?.[order] ?? NaN;
  let scales = null;
  return {
    // no quantity has a name with a blank
    name: `force ${column}`,
    column,
    text,
    documentation,
    colour: index % 6,
    dashed: index >= 6,
    above: ABOVE,
    peak: typeof peak?.value === "number" ? peak : null,
    value,
    factor: () => 1,
    unit: (order) => `${unit}${order > 0 ? `/${model.units.time}` : ""}`,
    scale(sweep, order) {
      scales ??= [0, 1].map((order) =>
        sweep.spans
          .flatMap(({ rows }) => rows)
          .reduce((size, row) => Math.max(size, Math.abs(value(row, order)) || 0), 0),
      );
      return scales[order];
    },
    isUnbounded: () => false,
  };
}

/** The words for what a force is of. */
export function memberText(model, member) {
  return member === null ? "ground" : model.outline.bodies[member].name;
}

function forceGroup(model) {
  const { joints, curves } = model.report.forces;
  const ofJoints = joints.map((joint, index) => {
    const documentation = `on ${memberText(model, joint.on)}, by ${memberText(model, joint.by)}`;
    const head = { column: `${joint.name}_force`, text: joint.name, documentation, unit: "N", peak: joint.peak };
    return { ...ofForce(model, head, index, ({ forces }) => forces[index] && sizeOf(forces[index])), joint: index };
  });
  const others = ofKind(model, curves, "force", ofJoints.length);
  return {
    name: "force",
    words: WORDS.force,
    titles: ["Force", "Rate"],
    curves: [...ofJoints, ...others],
  };
}

function momentGroup(model) {
  const curves = ofKind(model, model.report.forces.curves, "moment", 0);
  return { name: "moment", words: WORDS.moment, titles: ["Moment", "Rate"], curves };
}

function ofKind(model, all, kind, first) {
  const ofThisKind = all.flatMap((curve, index) => (curve.kind === kind ? [{ ...curve, index }] : []));
  return ofThisKind.map(({ name, text, peak, index }, offset) => {
    const head = { column: name, text, documentation: "", unit: kind === "force" ? "N" : "N m", peak };
    return ofForce(model, head, first + offset, ({ curves }) => curves[index]);
  });
}
