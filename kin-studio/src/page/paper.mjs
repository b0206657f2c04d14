/** The part of the page below the fold: peaks, sensitivities, equations, their solution, the declaration. */
import { createComparison } from "./comparison.mjs";
import { memberText } from "./curves.mjs";
import { inputAt } from "./kinematics/drive.mjs";
import { button, choice, definitions, drawn, made, table } from "./elements.mjs";
import { formulaOf } from "./formulas.mjs";
import { inputText } from "./kinematics/marks.mjs";
import { blockText } from "./kinematics/model.mjs";
import { createNotes } from "./notes.mjs";
import { capital, numberText, ORDERS, quantityText, unitFactor, unitText, withUnit } from "./numbers.mjs";
import { quotedCell } from "./saving.mjs";
import { valueAt } from "./kinematics/sweep.mjs";
import { poseText } from "./words.mjs";

/** The part of the larger extreme below which the smaller one is but rounding. */
const ROUNDING = 1e-14;

/**
 * @param {(x: number) => void} go moves the mechanism to a value of the variable
 */
export function createPaper(parent, model, go) {
  const { report } = model;
  const add = (title, ...content) => {
    const section = made("section", {}, made("h2", {}, title), ...content);
    parent.append(section);
    return section;
  };
  const notes = createNotes(add);
  if (report.documentation) {
    const paragraphs = report.documentation
      .split(/\n\s*\n/)
      .map((text) => made("p", {}, text.trim().replaceAll("`", "")));
    add("About", made("div", { className: "prose" }, ...paragraphs));
  }
  const showPose = poseTable(add, model);
  const peakTable = made("div", { className: "scroll" });
  const note = made("p", { className: "quiet-text" });
  let cells = [];
  const copy = button("Copy as CSV", { className: "no-print" }, () => {
    const text = cells.map((row) => `${row.map((cell) => quotedCell(String(cell))).join(",")}\r\n`).join("");
    copyText(text).then((done) => {
      copy.textContent = done ? "Copied" : "The browser refuses to copy";
      setTimeout(() => (copy.textContent = "Copy as CSV"), 1500);
    });
  });
  add("Peaks", peakTable, made("p", { className: "row" }, copy, note));
  const comparison = createComparison(add, model);
  const showForces = forces(add, model, go);
  const showSensitivities = sensitivities(add, model);
  equations(add, model);
  howSolved(add, model);
  declaration(add, model);
  manual(add, model);

  return {
    comparison,
    notes,
    showPose,
    showPeaks(peaks, degrees, source) {
      showForces(degrees);
      showSensitivities(degrees);
      const reasons = new Set((report.unanswered ?? []).map(({ text }) => text));
      note.textContent = reasons.size > 0 ? `${source} Not found: ${[...reasons].join("; ")}.` : source;
      const at = `at [${unitText(model.variable.dimension, 0, model.units, degrees)}]`;
      cells = [["quantity", "derivative", "unit", "highest", at, "lowest", at, "rms"]];
      const rows = peaks.map((peak, index) => {
        const quantity = { ...model.quantities.find(({ name }) => name === peak.quantity), order: peak.order };
        cells.push(numbersOf(model, peak, quantity, degrees));
        const swatch = made("span", { className: `legend c${quantity.colour}` });
        const isFirst = peak.quantity !== peaks[index - 1]?.quantity;
        const head = isFirst ? made("th", { scope: "row" }, swatch, ` ${quantity.text}`) : "";
        const derivative = made("td", { className: "words" }, ORDERS[peak.order]);
        return [head, derivative, ...textsOf(model, peak, quantity, degrees, go)];
      });
      peakTable.replaceChildren(table(["Quantity", "", "Highest", "at", "Lowest", "at", "RMS"], rows));
    },
  };
}

