/** Gears and racks: as loads state them, or for bodies that turn against each other in a constant ratio. */
import { angleOf } from "./anatomy.mjs";
import { allRows, innerRows } from "./sweep.mjs";
import { DESCRIBES } from "./tolerances.mjs";

/** The teeth of the smaller gear of a pair, at least and at most, and at most those of the larger one. */
const TEETH = [18, 30];
const MOST_TEETH = 400;
/** A part of the pitch that a symmetric mechanism has nowhere, so that rounding decides nothing. */
const UNEVEN = 0.123;
/** The rack beyond the part on which its gear rolls, in radii. */
const BEYOND = 0.7;

/**
 * A gear in the mechanism's coordinates. A ring has its teeth inside.
 * @typedef {{body: number | null, centre: number[], radius: number, teeth: number, phase: number,
 *   isRing: boolean}} Gear
 * A rack: its teeth point along `up`.
 * @typedef {{body: number | null, from: number[], to: number[], along: number[], up: number[], first: number,
 *   pitch: number}} Rack
 */

const known = new WeakMap();

/** All gears and racks of a pose. @returns {{gears: Gear[], racks: Rack[]}} */
export function gearsAt(sweep, anatomy, pose) {
  const { model } = sweep;
  if (model.space) {
    return { gears: [], racks: [] };
  }
  if (!known.has(sweep)) {
    known.set(sweep, contactsOf(sweep, anatomy));
  }
  const found = new Map();
  const racks = known
    .get(sweep)
    .map((contact) => placed(model, contact, pose, found))
    .filter((rack) => rack !== null);
  return { gears: [...found.values()], racks };
}

/** The contacts with radii for the dimensions, and for racks the part on which the gear rolls. */
function contactsOf(sweep, anatomy) {
  const { model, design } = sweep;
  const radiusOf = ({ radius, dimension }) =>
    design.parameters[model.parameters.find(({ declared }) => declared === dimension)?.name] ?? radius;
  const stated = (model.report.forces?.contacts ?? []).map(({ circles, rack }) => ({
    circles: circles.map((circle) => ({ ...circle, radius: radiusOf(circle) })),
    rack,
  }));
  const contacts = stated.length > 0 ? stated : pairsOf(sweep, anatomy);
  return contacts.map((contact) => {
    const rolls = allRows(sweep).map(({ pose }) => (contact.rack ? lineOf(model, contact, pose).rolled : 0));
    return { ...contact, range: [Math.min(...rolls), Math.max(...rolls)] };
  });
}

/** Bodies on pivots of the ground that turn against each other in a constant ratio, with the circles that roll so. */
function pairsOf(sweep, { fixed, drivers }) {
  const { model } = sweep;
  const rows = innerRows(sweep);
  if (rows.length < 2) {
    return [];
  }
  const steps = [0.1, 0.3, 0.45, 0.6, 0.8].map((part) => Math.floor(part * (rows.length - 2)));
  const wrapped = (angle) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
  const pivots = model.outline.bodies.flatMap(({ joints }, body) => {
    const pivot = joints.find((joint) => fixed[joint]);
    const ways = steps.map((at) => {
      const [one, other] = [rows[at], rows[at + 1]].map(({ pose }) => angleOf(model, pose, body));
      return wrapped(other - one);
    });
    return pivot === undefined || joints.length < 2 || !ways.every((way) => way !== 0) ? [] : [{ body, pivot, ways }];
  });
  return pivots.flatMap((one, index) =>
    pivots.slice(index + 1).flatMap((other) => {
      const ratio = other.ways[0] / one.ways[0];
      const isConstant = one.ways.every(
        (way, at) => Math.abs(other.ways[at] - ratio * way) < DESCRIBES * Math.abs(way),
      );
      const ownDrives = [one, other].every(({ body }) => drivers[body] !== null);
      if (!isConstant || ownDrives || ratio > -0.05 || ratio < -20 || one.pivot === other.pivot) {
        return [];
      }
      const [first, second] = [one, other].map(({ pivot }) => rows[0].pose.joints[pivot]);
      const apart = Math.hypot(second[0] - first[0], second[1] - first[1]);
      const circle = ({ body, pivot }, radius) => ({ body, centre: { joint: pivot }, radius });
      const radius = (-ratio * apart) / (1 - ratio);
      return [{ circles: [circle(one, radius), circle(other, apart - radius)], rack: null }];
    }),
  );
}

function placeOf({ joint, fixed }, pose) {
  return fixed ?? pose.joints[joint];
}

function turnOf(model, body, pose) {
  const angle = body === null ? 0 : angleOf(model, pose, body);
  return Number.isFinite(angle) ? angle : 0;
}

