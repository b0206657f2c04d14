/** What can be taken away: tables as CSV, the picture as SVG and PNG, the report and the design as JSON. */
import { motionOf } from "./kinematics/drive.mjs";
import { made } from "./elements.mjs";
import { ORDERS, unitFactor, unitText } from "./numbers.mjs";
import { allRows, valueAt } from "./kinematics/sweep.mjs";

/** The properties of a drawn element that a style sheet sets. */
const STYLED = [
  "fill",
  "fill-opacity",
  "stroke",
  "stroke-width",
  "stroke-dasharray",
  "stroke-linecap",
  "stroke-linejoin",
  "stroke-opacity",
  "opacity",
  "font-size",
  "font-family",
  "font-style",
  "font-weight",
  "text-anchor",
];

/** All poses of a sweep as comma-separated values, every number with all its digits. */
export function sweepTable(sweep, degrees) {
  const { model, design } = sweep;
  const heading = (name, dimension, order) => {
    const unit = unitText(dimension, order, model.units, degrees).replace("°", "deg");
    return quotedCell(`${name}${order > 0 ? ` ${ORDERS[order]}` : ""}${unit ? ` [${unit}]` : ""}`);
  };
  const orders = [...Array(model.orders + 1).keys()];
  const columns = model.quantities.flatMap((quantity, index) => orders.map((order) => ({ quantity, index, order })));
  const { variable, drive } = model;
  // over time the inputs are among the quantities, with their rates
  const others = drive.overTime ? [] : model.moving.filter(({ name }) => name !== variable.name);
  const head = [
    heading(variable.declared, variable.dimension, 0),
    ...others.map(({ declared, dimension }) => heading(declared, dimension, 0)),
    ...(drive.overTime ? [] : [quotedCell(`time [${model.units.time}]`)]),
    ...columns.map(({ quantity, order }) => heading(quantity.declared, quantity.dimension, order)),
  ];
  const rows = allRows(sweep).map((row) => [
    row.x * unitFactor(variable.dimension, degrees),
    ...others.map(
      ({ index, dimension }) => motionOf(drive, index, row.x, row.piece, 1, 0)[0] * unitFactor(dimension, degrees),
    ),
    ...(drive.overTime ? [] : [(row.x - model.from) / design.speed]),
    ...columns.map(
      ({ quantity, index, order }) => valueAt(model, row, index, order) * unitFactor(quantity.dimension, degrees),
    ),
  ]);
  return [head, ...rows].map((row) => `${row.join(",")}\r\n`).join("");
}

/** A cell of a table of comma-separated values. */
export function quotedCell(text) {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** A picture of the page as a file of its own. */
export function pictureFile(svg, title) {
  const copy = svg.cloneNode(true);
  const originals = [...svg.querySelectorAll("*")];
  const copies = [...copy.querySelectorAll("*")];
  copies.forEach((element, index) => {
    const classes = element.getAttribute("class") ?? "";
    if (element.getAttribute("display") === "none" || /\bhit/.test(classes)) {
      element.remove();
      return;
    }
    const style = getComputedStyle(originals[index]);
    for (const property of STYLED) {
      const value = style.getPropertyValue(property);
      if (value && element.localName !== "g" && element.localName !== "title") {
        element.setAttribute(property, value);
      }
    }
    element.removeAttribute("class");
  });
  const { width, height } = svg.getBoundingClientRect();
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", String(Math.round(width)));
  copy.setAttribute("height", String(Math.round(height)));
  for (const name of ["class", "tabindex", "id", "aria-label", "role"]) {
    copy.removeAttribute(name);
  }
  const paper = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  paper.setAttribute("width", "100%");
  paper.setAttribute("height", "100%");
  paper.setAttribute("fill", getComputedStyle(document.body).backgroundColor);
  const name = document.createElementNS("http://www.w3.org/2000/svg", "title");
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
