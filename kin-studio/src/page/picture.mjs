/** The mechanism to scale: ground, links, sliders, pins, paths, arrows and names. */
import { coordinatesOf } from "./kinematics/anatomy.mjs";
import { acrossOf } from "./kinematics/axes.mjs";
import { change, drawn, line, setText, tenth } from "./elements.mjs";
import { createRoom, keepLines, keepSquare, placeName } from "./labels.mjs";
import { arcOfDrive, arrowHead, belowOf, BLOCK, blockOf, footOf, hatch, hull, unitOf } from "./notation.mjs";
import { numberText, ticks, withUnit } from "./numbers.mjs";
import { gearsAt } from "./kinematics/gears.mjs";
import { alongSlide } from "./kinematics/sweep.mjs";
import { ROUNDING } from "./kinematics/tolerances.mjs";
import { pool } from "./pool.mjs";
import { rackOf, teethOf } from "./teeth.mjs";
import { flat, isTurned, onPage } from "./view.mjs";

const LAYERS = [
  "grid",
  "trails",
  "ghosts",
  "reference",
  "ground",
  "gears",
  "bodies",
  "sliders",
  "over",
  "pins",
  "marks",
  "arrows",
  "forces",
  "names",
  "hits",
];

/** Half the length of an axis of space, in parts of the mechanism, and the radius of a bearing, in pixels. */
const AXIS = 0.16;
const BEARING = 13;

/**
 * @typedef {object} Scene
 * @property {import("./view.mjs").View} view
 * @property {number} width
 * @property {number} height
 * @property {any} pose
 * @property {import("./kinematics/anatomy.mjs").Anatomy} anatomy
 * @property {import("./kinematics/sweep.mjs").Sweep} sweep
 * @property {{name: boolean, [option: string]: boolean}} shows
 * @property {any[]} followed
 * @property {string} still what grid and trails depend on: they are drawn again when it differs
 * @property {() => {points: number[][], colour: string, closed: boolean}[]} trails in the mechanism's coordinates
 * @property {{pose: any, index: number, colour: string, title: string, name: string}[]} ghosts
 * @property {any} reference another pose, or null
 * @property {{from: number[], by: number[], order: number}[]} arrows by, in pixels
 * @property {{centre: number[], radius: number, at: number[]}[]} circles
 * @property {{at: number[], name: string}[]} centres
 * @property {{key: string, at: number[], by: number[], part: number, kind: string, title: string,
 *   text: string}[]} forces by, in pixels; or a couple as a part of the largest one
 * @property {{long: number, text: string} | null} newton how long the arrow of a force is, in pixels
 * @property {number | null} free the body that is seen alone
 * @property {number[]} senses for each body the sense in which its input turns it: 1, -1, or 0 if none does
 * @property {boolean} moves whether names should keep their positions
 */

export function createPicture(svg, model) {
  const layers = Object.fromEntries(LAYERS.map((name) => [name, pool(drawn("g", { class: name }, svg))]));
  const choices = new Map();
  let still = "";
  let kept = createRoom(0, 0);
  return {
    draw(scene) {
      const room = createRoom(scene.width, scene.height);
      const joints = scene.pose.joints.map((joint) => onPage(scene.view, joint));
      if (still !== scene.still) {
        still = scene.still;
        kept = createRoom(scene.width, scene.height);
        grid(layers.grid, model, scene, kept);
        trails(layers.trails, layers.over, scene, kept);
      }
      room.lines.push(...kept.lines);
      room.boxes.push(...kept.boxes);
      ghosts(layers.ghosts, model, scene);
      outlines(layers.reference, model, scene, scene.reference);
      ground(layers.ground, model, scene, joints, room);
      gears(layers.gears, scene);
      bodies(layers.bodies, layers.hits, model, scene, joints, room);
      sliders(layers.sliders, model, scene, joints, room);
      pins(layers.pins, model, scene, joints, room);
      marks(layers.marks, model, scene, joints, room);
      arrows(layers.arrows, scene, room);
      forces(layers.forces, scene, room);
      names(layers.names, model, scene, joints, room, choices);
    },
  };
}

