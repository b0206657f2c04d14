/**
 * A slider-crank by hand, in the shape of kin's solvers, for tests of the page's modules: crank r, rod l, and the slider at
 * s = r cos θ + √(l² - r² sin² θ).
 */

/** The product of two Taylor series. */
function times(one, other) {
  return one.map((_, order) => one.slice(0, order + 1).reduce((sum, value, index) => sum + value * other[order - index], 0));
}

/** The square root of a Taylor series. */
function root(series) {
  const found = [Math.sqrt(series[0])];
  for (let order = 1; order < series.length; order += 1) {
    let rest = series[order];
    for (let index = 1; index < order; index += 1) {
      rest -= found[index] * found[order - index];
    }
    found.push(rest / (2 * found[0]));
  }
  return found;
}

/** Sine and cosine of an angle that grows at a constant speed. */
function waves(angle, speed) {
  const factors = [1, 1, 2, 6, 24];
  return [0, 0.5 * Math.PI].map((shift) => factors.map((factor, order) => (Math.sin(angle + shift + 0.5 * Math.PI * order) * speed ** order) / factor));
}

function solve({ r, l }, { theta }, assembly) {
  const [angle, speed = 0] = theta;
  const [sine, cosine] = waves(angle, speed);
  const height = sine.map((value) => r * value);
  const square = times(height, height).map((value, order) => (order === 0 ? l * l - value : -value));
  if (!(square[0] > 1e-300)) {
    return { ok: false, check: "reach of a circle and a line", block: "s", margin: l - Math.abs(height[0]) };
  }
  const near = root(square);
  const sign = assembly >= 0 ? 1 : -1;
  const factors = [1, 1, 2, 6, 24];
  const s = cosine.map((value, order) => (r * value + sign * near[order]) * factors[order]);
  const joints = [[0, 0], [r * cosine[0], r * sine[0]], [s[0], 0]];
  return { ok: true, pose: { s, joints, slides: [[1, 0]] } };
}

export const solver = { solve, OUTLINE: {}, CHECKS: [] };

/** A report of it, with changes. */
export function reportOf(changes = {}) {
  const quantity = (name, text, dimension, value) => ({ name, key: name, text, documentation: "", dimension, ...(value === undefined ? {} : { value }) });
  return {
    format: 1,
    kin: "0.1.0",
    title: "Slider-crank",
    name: "SliderCrank",
    module: "slider_crank",
    documentation: "",
    declaration: null,
    hash: "00",
    units: { length: "mm", time: "s" },
    degrees: true,
    order: 4,
    parameters: [quantity("r", "r", "length", 30), quantity("l", "l", "length", 80)],
    inputs: [quantity("theta", "θ", "angle")],
    unknowns: [quantity("s", "s", "length")],
    outputs: [],
    plots: ["s"],
    moving: 0,
    range: [0, 2 * Math.PI],
    period: 2 * Math.PI,
    speed: 10,
    assemblies: [{ name: "open", argument: 1, circuit: 0 }, { name: "crossed", argument: -1, circuit: 1 }],
    assembly: 0,
    coupled: false,
    space: false,
    cycle: null,
    extremes: [],
    rms: [],
    transmission: null,
    sensitivities: [],
    formulas: null,
    blocks: [],
    operations: [],
    not_closed: null,
    outline: {
      ground: [0],
      bodies: [{ name: "r", joints: [0, 1] }, { name: "l", joints: [1, 2] }],
      slides: [{ joint: 2, guide: null }],
      points: [],
    },
    ...changes,
  };
}
