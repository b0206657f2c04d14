/** The drawing on the screen, in the notation of books on mechanisms. */
import { change, drawn, line, setText, tenth } from "../../kin-studio/src/page/elements.mjs";
import { createRoom, keepLines, keepSquare, placeName } from "../../kin-studio/src/page/labels.mjs";
import {
  arcOfDrive,
  arrowHead,
  belowOf,
  BLOCK,
  blockOf,
  footOf,
  hatch,
  hull,
} from "../../kin-studio/src/page/notation.mjs";
import { numberText } from "../../kin-studio/src/page/numbers.mjs";
import { pool } from "../../kin-studio/src/page/pool.mjs";
import { lengthOf, sidesOf } from "./model/lengths.mjs";
import { drivenFrom, isDriven, linksAt, numberOf, pivotOf, slidesAt } from "./model/sketch.mjs";
import { createHits } from "./hits.mjs";
import { handlesOf, REACH } from "./slide-handle.mjs";

const LAYERS = [
  "grid",
  "rails",
  "ground",
  "marks",
  "bars",
  "blocks",
  "pins",
  "drives",
  "handles",
  "names",
  "loose-end",
];
const COLOURS = 6;

/**
 * @typedef {object} Scene
 * @property {import("./model/sketch.mjs").Sketch} sketch as it is shown
 * @property {number[][]} places where the points are in the picture
 * @property {import("../../kin-studio/src/page/view.mjs").View} view
 * @property {number} step of the grid, in the drawing's unit
 * @property {number} width
 * @property {number} height
 * @property {import("./model/sketch.mjs").Part | null} selection
 * @property {{points: number[], links: number[], slides: number[]}} faulty
 * @property {{from: number[] | null, to: number[], text: string} | null} looseEnd of what is being drawn, in pixels
 * @property {number[] | null} pen where the keyboard draws
 */

export function createPicture(svg) {
  const layers = Object.fromEntries(
    LAYERS.map((name) => [name, pool(drawn("g", { class: name, "aria-hidden": "true" }, svg))]),
  );
  const hits = createHits(svg);
  return {
    hits,
    /** @param {Scene} scene */
    draw(scene) {
      const room = createRoom(scene.width, scene.height);
      for (const name of LAYERS) {
        layers[name].begin();
      }
      grid(layers.grid, scene);
      scene.sketch.slides.forEach((_, slide) => rail(layers, scene, slide, room));
      scene.sketch.ground.forEach((point) => foot(layers.ground, scene.places[point], room));
      marks(layers.marks, scene);
      scene.sketch.links.forEach((_, link) => bar(layers.bars, scene, link, room));
      scene.sketch.slides.forEach((_, slide) => block(layers.blocks, scene, slide, room));
      scene.sketch.points.forEach((_, point) => pin(layers.pins, scene, point, room));
      drives(layers.drives, scene, room);
      handles(layers.handles, scene, room);
      names(layers.names, scene, room);
      looseEnd(layers["loose-end"], scene);
      for (const name of LAYERS) {
        layers[name].end();
      }
      hits.draw(scene);
    },
  };
}

function grid(layer, { view, step, width, height }) {
  for (const [every, style] of [
    [1, "grid-line"],
    [5, "grid-line fifth"],
  ]) {
    const long = every * step;
    let data = "";
    for (let x = Math.ceil(-view.x / view.scale / long) * long; x * view.scale + view.x < width; x += long) {
      data += `M${tenth(x * view.scale + view.x)} 0V${height}`;
    }
    for (let y = Math.floor(view.y / view.scale / long) * long; view.y - y * view.scale < height; y -= long) {
      data += `M0 ${tenth(view.y - y * view.scale)}H${width}`;
    }
    layer.add("path", { d: data, class: style });
  }
  const long = 5 * step * view.scale;
  layer.add("path", { d: `M12 ${height - 16}V${height - 12}H${tenth(12 + long)}V${height - 16}`, class: "scale-line" });
  setText(layer.add("text", { x: tenth(19 + long), y: height - 11, class: "quiet" }), numberText(5 * step));
}

/** The direction of a slide in the picture. */
function directionOf({ sketch }, slide) {
  const { direction } = sketch.slides[slide];
  return [Math.cos(direction), -Math.sin(direction)];
}

