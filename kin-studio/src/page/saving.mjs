/** The files that a reader may save: tables as CSV, the picture as SVG and PNG, the report and the design as JSON. */
import { inputAt } from "./kinematics/drive.mjs";
import { change, drawn, made } from "./elements.mjs";
import { ORDERS, unitFactor, unitText } from "./numbers.mjs";
import { allRows, valueAt } from "./kinematics/sweep.mjs";

/** The properties of a drawn element that a style sheet sets. */
const STYLED = (
  "fill fill-opacity fill-rule stroke stroke-width stroke-dasharray stroke-linecap stroke-linejoin stroke-opacity " +
  "opacity font-size font-family font-style font-weight text-anchor"
).split(" ");

/** All poses of a sweep as comma-separated values, every number with all its digits. */
export function sweepTable(sweep, degrees) {
  const { model, design } = sweep;
  const heading = (name, dimension, order) => {
    const unit = unitText(dimension, order, model.units, degrees).replace("°", "deg");
    return quotedCell(`${name}${order > 0 ? ` ${ORDERS[order]}` : ""}${unit ? ` [${unit}]` : ""}`);
  };
  const orders = [...Array(model.orders + 1).keys()];
  const columns = model.quantities.flatMap((quantity, index) => orders.map((order) => ({ quantity, index, order })));
  const { variable, drive, others } = model;
  const time = drive.overTime
    ? []
    : [{ head: quotedCell(`time [${model.units.time}]`), at: (x) => (x - model.from) / design.speed }];
  const head = [
    ...[variable, ...others].map(({ declared, dimension }) => heading(declared, dimension, 0)),
    ...time.map((column) => column.head),
    ...columns.map(({ quantity, order }) => heading(quantity.declared, quantity.dimension, order)),
  ];
  const inUnit = (value, { dimension }) => value * unitFactor(dimension, degrees);
  const rows = allRows(sweep).map((row) => [
    inUnit(row.x, variable),
    ...others.map((input) => inUnit(inputAt(drive, input.index, row), input)),
    ...time.map(({ at }) => at(row.x)),
    ...columns.map(({ quantity, index, order }) => inUnit(valueAt(model, row, index, order), quantity)),
  ]);
  return [head, ...rows].map((row) => `${row.join(",")}\r\n`).join("");
}

/** A cell of a table of comma-separated values. */
export function quotedCell(text) {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** Whether an element is a part of a picture that is handed over. */
export function isDrawn(element) {
  return element.getAttribute("display") !== "none" && !/\bhit/.test(element.getAttribute("class") ?? "");
}

/** What the style sheet says of an element, as attributes. */
export function styleOf(element) {
  const style = getComputedStyle(element);
  const properties = STYLED.map((property) => [property, style.getPropertyValue(property)]);
  return Object.fromEntries(properties.filter(([, value]) => value));
}

/** A picture of the page as a separate file. */
export function pictureFile(svg, title) {
  const copy = svg.cloneNode(true);
  const originals = [...svg.querySelectorAll("*")];
  const copies = [...copy.querySelectorAll("*")];
  copies.forEach((element, index) => {
    if (!isDrawn(element)) {
      element.remove();
      return;
    }
    if (element.localName !== "g" && element.localName !== "title") {
      change(element, styleOf(originals[index]));
    }
    element.removeAttribute("class");
  });
  return asFile(copy, svg, title);
}

/** A copy of a picture as the text of a file, with its size, its paper and its title. */
export function asFile(copy, svg, title) {
  const { width, height } = svg.getBoundingClientRect();
  change(copy, { xmlns: "http://www.w3.org/2000/svg", width: Math.round(width), height: Math.round(height) });
  for (const name of ["class", "tabindex", "id", "aria-label", "role"]) {
    copy.removeAttribute(name);
  }
  const paper = drawn("rect", { width: "100%", height: "100%", fill: getComputedStyle(document.body).backgroundColor });
  const name = drawn("title");
  name.textContent = title;
  copy.prepend(name, paper);
  return `${new XMLSerializer().serializeToString(copy)}\n`;
}

/** A picture of the page as pixels, twice as many as on the screen. @returns {Promise<Blob>} */
export async function pictureOfPixels(svg, title) {
  const { width, height } = svg.getBoundingClientRect();
  const source = URL.createObjectURL(new Blob([pictureFile(svg, title)], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = source;
    await image.decode();
    const canvas = made("canvas", { width: Math.round(2 * width), height: Math.round(2 * height) });
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((done, failed) => {
      canvas.toBlob(
        (blob) => (blob ? done(blob) : failed(new Error("the browser draws no picture of this size"))),
        "image/png",
      );
    });
  } finally {
    URL.revokeObjectURL(source);
  }
}

/** Hands a file to the reader. */
export function handOver(name, content) {
  const link = made("a", { href: URL.createObjectURL(content), download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
