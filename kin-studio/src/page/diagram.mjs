/** The free-body diagram: forces as arrows of the picture, all of them at their joints, or those on one body. */
import { memberText } from "./curves.mjs";
import { forcesAt, placeOfForce } from "./kinematics/forces.mjs";
import { numberText } from "./numbers.mjs";

/** The words for what acts on a body beside its joints: as a force, and as a couple. */
const WORDS = {
  mass: ["weight and inertia", "inertia"],
  load: ["load", "torque"],
  drive: ["drive", "drive"],
  friction: ["friction", "friction"],
  guide: ["guide", "guide"],
};

/**
 * A force on a body, or a couple, in the mechanism's coordinates.
 * @typedef {{key: string, at: number[], force: number[], couple: number, kind: string, title: string,
 *   text: string}} Arrow
 */

/** The force of every joint on the body that it is said to act on, and the moments of guides. @returns {Arrow[]} */
export function allForces(model, row) {
  const { joints, curves } = model.report.forces;
  const now = forcesAt(model, row);
  return joints.flatMap((joint, index) => {
    const force = now.forces[index];
    const at = placeOfForce(model, row, index);
    if (!at) {
      return [];
    }
    const on = `on ${memberText(model, joint.on)}, by ${memberText(model, joint.by)}`;
    const moment = now.curves[curves.findIndex(({ name }) => name === `${joint.name}_moment`)];
    const own = { at, kind: "joint", text: "" };
    const arrow = force && { ...own, key: joint.name, force: force.slice(0, 2), couple: 0 };
    const arc = moment && { ...own, key: `${joint.name} moment`, force: [0, 0], couple: moment[0], kind: "guide" };
    return [
      ...(arrow ? [{ ...arrow, title: `${joint.name}: ${newtons(arrow.force)} ${on}` }] : []),
      ...(arc ? [{ ...arc, title: `${joint.name}: ${newtonMetres(arc.couple)} ${on}` }] : []),
    ];
  });
}

/** All that acts on a body. @returns {Arrow[]} */
export function forcesOn(model, row, body) {
  const { joints, body_loads: loads } = model.report.forces;
  const now = forcesAt(model, row);
  const ofJoints = joints.flatMap(({ name, on, by }, index) => {
    const force = now.forces[index];
    const at = placeOfForce(model, row, index);
    const sign = on === body ? 1 : by === body ? -1 : 0;
    if (!force || !at || sign === 0) {
      return [];
    }
    const own = [sign * force[0], sign * force[1]];
    const text = `${name} ${newtons(own)}`;
    return [{ key: name, at, force: own, couple: 0, kind: "joint", title: text, text }];
  });
  const own = loads.flatMap((load, index) =>
    load.body === body && now.loads[index] ? [{ ...load, key: `load ${index}`, values: now.loads[index] }] : [],
  );
  const centre = own.find(({ kind, is_couple: isCouple }) => kind === "mass" && !isCouple)?.values.slice(2);
  const corner = row.pose.joints[placeOfCouple(model, body)];
  const ofLoads = own.map(({ key, kind, is_couple: isCouple, values }) => {
    const [asForce, asCouple] = WORDS[kind];
    if (isCouple) {
      const text = `${asCouple} ${newtonMetres(values[0])}`;
      const at = (kind === "mass" && centre) || corner;
      return { key, at, force: [0, 0], couple: values[0], kind, title: text, text };
    }
    const text = `${asForce} ${newtons(values)}`;
    return { key, at: values.slice(2), force: values.slice(0, 2), couple: 0, kind, title: text, text };
  });
  return [...ofJoints, ...ofLoads];
}

/** The joint at which couples on a body are drawn: one on the ground, or the first. */
function placeOfCouple(model, body) {
  const { joints } = model.outline.bodies[body];
  return joints.find((joint) => model.outline.ground.includes(joint)) ?? joints[0];
}

function newtons([x, y]) {
  return `${numberText(Math.hypot(x, y), 4)} N`;
}

function newtonMetres(moment) {
  return `${numberText(moment, 4)} N m`;
}