/** The line of a slide: the ground below it, or a rod of the link that carries it. */
function rail({ ground, rails }, scene, slide, room) {
  const { point, on } = scene.sketch.slides[slide];
  const [x, y] = scene.places[point];
  const along = directionOf(scene, slide);
  const moved = (length, [offX, offY] = [0, 0]) => [x + length * along[0] + offX, y + length * along[1] + offY];
  if (on === "ground") {
    const below = belowOf(along);
    const shift = below.map((value) => value * (BLOCK[1] + 1));
    const ends = [moved(-REACH, shift), moved(REACH, shift)];
    ground.add("path", { d: line(ends), class: "ground-line" });
    ground.add("path", { d: hatch(ends[0], ends[1], below), class: "hatch" });
    keepLines(room, ends, 6);
    return;
  }
  const origin = scene.sketch.links[on].points[0];
  if (origin === undefined) {
    return;
  }
  const [fromX, fromY] = scene.places[origin];
  const start = (fromX - x) * along[0] + (fromY - y) * along[1];
  const ends = [Math.min(start, -REACH), Math.max(start, REACH)].map((length) => moved(length));
  rails.add("path", { d: line([[fromX, fromY], moved(start)]), class: "rod" });
  rails.add("path", { d: line(ends), class: "rod" });
  keepLines(room, ends, 3);
}

function foot(layer, place, room) {
  const { foot: data, base, hatching } = footOf(place);
  layer.add("path", { d: data, class: "foot" });
  layer.add("path", { d: base, class: "ground-line" });
  layer.add("path", { d: hatching, class: "hatch" });
  room.boxes.push([place[0] - 15, place[1] - 5, place[0] + 15, place[1] + 22]);
}

/** The outline of a link in the picture. */
function outlineOf({ sketch, places }, link) {
  const outer = hull(sketch.links[link].points.map((point) => places[point]));
  return outer.length === 1 ? [outer[0], outer[0]] : outer;
}

/** What is selected or at fault, below the parts. */
function marks(layer, scene) {
  const { sketch, places, selection, faulty } = scene;
  const ofLink = (link, style) => {
    const outer = outlineOf(scene, link);
    layer.add("path", { d: line(outer, outer.length > 2), class: `mark ${style}` });
  };
  const ofPoint = (point, style) => {
    layer.add("circle", { cx: tenth(places[point][0]), cy: tenth(places[point][1]), r: 11, class: `mark ${style}` });
  };
  faulty.links.forEach((link) => sketch.links[link] && ofLink(link, "at-fault"));
  const slides = faulty.slides.filter((slide) => sketch.slides[slide]).map((slide) => sketch.slides[slide].point);
  [...faulty.points, ...slides].forEach((point) => places[point] && ofPoint(point, "at-fault"));
  if (selection !== null) {
    (selection.kind === "link" ? ofLink : ofPoint)(selection.index, "selected");
  }
}

/** The colour of a link: that of drives, if it is driven. */
function colourOf(sketch, link) {
  const slides = sketch.slides.filter((slide, index) => isDriven(sketch, index) && slide.guided === link);
  return drivenFrom(sketch, link) !== null || slides.length > 0 ? "driven" : `c${link % COLOURS}`;
}

function bar(layer, scene, link, room) {
  const outer = outlineOf(scene, link);
  const plate = outer.length > 2 ? " plate" : "";
  const d = line(outer, outer.length > 2);
  layer.add("path", { d, class: `bar-edge${plate}` });
  layer.add("path", { d, class: `bar${plate} ${colourOf(scene.sketch, link)}` });
  keepLines(room, outer, 8, outer.length > 2);
}

function block(layer, scene, slide, room) {
  const { point, guided } = scene.sketch.slides[slide];
  const colour = guided === null ? "" : ` of-link ${colourOf(scene.sketch, guided)}`;
  layer.add("path", { d: blockOf(scene.places[point], directionOf(scene, slide)), class: `block${colour}` });
  keepSquare(room, scene.places[point], 13);
}

/** What turns the lines of the slides of a selected pin. */
function handles(layer, { sketch, places, selection }, room) {
  for (const { place } of handlesOf(sketch, places, selection)) {
    layer.add("circle", { cx: tenth(place[0]), cy: tenth(place[1]), r: 6, class: "slide-handle" });
    keepSquare(room, place, 8);
  }
}

