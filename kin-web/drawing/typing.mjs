/** Numbers as a person types them. */

export function typed(value) {
  return String(Number(value.toPrecision(7)));
}

/** The number of a text, which may have a comma or a minus sign of print; NaN if there is none. */
export function numberIn(text) {
  return text.trim() === "" ? NaN : Number(text.replace(",", ".").replace("−", "-"));
}

export const isLength = (number) => Number.isFinite(number) && number > 0;
