/** The pose in words, for the screen reader and for the line below the picture. */
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
  const place = `${model.moving.text} = ${inputText(model, row.x, degrees)}`;
  return `${[place, ...values].join(", ")}${assembly ? `; ${assembly}` : ""}`;
}