/** A bore of a link; a joint of several bodies has a pin in it. A ram that is one with its block has none. */
function pin(layer, { sketch, places }, point, room) {
  const [x, y] = places[point];
  const links = linksAt(sketch, point);
  const bodies = links.length + slidesAt(sketch, point).length + (sketch.ground.includes(point) ? 1 : 0);
  const guided = slidesAt(sketch, point).map((slide) => sketch.slides[slide].guided);
  if (links.length > 1 || !links.some((link) => guided.includes(link))) {
    layer.add("circle", { cx: tenth(x), cy: tenth(y), r: bodies > 1 ? 4.6 : 3.2, class: "pin" });
    if (bodies > 1) {
      layer.add("circle", { cx: tenth(x), cy: tenth(y), r: 1.3, class: "pin-centre" });
    }
  }
  keepSquare(room, [x, y], 8);
}

/** Curved arrows around driven joints, straight ones along driven slides. */
function drives(layer, scene, room) {
  const { sketch, places } = scene;
  const arrow = (shaft) => {
    layer.add("path", { d: line(shaft), class: "drive" });
    layer.add("path", { d: arrowHead(shaft[shaft.length - 1], shaft[shaft.length - 2]), class: "drive-head" });
    keepLines(room, [shaft[0], shaft[shaft.length >> 1], shaft[shaft.length - 1]], 4);
  };
  for (const { angle, slide } of sketch.drives) {
    if (angle) {
      const pivot = pivotOf(sketch, angle.of);
      const arm = sketch.links[angle.of].points.find((point) => point !== pivot);
      if (arm !== undefined) {
        const [centre, end] = [places[pivot], places[arm]];
        arrow(arcOfDrive(centre, Math.atan2(centre[1] - end[1], end[0] - centre[0]), 1, 25));
      }
    } else {
      const [x, y] = places[sketch.slides[slide].point];
      const along = directionOf(scene, slide);
      const above = belowOf(along).map((value) => -19 * value);
      arrow([-20, 20].map((length) => [x + length * along[0] + above[0], y + length * along[1] + above[1]]));
    }
  }
}

function names(layer, { sketch, places, selection }, room) {
  const write = (around, text, style) => {
    const position = placeName(room, around, text, 14);
    if (position !== null) {
      setText(layer.add("text", { x: tenth(position.x), y: tenth(position.y + 4.6), class: `name ${style}` }), text);
    }
  };
  sketch.points.forEach(({ name }, point) => write([places[point]], name, "of-point"));
  const middle = ([x, y], [toX, toY], part = 0.5) => [x + part * (toX - x), y + part * (toY - y)];
  if (selection?.kind === "link") {
    for (const [from, to] of sidesOf(sketch.links[selection.index])) {
      write([middle(places[from], places[to])], numberText(lengthOf(sketch, from, to), 4), "of-length");
    }
  }
  sketch.links.forEach(({ name, points }, link) => {
    const [first, second] = points;
    if (second !== undefined) {
      const around = [0.5, 0.35, 0.65].map((part) => middle(places[first], places[second], part));
      write(around, name || String(numberOf(link)), "of-body");
    }
  });
}

/** The link that is being drawn, and where the keyboard draws. */
function looseEnd(layer, { looseEnd: loose, pen }) {
  if (pen !== null) {
    const [x, y] = pen.map(tenth);
    layer.add("path", { d: `M${x - 13} ${y}h8m10 0h8M${x} ${y - 13}v8m0 10v8`, class: "pen" });
  }
  if (loose === null) {
    return;
  }
  const { from, to, text } = loose;
  if (from !== null) {
    layer.add("path", { d: line([from, to]), class: "loose" });
    layer.add("circle", { cx: tenth(from[0]), cy: tenth(from[1]), r: 4.6, class: "loose-pin" });
  }
  layer.add("circle", { cx: tenth(to[0]), cy: tenth(to[1]), r: 4.6, class: "loose-pin" });
  setText(layer.add("text", { x: tenth(to[0] + 14), y: tenth(to[1] - 12), class: "halo quiet" }), text);
}

/** Sets what a screen reader says of the whole drawing. */
export function describe(svg, sketch) {
  const count = (number, word) => `${number} ${word}${number === 1 ? "" : "s"}`;
  const words = [
    count(sketch.points.length, "point"),
    count(sketch.links.length, "link"),
    count(sketch.drives.length, "drive"),
  ];
  change(svg, { "aria-label": `Drawing of ${sketch.name || "a linkage"}: ${words.join(", ")}` });
}
