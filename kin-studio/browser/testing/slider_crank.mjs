/**
 * A slider-crank by hand, in the shape of kin's solvers, for tests of the page's modules: crank r, rod l, slider at
 * s = r cos θ + √(l² - r² sin² θ).
 */

/** The product of two Taylor series. */
function times(one, other) {
  return one.map((_, order) =>
    one.slice(0, order + 1).reduce((sum, value, index) => sum + value * other[order - index], 0),
  );
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

/** Sine and cosine of a Taylor series: the derivative of each is the other one times that of the angle. */
function waves(angle) {
  const [sine, cosine] = [[Math.sin(angle[0])], [Math.cos(angle[0])]];
  for (let order = 1; order < angle.length; order += 1) {
    let [up, down] = [0, 0];
    for (let index = 1; index <= order; index += 1) {
      up += index * angle[index] * cosine[order - index];
      down -= index * angle[index] * sine[order - index];
    }
    sine.push(up / order);
    cosine.push(down / order);
  }
  return [sine, cosine];
}

function solve({ r, l }, { theta }, assembly) {
  const factors = [1, 1, 2, 6, 24];
  const [sine, cosine] = waves(factors.map((factor, order) => (theta[order] ?? 0) / factor));
  const height = sine.map((value) => r * value);
  const square = times(height, height).map((value, order) => (order === 0 ? l * l - value : -value));
  if (!(square[0] > 1e-300)) {
    return { ok: false, check: "reach of a circle and a line", block: "s", margin: l - Math.abs(height[0]) };
  }
  const near = root(square);
  const sign = assembly >= 0 ? 1 : -1;
  const s = cosine.map((value, order) => (r * value + sign * near[order]) * factors[order]);
  const joints = [
    [0, 0],
    [r * cosine[0], r * sine[0]],
    [s[0], 0],
  ];
  return { ok: true, pose: { s, joints, slides: [[1, 0]] } };
}

export const solver = { solve };

/** A report of it, with changes. The crank turns through the range, unless the drive is changed. */
export function reportOf(changes = {}) {
  const range = changes.range ?? [0, 2 * Math.PI];
  const quantity = (name, text, dimension, value) => ({
    name,
    key: name,
    text,
    documentation: "",
    dimension,
    ...(value === undefined ? {} : { value }),
  });
  return {
    format: 3,
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
    drive: { variable: "input", pieces: [{ from: range[0], to: range[1], at: 0, inputs: [[0, 1]] }], joints: [] },
    range,
    period: 2 * Math.PI,
    speed: 10,
    assemblies: [
      { name: "open", argument: 1, circuit: 0 },
      { name: "crossed", argument: -1, circuit: 1 },
    ],
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
      bodies: [
        { name: "r", joints: [0, 1] },
        { name: "l", joints: [1, 2] },
      ],
      slides: [{ joint: 2, guide: null }],
      points: [],
    },
    ...changes,
  };
}

/**
 * The same crank under a law: at rest until 0.1, up to 1 rad by a polynomial of the third degree, whose acceleration
 * jumps at both ends, and at rest from 0.5 on.
 */
export const LAW = {
  range: [0, 0.6],
  period: null,
  speed: 1,
  drive: {
    variable: "time",
    pieces: [
      { from: 0, to: 0.1, at: 0.05, inputs: [[0]] },
      // 3 u² - 2 u³ of u = (t - 0.1) / 0.4, about its middle
      { from: 0.1, to: 0.5, at: 0.3, inputs: [[0.5, 3.75, 0, -31.25]] },
      { from: 0.5, to: 0.6, at: 0.55, inputs: [[1]] },
    ],
    joints: [
      { at: 0.1, order: 2 },
      { at: 0.5, order: 2 },
    ],
  },
};

/** Forces by formulas of the variable at some samples: one on the rod by the crank, one of the guide, and an effort. */
export function forcesOf(samples, speed) {
  const sample = (x) => ({
    input: x,
    forces: [
      [50 * Math.cos(2 * x), 20 * Math.sin(x), -100 * speed * Math.sin(2 * x), 20 * speed * Math.cos(x)],
      [0, 3 + Math.sin(x), 0, speed * Math.cos(x)],
    ],
    curves: [[2 * Math.sin(x), 2 * speed * Math.cos(x)]],
    loads: [[7, -1, 10 + x, 4], [x]],
  });
  const peak = { value: Math.hypot(50, 20), at: Math.PI / 2, rms: 40, rate: 100 * speed };
  return {
    metres: 0.001,
    joints: [
      { name: "pin", on: 1, by: 0, joint: 1, is_slide: false, peak },
      { name: "guide", on: 1, by: null, joint: 2, is_slide: true, peak: null },
    ],
    curves: [{ name: "theta_effort", text: "effort of θ", kind: "moment", peak: null }],
    body_loads: [
      { body: 1, kind: "mass", is_couple: false },
      { body: 0, kind: "drive", is_couple: true },
    ],
    samples: samples.map(sample),
    unknown: null,
  };
}