/** The values of all quantities with their derivatives at one pose. */
function poseTable(add, model) {
  const at = made("p", { className: "quiet-text" });
  const box = made("div", { className: "scroll" });
  add("Pose", at, box);
  const orders = ORDERS.slice(0, model.orders + 1);
  return (row, degrees) => {
    at.textContent = poseText(model, row, degrees, "", []);
    const rows = model.quantities.map((quantity, index) => [
      made("th", { scope: "row" }, made("span", { className: `legend c${quantity.colour}` }), ` ${quantity.text}`),
      ...orders.map((_, order) =>
        quantityText(valueAt(model, row, index, order), { ...quantity, order }, model, degrees, 6),
      ),
    ]);
    box.replaceChildren(table(["Quantity", ...orders], rows));
  };
}

/** A row of the peaks in numbers. */
function numbersOf(model, { highest, lowest, rms }, quantity, degrees) {
  const number = (value, { dimension }) =>
    value === null || value === undefined ? "" : value * unitFactor(dimension, degrees);
  const both = (peak) => [number(peak?.value, quantity), number(peak?.at, model.variable)];
  const unit = unitText(quantity.dimension, quantity.order, model.units, degrees);
  return [quantity.declared, ORDERS[quantity.order], unit, ...both(highest), ...both(lowest), number(rms, quantity)];
}

/** A row of the peaks in words, with buttons that go to them. */
function textsOf(model, { highest, lowest, rms }, quantity, degrees, go) {
  const text = (value) => quantityText(value, quantity, model, degrees, 6);
  // an extreme is zero if it is far below the other extreme
  const size = Math.max(Math.abs(highest?.value ?? 0), Math.abs(lowest?.value ?? 0));
  const rounded = (value) => (Math.abs(value) > ROUNDING * size ? value : 0);
  const both = (peak) => {
    if (!peak) {
      return ["–", ""];
    }
    const there = goToButton(model, peak.at, degrees, go);
    return [peak.value === null ? "unbounded" : text(rounded(peak.value)), there];
  };
  return [...both(highest), ...both(lowest), rms === null ? "–" : text(rms)];
}

async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = made("textarea", { value: text });
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }
}

/** The forces of joints and drives that a catalogue of bearings asks for. */
function forces(add, model, go) {
  const { forces: given } = model.report;
  if (!given) {
    return () => {};
  }
  const box = made("div", { className: "scroll" });
  const remarks = [
    "At the given dimensions, speed and assembly. The mean is the root of the mean square over time.",
    given.powers && powersText(given.powers),
    given.unknown && `Not all forces are known: ${given.unknown}`,
  ];
  add("Forces", box, ...remarks.filter(Boolean).map((text) => made("p", { className: "quiet-text" }, text)));
  const joints = given.joints.map(({ name, on, by, peak }) => [
    name,
    memberText(model, on),
    memberText(model, by),
    "N",
    peak,
  ]);
  const curves = given.curves.map(({ text, kind, peak }) => [text, "", "", kind === "force" ? "N" : "N m", peak]);
  return (degrees) => {
    const rows = [...joints, ...curves].map(([name, on, by, unit, peak]) => {
      const text = (value, end = "") => (typeof value === "number" ? `${numberText(value, 6)} ${unit}${end}` : "–");
      const words = [
        made("th", { scope: "row" }, name),
        ...[on, by].map((body) => made("td", { className: "words" }, body)),
      ];
      if (!peak) {
        return [...words, "–", "", "–", "–"];
      }
      const largest = peak.value === null ? "unbounded" : text(peak.value);
      const rate = text(peak.rate, `/${model.units.time}`);
      return [...words, largest, goToButton(model, peak.at, degrees, go), text(peak.rms), rate];
    });
    box.replaceChildren(table(["Force", "on", "by", "Peak", "at", "RMS", "Largest rate"], rows));
  };
}