function grid(layer, model, { view, width, height }, room) {
  layer.begin();
  const step = gridStep(view.scale);
  if (!model.space) {
    let data = "";
    for (let x = Math.ceil(-view.x / view.scale / step) * step; x * view.scale + view.x < width; x += step) {
      data += `M${tenth(x * view.scale + view.x)} 0V${height}`;
    }
    for (let y = Math.ceil(-view.y / view.scale / step) * step; y * view.scale + view.y < height; y += step) {
      data += `M0 ${tenth(y * view.scale + view.y)}H${width}`;
    }
    layer.add("path", { d: data, class: "grid-line" });
  }
  const length = step * view.scale;
  const [left, foot] = [12, height - 12];
  layer.add("path", { d: `M${left} ${foot - 4}V${foot}H${tenth(left + length)}V${foot - 4}`, class: "scale-line" });
  const text = withUnit(numberText(step), model.units.length);
  setText(layer.add("text", { x: tenth(left + length + 7), y: foot, class: "quiet" }), text);
  keepSquare(room, [left + 0.5 * length, foot], 0.5 * length);
  if (model.space) {
    const corner = [width - 40, height - 34];
    for (const [name, axis] of [
      ["x", [1, 0, 0]],
      ["y", [0, 1, 0]],
      ["z", [0, 0, 1]],
    ]) {
      const [x, y] = flat(view, axis);
      layer.add("path", { d: line([corner, [corner[0] + 20 * x, corner[1] + 20 * y]]), class: "scale-line" });
      const at = { x: tenth(corner[0] + 28 * x), y: tenth(corner[1] + 28 * y + 4), class: "quiet middle" };
      setText(layer.add("text", at), name);
    }
    if (!isTurned(view)) {
      setText(layer.add("text", { x: left, y: 16, class: "quiet" }), "Drag beside the links to turn the view");
    }
  }
  layer.end();
}

function gridStep(scale) {
  const marks = ticks(0, 320 / scale, 5);
  return marks.length > 1 ? marks[1] : 1 / scale;
}

/** Paths below the links, and faintly above them, where they would be hidden. */
function trails(layer, over, { view, trails: all }, room) {
  layer.begin();
  over.begin();
  for (const { points, colour, closed } of all()) {
    const seen = points.map((point) => onPage(view, point));
    const d = line(seen, closed);
    layer.add("path", { d, class: `trail ${colour}` });
    over.add("path", { d, class: `trail over ${colour}` });
    const sparse = seen.filter((_, index) => index % 12 === 0);
    keepLines(room, sparse, 1.5);
  }
  layer.end();
  over.end();
}

/** Another pose as thin lines. */
function outlines(layer, model, scene, pose, attributes = {}) {
  layer.begin();
  if (pose) {
    layer.add("path", { d: thinLines(model, scene, pose), class: "thin", ...attributes });
  }
  layer.end();
}

function ghosts(layer, model, scene) {
  layer.begin();
  for (const { pose, index, colour, title } of scene.ghosts) {
    const d = thinLines(model, scene, pose);
    layer.add("path", { d, class: `ghost ${colour}` });
    const hit = layer.add("path", { d, class: "ghost hit-ghost", "data-assembly": index });
    const name = hit.firstChild ?? drawn("title", {}, hit);
    setText(name, title);
  }
  layer.end();
}

function thinLines(model, scene, pose) {
  const joints = pose.joints.map((joint) => onPage(scene.view, joint));
  return model.outline.bodies
    .map((_, body) => cornersOf(model, scene, body, joints, pose))
    .map((corners) => line(hull(corners), corners.length > 2))
    .join("");
}

/** The ends of a slide's line: how far its joint comes in the sweep. */
function guideOf(model, scene, slide, pose) {
  const { joint } = model.outline.slides[slide];
  const direction = pose.slides[slide];
  const length = Math.hypot(...direction);
  const here = alongSlide(model, pose, slide);
  const travel = scene.sweep.travel[slide].map((end) => (Number.isFinite(end) ? end : here));
  return travel.map((end) =>
    onPage(
      scene.view,
      pose.joints[joint].map((value, axis) => value + (direction[axis] / length) * (end - here)),
    ),
  );
}

/** Whether a slide is the stroke of a cylinder: it is driven, or seen in space. */
function isCylinder(model, scene, slide) {
  return model.outline.slides[slide].guide !== null && (model.space || scene.anatomy.drivenSlides[slide]);
}

