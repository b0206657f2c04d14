/** The page as a file that opens as it was left: with the reader's dimensions, view and notes. */

import { made, part } from "./elements.mjs";

/** The identity of the element that holds what is kept. */
const KEPT = "kept";

/** This page as it is before its script changes it. @returns {HTMLElement} */
export function pageAsWritten() {
  return document.documentElement.cloneNode(true);
}

/** The text of a page with the state in which it shall open. @param {HTMLElement} written as it was written */
export function pageKeeping(written, state) {
  const page = written.cloneNode(true);
  page.querySelector(`#${KEPT}`)?.remove();
  const element = made("script", { type: "application/json", id: KEPT });
  // no text may end the element
  const letters = { "<": "\\u003c", ">": "\\u003e", "\u2028": "\\u2028", "\u2029": "\\u2029" };
  element.textContent = JSON.stringify(state).replace(/[<>\u2028\u2029]/g, (letter) => letters[letter]);
  page.querySelector("#report").before(element, "\n");
  return `<!doctype html>\n${page.outerHTML}\n`;
}

/** The state that a page keeps, or null. */
export function keptState() {
  const text = part(KEPT)?.textContent;
  return text ? JSON.parse(text) : null;
}

/** A kept design with the names that a given one has. */
export function designLike(given, kept) {
  const like = (group) =>
    Object.fromEntries(Object.entries(given[group]).map(([name, value]) => [name, kept?.[group]?.[name] ?? value]));
  return { parameters: like("parameters"), standing: like("standing"), speed: kept?.speed || given.speed };
}