/** What drives give and friction takes in the mean. */
function powersText({ input, heat, efficiency }) {
  const [given, taken] = [input, heat].map((power) => `${numberText(power, 6)} W`);
  const ratio = typeof efficiency === "number" ? `: the efficiency is ${numberText(efficiency, 6)}` : "";
  return `Drives give ${given} in the mean over time, and friction turns ${taken} into heat${ratio}.`;
}

/** A button that goes to a value of the variable. */
function goToButton(model, at, degrees, go) {
  const text = inputText(model, at, degrees);
  const there = button(text, { "aria-label": `Go to ${model.variable.text} = ${text}` }, () => go(at));
  there.dataset.at = String(at);
  return there;
}

/** The influence of dimensions on a peak: bars for the same part of each dimension, and the change for each unit. */
function sensitivities(add, model) {
  const all = model.report.sensitivities ?? [];
  if (all.length === 0) {
    return () => {};
  }
  let chosen = Math.max(
    0,
    all.findIndex(({ order }) => order === 2),
  );
  let last = false;
  const entries = all.map(({ quantity, text }, index) => [String(index), text || quantity]);
  const select = choice("Peak", entries, String(chosen), (index) => {
    chosen = Number(index);
    show(last);
  });
  const bars = made("div", { className: "sense" });
  const note = made("p", { className: "quiet-text" });
  add("Sensitivities", made("p", { className: "row" }, select), bars, note);
  const show = (degrees) => {
    const { quantity: name, order, values } = all[chosen];
    const dimension = model.quantities.find(({ declared }) => declared === name)?.dimension ?? "number";
    const unit = unitText(dimension, order, model.units, degrees);
    const effects = model.parameters.map(({ value }, index) => values[index] * value);
    const most = Math.max(...effects.map(Math.abs), 1e-300);
    const rows = model.parameters.flatMap(({ text, dimension: ofParameter }, index) => {
      const effect = (98 * effects[index]) / most;
      const bar = drawn("svg", { viewBox: "-100 0 200 14", preserveAspectRatio: "none", "aria-hidden": "true" });
      const rect = { x: Math.min(0, effect), width: Math.abs(effect), y: 2, height: 10 };
      drawn("rect", { ...rect, class: effect < 0 ? "bar-down" : "bar-up" }, bar);
      drawn("path", { d: "M0 0V14", class: "zero-line" }, bar);
      const rate = (values[index] * unitFactor(dimension, degrees)) / unitFactor(ofParameter, degrees);
      const each = unitText(ofParameter, 0, model.units, degrees);
      const number = `${withUnit(numberText(rate, 4), unit)}${each ? ` per ${each}` : ""}`;
      return [made("span", {}, text), bar, made("span", { className: "number" }, number)];
    });
    bars.replaceChildren(...rows);
    note.textContent =
      "Bars: the effect of the same part of each dimension. " +
      "Numbers: the change of the peak for each unit of the dimension.";
  };
  return (degrees) => {
    last = degrees;
    show(degrees);
  };
}

function equations(add, model) {
  const shown = ({ text, mathml }) => {
    const formula = mathml && formulaOf(mathml);
    const properties = { className: "formula", tabIndex: 0, role: "group", "aria-label": text || "formula" };
    return formula ? made("div", properties, formula) : made("pre", { tabIndex: 0 }, text);
  };
  const content = ["closure", "position", "velocity", "rates", "outputs"].flatMap((name) => {
    const formulas = [model.report.formulas?.[name] ?? []].flat().filter(({ text, mathml }) => text || mathml);
    const title = made("h3", {}, capital(name));
    return formulas.length > 0 ? [title, ...formulas.map(shown)] : [];
  });
  if (content.length > 0) {
    add("Equations", ...content);
  }
}