/** Whether a slide stands: its joint keeps its position on the body, whose length is an input that does not move. */
function standsStill(model, scene, slide) {
  const [low, high] = scene.sweep.travel[slide];
  return model.outline.slides[slide].guide !== null && high - low <= ROUNDING * Math.max(Math.abs(low), Math.abs(high));
}

function cornersOf(model, scene, body, joints, pose) {
  const corners = model.outline.bodies[body].joints.map((joint) => joints[joint]);
  model.outline.slides.forEach(({ joint, guide }, slide) => {
    if (guide !== body) {
      return;
    }
    if (isCylinder(model, scene, slide) || standsStill(model, scene, slide)) {
      corners.push(joints[joint]);
    } else {
      const [from, to] = guideOf(model, scene, slide, pose);
      const [x, y] = unitOf(from, to);
      corners.push([from[0] - BLOCK[0] * x, from[1] - BLOCK[0] * y], [to[0] + BLOCK[0] * x, to[1] + BLOCK[0] * y]);
    }
  });
  return corners;
}

function ground(layer, model, scene, joints, room) {
  layer.begin();
  model.outline.slides.forEach(({ guide }, slide) => {
    if (guide !== null) {
      return;
    }
    const [start, end] = guideOf(model, scene, slide, scene.pose);
    const [x, y] = directionOf(model, scene, slide);
    const below = belowOf([x, y]);
    const shift = (point, sign) => [
      point[0] + sign * 18 * x + below[0] * (BLOCK[1] + 1),
      point[1] + sign * 18 * y + below[1] * (BLOCK[1] + 1),
    ];
    const forward = (end[0] - start[0]) * x + (end[1] - start[1]) * y >= 0;
    const [from, to] = forward ? [shift(start, -1), shift(end, 1)] : [shift(end, -1), shift(start, 1)];
    layer.add("path", { d: line([from, to]), class: "ground-line" });
    layer.add("path", { d: hatch(from, to, below), class: "hatch" });
    keepLines(room, [from, to], 6);
  });
  if (model.space) {
    groundOfSpace(layer, model, scene, joints, room);
    layer.end();
    return;
  }
  joints.forEach(([x, y], joint) => {
    if (!scene.anatomy.pins[joint] || !scene.anatomy.fixed[joint]) {
      return;
    }
    const { foot, base, hatching } = footOf([x, y]);
    layer.add("path", { d: foot, class: "foot" });
    layer.add("path", { d: base, class: "ground-line" });
    layer.add("path", { d: hatching, class: "hatch" });
    room.boxes.push([x - 15, y - 5, x + 15, y + 22]);
  });
  layer.end();
}

/** The ground link, and the bearings of its joints: a disc at right angles to each axis, or a socket for a ball. */
function groundOfSpace(layer, model, scene, joints, room) {
  const { ground: fixed } = model.outline;
  // of each shaft, the first bearing
  const isFirst = (joint) =>
    model.outline.bodies.every(
      ({ joints: ofBody }) => !ofBody.includes(joint) || ofBody.find((one) => fixed.includes(one)) === joint,
    );
  const link = fixed.filter(isFirst).map((joint) => joints[joint]);
  if (link.length > 1) {
    layer.add("path", { d: line(link, link.length > 3), class: "ground-link" });
    keepLines(room, link, 2, link.length > 3);
  }
  for (const joint of fixed.filter((one) => scene.anatomy.pins[one])) {
    const axis = scene.anatomy.axes[joint];
    const place = scene.pose.joints[joint];
    const at = (direction, by) =>
      onPage(
        scene.view,
        place.map((value, index) => value + by * direction[index]),
      );
    if (axis === null) {
      const [x, y] = joints[joint];
      layer.add("circle", { cx: tenth(x), cy: tenth(y), r: 10, class: "bearing" });
    } else {
      const ends = [-1, 1].map((sign) => at(axis, sign * AXIS * scene.anatomy.size));
      layer.add("path", { d: line(ends), class: "axis" });
      keepLines(room, ends, 2);
      const [one, other] = acrossOf(axis);
      const disc = [...Array(24).keys()].map((step) => {
        const [cosine, sine] = [Math.cos((step * Math.PI) / 12), Math.sin((step * Math.PI) / 12)];
        const direction = one.map((value, index) => cosine * value + sine * other[index]);
        return at(direction, BEARING / scene.view.scale);
      });
      layer.add("path", { d: line(disc, true), class: "bearing" });
    }
    keepSquare(room, joints[joint], 12);
  }
}

