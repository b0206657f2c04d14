/** The pose in words, for the screen reader and for the line below the picture. */
import { motionOf } from "./drive.mjs";
import { inputText } from "./marks.mjs";
import { numberText, unitFactor, unitText, withUnit } from "./numbers.mjs";

/**
 * @param {import("./model.mjs").Model} model
 * @param {import("./sweep.mjs").Row} row
 * @param {boolean} degrees
 * @param {string} assembly
 * @param {number[]} shown
 */
export function poseText(model, row, degrees, assembly, shown) {
  const values = shown.map((index) => {
    const { name, text, dimension } = model.quantities[index];
    const value = (row.pose[name][0] + row.shifts[index]) * unitFactor(dimension, degrees);
    return `${text} = ${withUnit(numberText(value), unitText(dimension, 0, model.units, degrees))}`;
  });
  const place = `${model.variable.text} = ${inputText(model, row.x, degrees)}`;
  // along a line the other inputs move as well; over time they are among the quantities
  const others = (model.drive.overTime ? [] : model.moving.filter(({ name }) => name !== model.variable.name)).map(({ index, text, dimension }) => {
    const value = motionOf(model.drive, index, row.x, row.piece, 1, 0)[0] * unitFactor(dimension, degrees);
    return `${text} = ${withUnit(numberText(value), unitText(dimension, 0, model.units, degrees))}`;
  });
  return `${[place, ...others, ...values].join(", ")}${assembly ? `; ${assembly}` : ""}`;
}