function howSolved(add, model) {
  const { blocks, operations } = model.report;
  const solutions = blocks.map(({ unknowns, solution }) => [blockText(model, unknowns), solution]);
  const costs = operations.map(({ order, text }) => [ORDERS[order] ?? String(order), text]);
  const tables = [
    table(["Unknowns", "Solution"], solutions, "words"),
    table(["Through", "Operations"], costs, "words"),
  ].filter((one) => one.tBodies[0].rows.length > 0);
  if (tables.length > 0) {
    add("How it was solved", ...tables.map((one) => made("div", { className: "scroll" }, one)));
  }
}

/** The effect of dragging: one input moves freely, and several inputs keep to their common motion. */
function dragText(model) {
  const stops = "it stops at limits";
  if (model.drive.overTime) {
    return `goes to the time at which the laws lead it nearest; the inputs keep to their laws, and ${stops}`;
  }
  return model.moving.length > 1
    ? `moves all inputs along their line to the nearest pose; ${stops}`
    : `moves the mechanism to the nearest pose; ${stops}`;
}

/** The gestures of the picture. */
function manual(add, model) {
  const beside = model.space
    ? ["Drag beside the links", "turns the view; with Shift it shifts the view"]
    : ["Drag the empty plane", "shifts the view"];
  const deeds = definitions([
    ["Drag a link", dragText(model)],
    ["Double click on a link", "draws the path of that point"],
    ...(model.report.forces?.joints.length > 0
      ? [
          [
            "Click on a link",
            "shows all forces on it, and what else acts on it, without the other links; Escape ends it",
          ],
        ]
      : []),
    beside,
    ["Click into a picture, then the wheel", "enlarges it; with Ctrl at once"],
    ["Point at a plot", "moves the mechanism; a drag enlarges that part, a double click shows all again"],
    ["Click on another assembly", "changes to it"],
    ["Arrow keys", "one part in 360 of the range; with Shift ten; Home and End go to the ends of what closes"],
    ["Space", "plays and pauses"],
  ]);
  add("Using this page", deeds).classList.add("no-print");
}

function declaration(add, model) {
  const { report } = model;
  const unit = (dimension, order) => unitText(dimension, order, model.units, false);
  const values = (list) =>
    list.map(({ declared, value, dimension }) => withUnit(`${declared} = ${value}`, unit(dimension, 0))).join(", ");
  const entries = [
    ["Mechanism", report.name],
    ["Dimensions", values(model.parameters)],
    [model.moving.length > 1 ? "Moving inputs" : "Moving input", motionText(model, unit)],
    ["Other inputs", values(model.inputs.filter(({ moves }) => !moves))],
    ["Assembly", report.assemblies[report.assembly]?.name],
    ["Written by", `kin ${report.kin}`],
    ["Hash", report.hash],
  ];
  const source = report.declaration ? [made("pre", { tabIndex: 0 }, report.declaration)] : [];
  add("Declaration", ...source, made("h3", {}, "This report"), definitions(entries.filter(([, text]) => text)));
}

/** The motion of the inputs, with all digits. */
function motionText(model, unit) {
  const { drive, variable } = model;
  const range = (from, to, dimension) =>
    `from ${withUnit(String(from), unit(dimension, 0))} to ${withUnit(String(to), unit(dimension, 0))}`;
  if (model.moving.length === 0) {
    return "none";
  }
  if (drive.overTime) {
    const names = model.moving.map(({ declared }) => declared).join(", ");
    return `${names} under ${model.moving.length > 1 ? "laws" : "a law"}, ${range(model.from, model.to, "time")}`;
  }
  const [first, last] = [
    { x: model.from, piece: 0 },
    { x: model.to, piece: drive.pieces.length - 1 },
  ];
  const ways = model.moving.map(({ declared, index, dimension, name }) => {
    const value = (sample) => (name === variable.name ? sample.x : inputAt(drive, index, sample));
    return `${declared} ${range(value(first), value(last), dimension)}`;
  });
  const speed = withUnit(String(model.report.speed), unit(variable.dimension, 1));
  return `${ways.join(", ")}, ${model.moving.length > 1 ? `${variable.declared} ` : ""}at ${speed}`;
}