function directionOf(model, scene, slide) {
  return unitOf([0, 0], flat(scene.view, scene.pose.slides[slide]));
}

/** Gears and racks in the colours of their bodies. */
function gears(layer, { sweep, anatomy, pose, view, free }) {
  layer.begin();
  const found = gearsAt(sweep, anatomy, pose);
  const shapes = [
    ...found.gears.map((gear) => [gear.body, teethOf(gear)]),
    ...found.racks.map((rack) => [rack.body, [rackOf(rack)]]),
  ];
  for (const [body, lines] of shapes) {
    const d = lines
      .map((points) =>
        line(
          points.map((point) => onPage(view, point)),
          true,
        ),
      )
      .join("");
    const faded = free === null || free === body ? "" : " faded";
    layer.add("path", { d, class: `gear ${body === null ? "plain" : colourOf(anatomy, body)}${faded}` });
  }
  layer.end();
}

function colourOf({ driven, colours }, body) {
  return driven[body] ? "driven" : colours[body] === null ? "plain" : `c${colours[body]}`;
}

function bodies(layer, hits, model, scene, joints, room) {
  layer.begin();
  hits.begin();
  model.outline.bodies.forEach((_, body) => {
    const { driven } = scene.anatomy;
    const corners = cornersOf(model, scene, body, joints, scene.pose);
    const cylinder = model.outline.slides.some(
      ({ guide }, slide) => guide === body && isCylinder(model, scene, slide) && !standsStill(model, scene, slide),
    );
    const outer = hull(corners);
    const shifted = model.outline.slides.some(
      ({ guide }, slide) => guide === body && scene.anatomy.drivenSlides[slide],
    );
    const colour = shifted ? "driven" : colourOf(scene.anatomy, body);
    const d = line(outer, outer.length > 2);
    const faded = scene.free === null || scene.free === body ? "" : " faded";
    if (cylinder && outer.length === 2) {
      const [from, to] = [corners[0], corners[corners.length - 1]];
      const middle = [0, 1].map((axis) => from[axis] + 0.6 * (to[axis] - from[axis]));
      layer.add("path", { d: line([from, to]), class: `rod${faded}` });
      layer.add("path", { d: line([from, middle]), class: `bar-edge${faded}` });
      layer.add("path", { d: line([from, middle]), class: `bar ${colour}${faded}` });
    } else if (outer.length > 2 && model.space) {
      layer.add("path", { d, class: `pane ${colour}${faded}` });
      layer.add("path", { d: "", class: "bar" });
    } else if (outer.length > 1) {
      const plate = outer.length > 2 ? " plate" : "";
      layer.add("path", { d, class: `bar-edge${plate}${faded}` });
      layer.add("path", { d, class: `bar${plate} ${colour}${faded}` });
    }
    if (outer.length > 0) {
      const style = driven[body] || shifted ? "hit hit-driven" : "hit";
      hits.add("path", { d: outer.length > 1 ? d : line([outer[0], outer[0]]), class: style, "data-body": body });
    }
    keepLines(room, outer, 6, outer.length > 2);
  });
  layer.end();
  hits.end();
}

/** The class of a joint that is none of the body that is seen alone. */
function fadedJoint(model, { free }, joint) {
  return free === null || model.outline.bodies[free].joints.includes(joint) ? "" : " faded";
}

function sliders(layer, model, scene, joints, room) {
  layer.begin();
  model.outline.slides.forEach(({ joint }, slide) => {
    if (isCylinder(model, scene, slide) || standsStill(model, scene, slide)) {
      return;
    }
    const d = blockOf(joints[joint], directionOf(model, scene, slide));
    layer.add("path", { d, class: `block${fadedJoint(model, scene, joint)}` });
    keepSquare(room, joints[joint], 12);
  });
  layer.end();
}

