/** The drawer: a slider and a field for each dimension, for the inputs that stand, and for the speed of a line. */
import { made, setText } from "./elements.mjs";
import { numberText, quantityText, unitFactor, unitText } from "./numbers.mjs";

/**
 * @typedef {{group: "parameters" | "standing" | "speed", order: number, name: string, declared: string, text: string,
 *   note: string, dimension: string}} Entry
 */

export function createSliders(parent, model, given, changed) {
  const lengths = model.parameters
    .filter(({ dimension }) => dimension === "length")
    .map(({ value }) => Math.abs(value));
  const size = Math.max(...lengths, 1e-9);
  let degrees = model.degrees;
  const entries = entriesOf(model).map((entry) => {
    const id = `${entry.group}-${entry.name}`;
    const slider = made("input", { type: "range", id, step: "any" });
    const field = made("input", { type: "number", step: "any", "aria-label": `${entry.text}, as a number` });
    const unit = made("span", { className: "quiet-text" });
    const label = made("label", { for: id, title: entry.note }, entry.text);
    const head = made("div", { className: "row" }, label, made("span", {}, field, " ", unit));
    const note = entry.note ? [made("p", { className: "quiet-text" }, entry.note)] : [];
    const caution = made("p", { className: "caution", role: "status" });
    const box = made("div", { className: "dimension" }, head, slider, caution, ...note);
    parent.append(box);
    const factor = () => unitFactor(entry.dimension, degrees);
    const last = () => quantityText(Number(slider.value) / factor(), entry, model, degrees);
    for (const input of [slider, field]) {
      input.addEventListener("input", () => {
        setText(caution, cautionOf(entry, input.value, valueIn(given, entry), last()));
        if (isTaken(entry, input.value)) {
          changed(entry.group, entry.name, Number(input.value) / factor());
        }
      });
    }
    field.addEventListener("blur", () => {
      if (!isTaken(entry, field.value)) {
        field.value = String(Number(Number(slider.value).toPrecision(8)));
        setText(caution, cautionOf(entry, field.value, valueIn(given, entry), ""));
      }
    });
    const [low, high] = boundsOf(entry, valueIn(given, entry), size);
    return { entry, slider, field, unit, caution, box, low, high, factor };
  });
  if (model.drive.overTime && model.moving.length > 0) {
    const names = model.moving.map(({ text }) => text).join(", ");
    const words = model.moving.length > 1 ? "move under laws, which keep" : "moves under a law, which keeps";
    parent.append(
      made(
        "p",
        { className: "quiet-text" },
        `${names} ${words} to their times and values whatever the dimensions are.`,
      ),
    );
  }
  return {
    show(design, inDegrees) {
      degrees = inDegrees;
      for (const { entry, slider, field, unit, caution, box, low, high, factor } of entries) {
        const value = valueIn(design, entry) * factor();
        slider.min = String(low * factor());
        slider.max = String(high * factor());
        slider.value = String(value);
        const text = String(Number(value.toPrecision(8)));
        if (document.activeElement !== field) {
          field.value = text;
          setText(caution, cautionOf(entry, text, valueIn(given, entry), ""));
        }
        unit.textContent = unitText(entry.dimension, entry.order, model.units, degrees);
        slider.setAttribute("aria-valuetext", `${numberText(value)} ${unit.textContent}`);
        box.classList.toggle("changed", valueIn(design, entry) !== valueIn(given, entry));
      }
    },
  };
}

/** Whether what was typed is a value of an entry. */
function isTaken({ group }, typed) {
  const value = Number(typed);
  return typed !== "" && Number.isFinite(value) && !(group === "speed" && value === 0);
}

/**
 * The remark on a value that was typed, or an empty text.
 * @param {number} usual the value of the report
 * @param {string} last the value that is shown, with its unit
 */
export function cautionOf(entry, typed, usual, last) {
  if (!isTaken(entry, typed)) {
    return `${typed === "" ? "This is no number" : "A speed is not zero"}: ${last} is still shown.`;
  }
  const value = Number(typed);
  if (
    entry.group !== "parameters" ||
    entry.dimension !== "length" ||
    entry.declared.includes(".") ||
    !(usual > 0) ||
    value > 0
  ) {
    return "";
  }
  return value === 0
    ? "A link of length zero joins its pins into one."
    : "A link of a negative length points half a turn away from its angle; an offset lies on the other side.";
}

function entriesOf(model) {
  const { parameters, inputs } = model;
  const entry =
    (group, order) =>
    ({ name, text, declared, documentation, dimension }) => ({
      group,
      order,
      name,
      declared,
      dimension,
      text: text || name,
      note: (documentation ?? "").replaceAll("`", ""),
    });
  const standing = inputs.filter(({ moves }) => !moves).map(entry("standing", 0));
  const { text, dimension } = model.variable;
  const speed = {
    group: "speed",
    order: 1,
    name: "speed",
    declared: "speed",
    text: `Speed of ${text}`,
    note: "",
    dimension,
  };
  // laws determine the speed
  return [...parameters.map(entry("parameters", 0)), ...standing, ...(model.drive.overTime ? [] : [speed])];
}

function valueIn(design, { group, name }) {
  return group === "speed" ? design.speed : design[group][name];
}

/** The range of a slider. */
function boundsOf({ dimension, group }, value, size) {
  if (group !== "speed" && dimension === "angle") {
    return [value - Math.PI, value + Math.PI];
  }
  if (value === 0) {
    const reach = dimension === "length" ? 0.5 * size : 1;
    return [-reach, reach];
  }
  return value > 0 ? [0.2 * value, 2 * value] : [2 * value, 0.2 * value];
}
