/** Mechanisms to start from, in the form of `kin_sketch::Sketch`. */

/** A drawing by words: points with their places, fixed points, links by the names of their points. */
function drawn(name, places, ground, links, others = {}) {
  const points = Object.entries(places).map(([point, [x, y]]) => ({ name: point, x, y }));
  const indexOf = (point) => points.findIndex((other) => other.name === point);
  return {
    name,
    points,
    ground: ground.split(" ").map(indexOf),
    links: links.map((link) => ({ name: "", points: link.split(" ").map(indexOf) })),
    slides: (others.slides ?? []).map(({ point, ...slide }) => ({ guided: null, ...slide, point: indexOf(point) })),
    drives: others.drives ?? [{ angle: { of: 0, to: "ground" } }],
  };
}

/** @type {{title: string, sketch: import("./model/sketch.mjs").Sketch}[]} */
export const examples = [
  {
    title: "Four-bar linkage",
    sketch: drawn("FourBar", { o: [1, 1], a: [1, 3], b: [5, 5], d: [6, 1], c: [3, 6] }, "o d", ["o a", "a b c", "d b"]),
  },
  {
    title: "Slider-crank",
    sketch: drawn("SliderCrank", { o: [0, 0], a: [0, 1], b: [3, 0] }, "o", ["o a", "a b"], {
      slides: [{ point: "b", on: "ground", direction: 0 }],
    }),
  },
  {
    title: "Inverted slider-crank",
    sketch: drawn("InvertedSlider", { o: [0, 0], a: [0, 1], d: [3, 0], t: [-3, 2] }, "o d", ["o a", "d t"], {
      slides: [{ point: "a", on: 1, direction: Math.atan2(1, -3) }],
    }),
  },
  {
    title: "Toggle clamp",
    sketch: drawn("ToggleClamp", { o: [0, 0], a: [1, 3], b: [3, 2.5], d: [3.5, 0], tip: [7, 1] }, "o d", [
      "o a",
      "a b",
      "d b tip",
    ]),
  },
  {
    title: "Watt's six-bar linkage",
    sketch: drawn(
      "Watt",
      { o: [0, 0], d: [4, 0], a: [0.8, 1.3], b: [4.2, 3], p: [-0.4, 1.6], q: [2.2, 3.6], t: [0.4, 4.2] },
      "o d",
      ["o a p", "a b q", "d b", "p t", "q t"],
    ),
  },
  {
    title: "Scissor lift",
    sketch: drawn(
      "ScissorLift",
      { o: [0, 0], f: [4, 0], m: [2, 1.5], t: [0, 3], u: [4, 3], v: [5, 3] },
      "o",
      ["o m u", "f m t", "t v"],
      {
        slides: [
          { point: "f", on: "ground", direction: 0 },
          { point: "u", on: 2, direction: 0 },
        ],
        drives: [{ slide: 0 }],
      },
    ),
  },
  {
    title: "Five-bar linkage",
    sketch: drawn(
      "FiveBar",
      { o: [0, 0], a: [-1, 2], c: [1.5, 4], b: [4, 2], d: [3, 0] },
      "o d",
      ["o a", "a c", "d b", "b c"],
      { drives: [0, 2].map((of) => ({ angle: { of, to: "ground" } })) },
    ),
  },
];