/** Adds the gears of a contact, whose teeth mesh, and returns its rack or null. */
function placed(model, { circles, rack, range }, pose, found) {
  const keys = circles.map(({ body, centre, radius }) => JSON.stringify([body, centre, radius]));
  const density = densityOf(
    circles.map(({ radius }) => radius),
    keys.map((key) => found.get(key)),
  );
  const gears = circles.map((circle, index) => {
    const teeth = Math.max(3, Math.min(MOST_TEETH, Math.round(density * circle.radius)));
    const other = circles[1 - index];
    const centre = placeOf(circle.centre, pose);
    const apart = other && Math.hypot(...centre.map((value, axis) => value - placeOf(other.centre, pose)[axis]));
    const isRing = other !== undefined && circle.radius > other.radius && apart < circle.radius;
    const phase = turnOf(model, circle.body, pose);
    return found.get(keys[index]) ?? { body: circle.body, centre, radius: circle.radius, teeth, phase, isRing };
  });
  if (gears.length === 2 && gears.every(({ radius }) => radius > 0)) {
    // the gear that has its place leads
    const [lead, follow] = found.has(keys[1]) && !found.has(keys[0]) ? [gears[1], gears[0]] : gears;
    const way = follow.centre.map((value, axis) => value - lead.centre[axis]);
    const outwards = follow.isRing ? -1 : 1;
    const direction = Math.atan2(outwards * way[1], outwards * way[0]);
    const part = (lead.teeth * (direction - lead.phase)) / (2 * Math.PI);
    const isInside = lead.isRing || follow.isRing;
    const own = isInside ? 0.5 + part : 0.5 - part;
    const phase = direction + (isInside ? 0 : Math.PI) - (2 * Math.PI * own) / follow.teeth;
    // of the teeth that mesh, the one that turns with the body is the first
    const step = (2 * Math.PI) / follow.teeth;
    follow.phase = phase + step * Math.round((follow.phase - phase) / step + UNEVEN);
  }
  gears.forEach((gear, index) => found.set(keys[index], gear));
  if (!rack) {
    return null;
  }
  const [gear] = gears;
  const { along, up, at, rolled } = lineOf(model, { circles, rack }, pose);
  const pitch = (2 * Math.PI * gear.radius) / gear.teeth;
  const part = (gear.teeth * (Math.atan2(-up[1], -up[0]) - gear.phase)) / (2 * Math.PI);
  const [low, high] = [range[0] - rolled - BEYOND * gear.radius, range[1] - rolled + BEYOND * gear.radius];
  const point = (way) => at.map((value, axis) => value + way * along[axis]);
  // the first tooth stands in a gap of the gear
  const shift = (0.5 - part) * pitch;
  const first = shift + pitch * Math.ceil((low - shift) / pitch - UNEVEN) - low;
  return { body: rack.body, from: point(low), to: point(high), along, up, first, pitch };
}

/** The teeth for each unit of radius: those of a gear that has them, or so many that both have whole numbers. */
function densityOf(radii, there) {
  const gear = there.find(Boolean);
  if (gear) {
    return gear.teeth / gear.radius;
  }
  const [least, most] = [Math.min(...radii), Math.max(...radii)];
  const [from, to] = TEETH;
  const error = (teeth) => Math.abs((teeth * most) / least - Math.round((teeth * most) / least)) / teeth;
  const counts = [...Array(to - from + 1).keys()].map((more) => from + more);
  return counts.reduce((best, teeth) => (error(teeth) < error(best) - DESCRIBES ? teeth : best)) / least;
}

/**
 * The pitch line of a rack: its direction, counterclockwise about the gear; the direction of its teeth, to the gear;
 * the pitch point; and how far this lies along the rack from its body's first joint.
 */
function lineOf(model, { circles: [circle], rack }, pose) {
  const centre = placeOf(circle.centre, pose);
  const anchor = rack.body === null ? [0, 0] : pose.joints[model.outline.bodies[rack.body].joints[0]];
  const size = Math.hypot(...rack.along);
  const [x, y] = rack.along.map((value) => value / size);
  const side = (anchor[0] - centre[0]) * -y + (anchor[1] - centre[1]) * x >= 0 ? 1 : -1;
  const down = [-side * y, side * x];
  const along = [-down[1], down[0]];
  const at = centre.map((value, axis) => value + circle.radius * down[axis]);
  const rolled = (at[0] - anchor[0]) * along[0] + (at[1] - anchor[1]) * along[1];
  return { along, up: down.map((value) => -value), at, rolled };
}
