/** What stands below the fold: peaks, sensitivities, equations, how it was solved, the declaration. */
import { motionOf } from "./kinematics/drive.mjs";
import { drawn, made } from "./elements.mjs";
import { formulaOf } from "./formulas.mjs";
import { inputText } from "./kinematics/marks.mjs";
import { numberText, ORDERS, quantityText, unitFactor, unitText, withUnit } from "./numbers.mjs";
import { quotedCell } from "./saving.mjs";

/** The part of the larger extreme below which the smaller one is but rounding. */
const ROUNDING = 1e-14;

/**
 * @param {(x: number) => void} go moves the mechanism to a place of the range
 */
export function createPaper(place, model, go) {
  const { report } = model;
  const add = (title, ...content) => {
    const section = made("section", {}, made("h2", {}, title), ...content);
    place.append(section);
    return section;
  };
  if (report.documentation) {
    const paragraphs = report.documentation
      .split(/\n\s*\n/)
      .map((text) => made("p", {}, text.trim().replaceAll("`", "")));
    add("About", made("div", { className: "prose" }, ...paragraphs));
  }
  const body = made("tbody");
  const note = made("p", { className: "quiet-text" });
  const copy = made("button", { type: "button", className: "no-print" }, "Copy as CSV");
  const head = made(
    "thead",
    {},
    made(
      "tr",
      {},
      ...["Quantity", "", "Highest", "at", "Lowest", "at", "RMS"].map((text) => made("th", { scope: "col" }, text)),
    ),
  );
  add(
    "Peaks",
    made("div", { className: "scroll" }, made("table", {}, head, body)),
    made("p", { className: "row" }, copy, note),
  );
  let cells = [];
  copy.addEventListener("click", () => {
    const text = cells.map((row) => `${row.map((cell) => quotedCell(String(cell))).join(",")}\r\n`).join("");
    copyText(text).then((done) => {
      copy.textContent = done ? "Copied" : "The browser refuses to copy";
      setTimeout(() => (copy.textContent = "Copy as CSV"), 1500);
    });
  });
  const showSensitivities = sensitivities(add, model);
  equations(add, model);
  howSolved(add, model);
  declaration(add, model);
  manual(add, model);

  return {
    showPeaks(peaks, degrees, source) {
      showSensitivities(degrees);
      const reasons = new Set((report.unanswered ?? []).map(({ text }) => text));
      note.textContent = reasons.size > 0 ? `${source} Not found: ${[...reasons].join("; ")}.` : source;
      const unit = (quantity, order) => unitText(quantity.dimension, order, model.units, degrees);
      const inputUnit = unitText(model.variable.dimension, 0, model.units, degrees);
      cells = [
        ["quantity", "derivative", "unit", "highest", `at [${inputUnit}]`, "lowest", `at [${inputUnit}]`, "rms"],
      ];
      body.replaceChildren();
      for (const { quantity: name, order, highest, lowest, rms } of peaks) {
        const quantity = model.quantities.find((one) => one.name === name);
        if (!quantity) {
          continue;
        }
        const factor = unitFactor(quantity.dimension, degrees);
        const inputFactor = unitFactor(model.variable.dimension, degrees);
        const size = Math.max(Math.abs(highest?.value ?? 0), Math.abs(lowest?.value ?? 0));
        const value = (peak) => {
          if (!peak) {
            return "–";
          }
          // beside the other extreme, what is left of a zero by rounding is zero
          const own = Math.abs(peak.value) > ROUNDING * size ? peak.value : 0;
          return peak.value === null ? "unbounded" : quantityText(own, { ...quantity, order }, model, degrees, 6);
        };
        const at = (peak) => {
          if (!peak) {
            return "";
          }
          const button = made(
            "button",
            { type: "button", "aria-label": `Go to ${model.variable.text} = ${inputText(model, peak.at, degrees)}` },
            inputText(model, peak.at, degrees),
          );
          button.dataset.at = String(peak.at);
          button.addEventListener("click", () => go(peak.at));
          return button;
        };
        const mean = rms === null ? "–" : quantityText(rms, { ...quantity, order }, model, degrees, 6);
        const swatch = made("span", { className: `legend c${quantity.colour}` });
        body.append(
          made(
            "tr",
            {},
            order === 0 || body.lastChild?.dataset?.name !== name
              ? made("th", { scope: "row" }, swatch, ` ${quantity.text}`)
              : made("td"),
            made("td", { className: "words" }, ORDERS[order]),
            made("td", {}, value(highest)),
            made("td", {}, at(highest)),
            made("td", {}, value(lowest)),
            made("td", {}, at(lowest)),
            made("td", {}, mean),
          ),
        );
        body.lastChild.dataset.name = name;
        const number = (peak, part, by) => (peak && peak[part] !== null ? peak[part] * by : "");
        cells.push([
          quantity.declared,
          ORDERS[order],
          unit(quantity, order),
          number(highest, "value", factor),
          number(highest, "at", inputFactor),
          number(lowest, "value", factor),
          number(lowest, "at", inputFactor),
          rms === null ? "" : rms * factor,
        ]);
      }
    },
  };
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

/** Which dimension moves the peak: bars for the same part of each dimension, and the change for each unit of it. */
function sensitivities(add, model) {
  const all = model.report.sensitivities ?? [];
  if (all.length === 0) {
    return () => {};
  }
  const select = made(
    "select",
    { "aria-label": "Peak" },
    ...all.map(({ quantity, text }, index) => made("option", { value: String(index) }, text || quantity)),
  );
  const first = all.findIndex(({ order }) => order === 2);
  select.value = String(Math.max(0, first));
  const table = made("div", { className: "sense" });
  const note = made("p", { className: "quiet-text" });
  add("Sensitivities", made("p", { className: "row" }, select), table, note);
  const show = (degrees) => {
    const { quantity: name, order, values } = all[Number(select.value)];
    const dimension = model.quantities.find(({ declared }) => declared === name)?.dimension ?? "number";
    const unit = unitText(dimension, order, model.units, degrees);
    const effects = model.parameters.map(({ value }, index) => values[index] * value);
    const most = Math.max(...effects.map(Math.abs), 1e-300);
    const rows = model.parameters.flatMap(({ text, dimension: own }, index) => {
      const effect = (98 * effects[index]) / most;
      const bar = drawn("svg", { viewBox: "-100 0 200 14", preserveAspectRatio: "none", "aria-hidden": "true" });
      drawn(
        "rect",
        {
          x: Math.min(0, effect),
          width: Math.abs(effect),
          y: 2,
          height: 10,
          class: effect < 0 ? "bar-down" : "bar-up",
        },
        bar,
      );
      drawn("path", { d: "M0 0V14", class: "zero-line" }, bar);
      const rate = (values[index] * unitFactor(dimension, degrees)) / unitFactor(own, degrees);
      const each = unitText(own, 0, model.units, degrees);
      return [
        made("span", {}, text),
        bar,
        made("span", { className: "number" }, `${withUnit(numberText(rate, 4), unit)}${each ? ` per ${each}` : ""}`),
      ];
    });
    table.replaceChildren(...rows);
    note.textContent =
      "Bars: the effect of the same part of each dimension. " +
      "Numbers: the change of the peak for each unit of the dimension.";
  };
  let last = false;
  select.addEventListener("change", () => show(last));
  return (degrees) => {
    last = degrees;
    show(degrees);
  };
}

function equations(add, model) {
  const { formulas } = model.report;
  if (!formulas) {
    return;
  }
  const content = [];
  const titles = { closure: "Closure", position: "Position", velocity: "Velocity", rates: "Rates", outputs: "Outputs" };
  const walk = (value) => {
    if (Array.isArray(value)) {
      value.forEach(walk);
    } else if (value && typeof value === "object") {
      if (typeof value.mathml === "string" || typeof value.text === "string") {
        const formula = value.mathml ? formulaOf(value.mathml) : null;
        const text = value.text ?? "";
        if (formula === null && text === "") {
          return;
        }
        content.push(
          formula
            ? made(
                "div",
                { className: "formula", tabIndex: 0, role: "group", "aria-label": text || "formula" },
                formula,
              )
            : made("pre", { tabIndex: 0 }, text),
        );
      } else {
        Object.values(value).forEach(walk);
      }
    }
  };
  for (const [name, value] of Object.entries(formulas)) {
    const before = content.length;
    walk(value);
    if (content.length > before) {
      content.splice(before, 0, made("h3", {}, titles[name] ?? name));
    }
  }
  if (content.length > 0) {
    add("Equations", ...content);
  }
}

function howSolved(add, model) {
  const { blocks = [], operations = [] } = model.report;
  const head = (...texts) =>
    made("thead", {}, made("tr", {}, ...texts.map((text) => made("th", { scope: "col", className: "words" }, text))));
  const row = (...texts) => made("tr", {}, ...texts.map((text) => made("td", { className: "words" }, text)));
  const names = (text) =>
    text
      .split(", ")
      .map((name) => model.quantities.find((one) => one.declared === name)?.text ?? name)
      .join(", ");
  const tables = [];
  if (blocks.length > 0) {
    tables.push(
      made(
        "table",
        {},
        head("Unknowns", "Solution"),
        made("tbody", {}, ...blocks.map(({ unknowns, solution }) => row(names(unknowns), solution))),
      ),
    );
  }
  if (operations.length > 0) {
    tables.push(
      made(
        "table",
        {},
        head("Through", "Operations"),
        made("tbody", {}, ...operations.map(({ order, text }) => row(ORDERS[order] ?? String(order), text))),
      ),
    );
  }
  if (tables.length > 0) {
    add("How it was solved", ...tables.map((table) => made("div", { className: "scroll" }, table)));
  }
}

/** What dragging does: an input alone is free, and several keep to their common motion. */
function dragText(model) {
  const stops = "it stops at limits";
  if (model.drive.overTime) {
    return `goes to the time at which the laws lead it nearest; the inputs keep to their laws, and ${stops}`;
  }
  return model.moving.length > 1
    ? `moves all inputs along their line to the nearest pose; ${stops}`
    : `moves the mechanism to the nearest pose; ${stops}`;
}

/** What hands can do. */
function manual(add, model) {
  const list = made("dl");
  for (const [deed, effect] of [
    ["Drag a link", dragText(model)],
    ["Double click on a link", "draws the path of that point"],
    [
      model.space ? "Drag beside the links" : "Drag the empty plane",
      model.space ? "turns the view; with Shift it shifts the view" : "shifts the view",
    ],
    ["Click into a picture, then the wheel", "enlarges it; with Ctrl at once"],
    ["Point at a plot", "moves the mechanism; a drag enlarges that part, a double click shows all again"],
    ["Click on another assembly", "changes to it"],
    ["Arrow keys", "one part in 360 of the range; with Shift ten; Home and End go to the ends of what closes"],
    ["Space", "plays and pauses"],
  ]) {
    list.append(made("dt", {}, deed), made("dd", {}, effect));
  }
  add("Using this page", list).classList.add("no-print");
}

function declaration(add, model) {
  const { report } = model;
  const list = made("dl");
  const entry = (name, text) => text && list.append(made("dt", {}, name), made("dd", {}, text));
  const { parameters } = report;
  const unit = (dimension, order) => unitText(dimension, order, model.units, false);
  entry("Mechanism", report.name);
  entry(
    "Dimensions",
    parameters.map(({ name, value, dimension }) => withUnit(`${name} = ${value}`, unit(dimension, 0))).join(", "),
  );
  entry(model.moving.length > 1 ? "Moving inputs" : "Moving input", motionText(model, unit));
  const others = model.inputs
    .filter(({ moves }) => !moves)
    .map(({ declared: name, value, dimension }) => ({ name, value, dimension }));
  entry(
    "Other inputs",
    others.map(({ name, value, dimension }) => withUnit(`${name} = ${value}`, unit(dimension, 0))).join(", "),
  );
  entry("Assembly", report.assemblies?.[report.assembly]?.name);
  entry("Written by", `kin ${report.kin}`);
  entry("Hash", report.hash);
  const source = report.declaration ? [made("pre", { tabIndex: 0 }, report.declaration)] : [];
  add("Declaration", ...source, made("h3", {}, "This report"), list);
}

/** How the inputs move, with all digits. */
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
  const last = drive.pieces.length - 1;
  const value = (index, x, piece) => motionOf(drive, index, x, piece, 1, 0)[0];
  const ways = model.moving.map(({ declared, index, dimension, name }) => {
    const ends =
      name === variable.name ? [model.from, model.to] : [value(index, model.from, 0), value(index, model.to, last)];
    return `${declared} ${range(ends[0], ends[1], dimension)}`;
  });
  const speed = withUnit(String(model.report.speed), unit(variable.dimension, 1));
  return `${ways.join(", ")}, ${model.moving.length > 1 ? `${variable.declared} ` : ""}at ${speed}`;
}