function pins(layer, model, scene, joints, room) {
  layer.begin();
  joints.forEach(([x, y], joint) => {
    if (scene.anatomy.pins[joint]) {
      const r = scene.anatomy.fixed[joint] ? 5 : 4.2;
      layer.add("circle", { cx: tenth(x), cy: tenth(y), r, class: `pin${fadedJoint(model, scene, joint)}` });
      keepSquare(room, [x, y], 6);
    }
  });
  scene.followed.forEach((followed) => {
    const [x, y] = onPage(scene.view, coordinatesOf(model, followed, scene.pose.joints));
    if (followed.joint === undefined || !scene.anatomy.pins[followed.joint]) {
      layer.add("circle", { cx: tenth(x), cy: tenth(y), r: 3.4, class: "tracer" });
      keepSquare(room, [x, y], 5);
    }
  });
  layer.end();
}

/** The arc of the drive, circles of curvature and instant centres. */
function marks(layer, model, scene, joints, room) {
  layer.begin();
  scene.anatomy.driven.forEach((driven, body) => {
    const ofBody = model.outline.bodies[body].joints;
    const centre = ofBody.find((joint) => scene.anatomy.fixed[joint]);
    const arm = ofBody.find((joint) => joint !== centre);
    const sign = scene.senses[body];
    if (!driven || sign === 0 || scene.free !== null || model.space || centre === undefined || arm === undefined) {
      return;
    }
    const from = -Math.atan2(joints[arm][1] - joints[centre][1], joints[arm][0] - joints[centre][0]);
    const arc = arcOfDrive(joints[centre], from, sign);
    layer.add("path", { d: line(arc), class: "drive" });
    layer.add("path", { d: arrowHead(arc[16], arc[15]), class: "drive-head" });
    keepLines(
      room,
      arc.filter((_, index) => index % 4 === 0),
      3,
    );
  });
  for (const { centre, radius, at } of scene.circles) {
    const [[x, y], point] = [onPage(scene.view, centre), onPage(scene.view, at)];
    const size = radius * scene.view.scale;
    if (size < 20 * Math.max(scene.width, scene.height)) {
      layer.add("circle", { cx: tenth(x), cy: tenth(y), r: tenth(size), class: "osculating" });
      layer.add("path", { d: line([point, [x, y]]), class: "thin-dash" });
      layer.add("circle", { cx: tenth(x), cy: tenth(y), r: 2.2, class: "dot" });
    }
  }
  for (const { at } of scene.centres) {
    const [x, y] = onPage(scene.view, at);
    if (Math.abs(x) < 1e5 && Math.abs(y) < 1e5) {
      layer.add("path", { d: `M${tenth(x - 5)} ${tenth(y)}h10m-5 -5v10`, class: "centre" });
    }
  }
  layer.end();
}

function arrows(layer, scene, room) {
  layer.begin();
  for (const { from, by, order } of scene.arrows) {
    const start = onPage(scene.view, from);
    const end = [start[0] + by[0], start[1] + by[1]];
    if (Math.hypot(...by) > 6) {
      layer.add("path", {
        d: line([start, [end[0] - 4 * unitOf(start, end)[0], end[1] - 4 * unitOf(start, end)[1]]]),
        class: `arrow o${order}`,
      });
      layer.add("path", {
        d: arrowHead([end[0] - 4 * unitOf(start, end)[0], end[1] - 4 * unitOf(start, end)[1]], start),
        class: `arrow-head o${order}`,
      });
      keepLines(room, [start, end], 2);
    }
  }
  layer.end();
}

/** Forces and couples, and how long the arrow of a force is. */
function forces(layer, scene, room) {
  layer.begin();
  const titled = (attributes, title) => {
    const element = layer.add("path", attributes);
    setText(element.firstChild ?? drawn("title", {}, element), title);
  };
  for (const { at, by, part, kind, title } of scene.forces) {
    const start = onPage(scene.view, at);
    if (part !== 0) {
      const arc = arcOf(start, part);
      if (arc.length > 0) {
        titled({ d: line(arc), class: `arrow force ${kind}` }, title);
        const last = arc.length - 1;
        titled({ d: arrowHead(arc[last], arc[last - 1]), class: `arrow-head force ${kind}` }, title);
        keepLines(room, arc, 2);
      }
      continue;
    }
    if (Math.hypot(...by) > 6) {
      const end = [start[0] + by[0], start[1] + by[1]];
      const [x, y] = unitOf(start, end);
      const back = [end[0] - 4 * x, end[1] - 4 * y];
      titled({ d: line([start, back]), class: `arrow force ${kind}` }, title);
      titled({ d: arrowHead(back, start), class: `arrow-head force ${kind}` }, title);
      keepLines(room, [start, end], 4);
    }
  }
  if (scene.newton !== null) {
    const { long, text } = scene.newton;
    const [left, foot] = [12, scene.height - 36];
    layer.add("path", {
      d: line([
        [left, foot],
        [left + long - 4, foot],
      ]),
      class: "arrow force joint",
    });
    layer.add("path", { d: arrowHead([left + long - 4, foot], [left, foot]), class: "arrow-head force joint" });
    setText(layer.add("text", { x: tenth(left + long + 7), y: foot + 4, class: "quiet" }), text);
    room.boxes.push([left, foot - 8, left + long + 7 + 8 * text.length, foot + 8]);
  }
  layer.end();
}

