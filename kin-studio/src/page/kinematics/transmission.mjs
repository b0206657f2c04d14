/** The ranges in which the transmission angle of a dyad is poor. */
import { givenDesign } from "./model.mjs";
import { createSweep, rowAt } from "./sweep.mjs";
import { DESCRIBES, POOR } from "./tolerances.mjs";

/** Its ranges: by the report, or at other dimensions by the page. @returns {[number, number][]} */
export function poorTransmission({ model, reported, spans }) {
  const { samples = [], dyads = [] } = model.report.transmission ?? {};
  if (reported) {
    const points = samples.map(({ input, angles }) => [input, Math.min(...angles)]);
    const within = ({ from, to }) => points.filter(([x]) => x >= from && x <= to);
    return spans.flatMap((span) => bandsBelow(within(span), span));
  }
  const angles = dyads.map((dyad, index) => angleBetween(model, dyad, index));
  if (angles.length === 0 || angles.includes(null)) {
    return [];
  }
  const least = ({ x, pose }) => [x, Math.min(...angles.map((angle) => angle(pose)))];
  return spans.flatMap((span) => bandsBelow(span.rows.map(least), span));
}

/** The folded angle between the two links of a dyad, if by the report's samples it is that of its two unknowns. */
function angleBetween(model, dyad, index) {
  const unknowns = dyad.split(", ").map((name) => model.unknowns.find(({ declared }) => declared === name));
  if (unknowns.length !== 2 || unknowns.some((unknown) => unknown?.dimension !== "angle")) {
    return null;
  }
  const [one, other] = unknowns.map(({ name }) => name);
  const angle = (pose) => Math.asin(Math.min(1, Math.abs(Math.sin(pose[one][0] - pose[other][0]))));
  const { report } = model;
  const { samples } = report.transmission;
  model.reported ??= createSweep(model, givenDesign(model), report.assemblies[report.assembly ?? 0]);
  const some = [0.1, 0.3, 0.6, 0.8].map((part) => samples[Math.floor(part * samples.length)]);
  const agrees = ({ input, angles }) => {
    const row = rowAt(model.reported, input);
    return row !== null && Math.abs(Math.sin(angle(row.pose) - angles[index])) < DESCRIBES;
  };
  return some.every(agrees) ? angle : null;
}

/** The parts of a stretch on which a curve is poor, by straight lines between its points. */
function bandsBelow(points, { from, to }) {
  const bands = [];
  let start = null;
  points.forEach(([x, angle], index) => {
    const [before, last] = points[index - 1] ?? [x, angle];
    const crossing = before + ((x - before) * (POOR - last)) / (angle - last || 1);
    if (angle < POOR && start === null) {
      start = index === 0 ? from : crossing;
    } else if (angle >= POOR && start !== null) {
      bands.push([start, crossing]);
      start = null;
    }
  });
  if (start !== null) {
    bands.push([start, to]);
  }
  return bands;
}

/** The least transmission angle of the report, with its value of the variable, or null. */
export function worstTransmission(model) {
  const worst = model.report.transmission?.worst ?? [];
  return worst.reduce((least, one) => (least === null || one.angle < least.angle ? one : least), null);
}
