/** Elements of the page and of its pictures. All texts are set as text. */

const SVG_SPACE = "http://www.w3.org/2000/svg";

/**
 * @param {string} name
 * @param {Record<string, string | number>} attributes
 * @param {Element | null} parent
 * @returns {SVGElement}
 */
export function drawn(name, attributes = {}, parent = null) {
  const element = document.createElementNS(SVG_SPACE, name);
  change(element, attributes);
  parent?.append(element);
  return element;
}

/**
 * @param {Element} element
 * @param {Record<string, string | number>} attributes
 */
export function change(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    element.setAttribute(name, String(value));
  }
}

/**
 * @param {string} name
 * @param {Record<string, unknown>} properties
 * @param {(Node | string)[]} children
 * @returns {HTMLElement}
 */
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

/**
 * The element of the page with an identity.
 * @param {string} name
 * @returns {any}
 */
export function part(name) {
  return document.getElementById(name);
}

/**
 * @param {number[][]} points
 * @param {boolean} closed
 */
export function line(points, closed = false) {
  let data = "";
  for (let index = 0; index < points.length; index += 1) {
    data += `${index === 0 ? "M" : "L"}${tenth(points[index][0])} ${tenth(points[index][1])}`;
  }
  return closed && points.length > 0 ? `${data}Z` : data;
}

/** @param {number} value */
export function tenth(value) {
  return Math.round(value * 10) / 10;
}

/**
 * Sets a text if it differs, which spares the browser work.
 * @param {Element} element
 * @param {string} text
 */
export function tell(element, text) {
  if (element.textContent !== text) {
    element.textContent = text;
  }
}