/** The arc of a couple around a point: the larger the part, the longer. */
function arcOf([x, y], part) {
  const way = 0.35 + 4.4 * Math.min(1, Math.abs(part));
  if (Math.abs(part) < 0.02) {
    return [];
  }
  return [...Array(17).keys()].map((step) => {
    const angle = -Math.PI / 2 - Math.sign(part) * way * (step / 16 - 0.5);
    return [x + 25 * Math.cos(angle), y + 25 * Math.sin(angle)];
  });
}

function names(layer, model, scene, joints, room, choices) {
  layer.begin();
  const write = (key, around, text, style) => {
    const position = placeName(room, around, text, 14, scene.moves ? choices.get(key) : undefined);
    if (position) {
      choices.set(key, position);
      setText(layer.add("text", { x: tenth(position.x), y: tenth(position.y + 4.6), class: `name ${style}` }), text);
    }
  };
  if (scene.shows.names) {
    scene.forces.forEach(({ key, at, by, part, kind, text }) => {
      const [x, y] = onPage(scene.view, at);
      if (text !== "" && (part !== 0 || Math.hypot(...by) > 6)) {
        const around = part === 0 ? [1, 0.8, 0.6].map((way) => [x + way * by[0], y + way * by[1]]) : [[x, y - 25]];
        write(`f${key}`, [...around, [x, y]], text, `of-force force ${kind}`);
      }
    });
    const isSeen = (joint) => scene.free === null || model.outline.bodies[scene.free].joints.includes(joint);
    scene.followed.forEach((followed, index) => {
      if (!isSeen(followed.joint)) {
        return;
      }
      write(
        `p${index}`,
        [onPage(scene.view, coordinatesOf(model, followed, scene.pose.joints))],
        followed.name,
        "of-point",
      );
    });
    // a name stands at a line that moves
    const writeGhost = (key, pose, name) => {
      const points = pose.joints.map((joint) => onPage(scene.view, joint));
      const moving = model.outline.bodies.map(({ joints: ofBody }) => ofBody.slice(0, 2).map((joint) => points[joint]));
      const lines = moving.filter((ends) => ends.length === 2);
      lines.forEach((ends) => keepLines(room, ends, 1));
      const around = lines
        .reverse()
        .flatMap(([from, to]) =>
          [0.5, 0.3, 0.7].map((part) => from.map((value, axis) => value + part * (to[axis] - value))),
        );
      write(key, around.length > 0 ? around : points, name, "of-ghost");
    };
    scene.ghosts.forEach(({ pose, name, index }) => name && writeGhost(`g${index}`, pose, name));
    if (scene.reference) {
      writeGhost("A", scene.reference, "A");
    }
    scene.centres.forEach(({ at, name }, index) => write(`i${index}`, [onPage(scene.view, at)], name, "of-centre"));
    model.outline.bodies.forEach(({ name, joints: ofBody }, body) => {
      if (scene.free !== null && scene.free !== body) {
        return;
      }
      const corners = cornersOf(model, scene, body, joints, scene.pose);
      // a plate has the name of the line from its first joint to the second
      const outer = ofBody.length > 2 ? corners.slice(0, 2) : hull(corners);
      const around = [];
      for (const part of [0.5, 0.35, 0.65, 0.2, 0.8]) {
        outer.forEach((from, index) => {
          const to = outer[(index + 1) % outer.length];
          if (outer.length > 2 || index === 0) {
            around.push([from[0] + (to[0] - from[0]) * part, from[1] + (to[1] - from[1]) * part]);
          }
        });
      }
      write(`b${body}`, around, name, "of-body");
    });
  }
  layer.end();
}
