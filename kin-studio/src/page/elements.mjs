/** Elements of the page and of its pictures. All texts are set as text. */

const SVG_SPACE = "http://www.w3.org/2000/svg";

/** A new element of a picture. @returns {SVGElement} */
export function drawn(name, attributes = {}, parent = null) {
  const element = document.createElementNS(SVG_SPACE, name);
  change(element, attributes);
  parent?.append(element);
  return element;
}

/** Sets attributes. */
export function change(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    element.setAttribute(name, String(value));
  }
}

/** A new element of the page. @returns {HTMLElement} */
export function made(name, properties = {}, ...children) {
  const element = document.createElement(name);
  for (const [property, value] of Object.entries(properties)) {
    if (property.startsWith("aria-") || property === "role" || property === "scope" || property === "for") {
      element.setAttribute(property, String(value));
    } else {
      element[property] = value;
    }
  }
  element.append(...children);
  return element;
}

/** A choice among values with their words, and what is done with the chosen one. */
export function choice(label, entries, chosen, action) {
  const options = entries.map(([value, words]) => made("option", { value, selected: value === chosen }, words));
  const select = made("select", { "aria-label": label }, ...options);
  select.addEventListener("change", () => action(select.value));
  return select;
}

/** A box to tick. */
export function tick(properties, action) {
  const box = made("input", { type: "checkbox", ...properties });
  box.addEventListener("change", () => action(box.checked));
  return box;
}

/** A button. */
export function button(words, properties, action) {
  const element = made("button", { type: "button", ...properties }, words);
  element.addEventListener("click", action);
  return element;
}

/** A table with a head and rows of cells, or of what becomes a cell. */
export function table(head, rows, className = "") {
  const cellOf = (content) => (content.cellIndex === undefined ? made("td", { className }, content) : content);
  const heads = head.map((text) => made("th", { scope: "col", className }, text));
  const body = rows.map((row) => made("tr", {}, ...row.map(cellOf)));
  return made("table", {}, made("thead", {}, made("tr", {}, ...heads)), made("tbody", {}, ...body));
}

/** A list of terms with what belongs to them. */
export function definitions(entries) {
  return made("dl", {}, ...entries.flatMap(([term, text]) => [made("dt", {}, term), made("dd", {}, text)]));
}

/** The element of the page with an identity. @returns {any} */
export function part(name) {
  return document.getElementById(name);
}

/** A line through points as the data of a path, to a tenth of a pixel. */
export function line(points, closed = false) {
  const data = points.map(([x, y], index) => `${index === 0 ? "M" : "L"}${tenth(x)} ${tenth(y)}`).join("");
  return closed && points.length > 0 ? `${data}Z` : data;
}

/** A number to one decimal. */
export function tenth(value) {
  return Math.round(value * 10) / 10;
}

/** Sets a text if it differs, which spares the browser work. */
export function setText(element, text) {
  if (element.textContent !== text) {
    element.textContent = text;
  }
}
