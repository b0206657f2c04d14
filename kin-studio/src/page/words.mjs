/** The pose in words, for the screen reader and for the line below the picture. */
import { inputAt } from "./kinematics/drive.mjs";
import { inputText } from "./kinematics/marks.mjs";
import { valueAt } from "./kinematics/sweep.mjs";
import { quantityText } from "./numbers.mjs";

/** The variable, the other inputs and the quantities shown, and the assembly if it has a name. */
export function poseText(model, row, degrees, assembly, shown) {
  const entry = (quantity, value) => `${quantity.text} = ${quantityText(value, quantity, model, degrees)}`;
  const values = shown.map((index) => entry(model.quantities[index], valueAt(model, row, index, 0)));
  const position = `${model.variable.text} = ${inputText(model, row.x, degrees)}`;
  const others = model.others.map((input) => entry(input, inputAt(model.drive, input.index, row)));
  return `${[position, ...others, ...values].join(", ")}${assembly ? `; ${assembly}` : ""}`;
}
