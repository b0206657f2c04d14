/** The pose in words, for the screen reader and for the line below the picture. */
import { motionOf } from "./kinematics/drive.mjs";
import { inputText } from "./kinematics/marks.mjs";
import { valueAt } from "./kinematics/sweep.mjs";
import { quantityText } from "./numbers.mjs";

/** The variable, the other inputs and the quantities shown, and the assembly if it has a name. */
export function poseText(model, row, degrees, assembly, shown) {
  const entry = (quantity, value) => `${quantity.text} = ${quantityText(value, quantity, model, degrees)}`;
  const values = shown.map((index) => entry(model.quantities[index], valueAt(model, row, index, 0)));
  const place = `${model.variable.text} = ${inputText(model, row.x, degrees)}`;
  // along a line the other inputs move as well; over time they are among the quantities
  const others = model.drive.overTime ? [] : model.moving.filter(({ name }) => name !== model.variable.name);
  const moving = others.map((input) => entry(input, motionOf(model.drive, input.index, row.x, row.piece, 1, 0)[0]));
  return `${[place, ...moving, ...values].join(", ")}${assembly ? `; ${assembly}` : ""}`;
}
