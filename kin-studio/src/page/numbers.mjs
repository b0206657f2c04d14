/** Numbers and units as text. */

const SUPERSCRIPTS = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };

/** A word with a capital letter. */
export function capital(word) {
  return `${word[0].toUpperCase()}${word.slice(1)}`;
}

/** The names of the derivatives by time, from the position on. */
export const ORDERS = ["position", "velocity", "acceleration", "jerk", "snap"];

/**
 * A number with a true minus sign, and a power of ten where it is very large or small.
 * @param {number} digits significant ones; zeros at the end are left out
 * @returns {string}
 */
export function numberText(value, digits = 5) {
  if (!Number.isFinite(value)) {
    return Number.isNaN(value) ? "–" : value > 0 ? "∞" : "−∞";
  }
  if (value === 0) {
    return "0";
  }
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) {
    const [digitsPart, power] = value.toExponential(digits - 1).split("e");
    return `${minus(trimmed(digitsPart))}×10${raised(Number(power))}`;
  }
  return minus(
    trimmed(Number(value.toPrecision(digits)).toFixed(Math.max(0, digits - 1 - Math.floor(Math.log10(size))))),
  );
}

/**
 * A number with as many decimals as the largest number beside it needs for five digits, so that it does not jump about.
 * @param {number} scale the size of the largest one
 * @returns {string}
 */
export function steadyText(value, scale) {
  if (!Number.isFinite(value) || !(scale > 0) || scale >= 1e6 || scale < 1e-3) {
    return numberText(value, 4);
  }
  const decimals = Math.min(6, Math.max(0, 3 - Math.floor(Math.log10(scale))));
  const text = value.toFixed(decimals);
  return minus(Number(text) === 0 ? text.replace("-", "") : text);
}

function trimmed(text) {
  return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}

function minus(text) {
  return text.replace("-", "−");
}

/** A power as superscripts. */
export function raised(power) {
  return [...String(power)].map((letter) => SUPERSCRIPTS[letter]).join("");
}

/** The unit of a quantity's derivative by time; an empty text if there is none. */
export function unitText(dimension, order, units, degrees) {
  const bases = { angle: degrees ? "°" : "rad", length: units.length, time: units.time };
  const base = bases[dimension] ?? "";
  if (order === 0) {
    return base;
  }
  return `${base || "1"}/${units.time}${order > 1 ? raised(order) : ""}`;
}

/** A number and its unit, with the space that belongs between them. */
export function withUnit(number, unit) {
  return unit === "" ? number : unit.startsWith("°") ? `${number}${unit}` : `${number} ${unit}`;
}

/** A derivative of a quantity with its unit. */
export function quantityText(value, { dimension, order = 0 }, { units }, degrees, digits = 5) {
  return withUnit(
    numberText(value * unitFactor(dimension, degrees), digits),
    unitText(dimension, order, units, degrees),
  );
}

/** The factor from radians. */
export function unitFactor(dimension, degrees) {
  return dimension === "angle" && degrees ? 180 / Math.PI : 1;
}

/**
 * Round numbers that divide a range: multiples of 1, 2 or 5 times a power of ten, or of parts of a revolution in
 * degrees.
 * @param {number} count about how many
 * @returns {number[]}
 */
export function ticks(low, high, count, degrees = false) {
  const rough = (high - low) / Math.max(1, count);
  if (!(rough > 0) || !Number.isFinite(rough)) {
    return [];
  }
  const power = 10 ** Math.floor(Math.log10(rough));
  let step = power * ([1, 2, 5, 10].find((factor) => factor * power >= rough * 0.999) ?? 10);
  if (degrees && rough > 5 && rough < 400) {
    step = [10, 15, 30, 45, 60, 90, 180, 360].find((part) => part >= rough * 0.74) ?? 720;
  }
  const numbers = [];
  for (let index = Math.ceil(low / step - 1e-9); index * step <= high + 1e-9 * step; index += 1) {
    numbers.push(index * step || 0);
  }
  return numbers;
}
