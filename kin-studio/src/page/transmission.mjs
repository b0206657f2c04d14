/** Where the transmission angle of a dyad is below 40 degrees. */
const POOR = (40 * Math.PI) / 180;

/**
 * @param {import("./model.mjs").Model} model
 * @param {import("./sweep.mjs").Sweep} sweep
 * @param {boolean} given whether the design and the assembly are those of the report
 * @returns {[number, number][]}
 */
export function poorTransmission(model, sweep, given) {
  const { transmission } = model.report;
  if (!transmission) {
    return [];
  }
  if (given) {
    const points = transmission.samples.map(({ input, angles }) => [input, Math.min(...angles)]);
    const known = points.filter(([, angle]) => Number.isFinite(angle));
    return sweep.spans.flatMap(({ from, to }) => bandsBelow(known.filter(([x]) => x >= from && x <= to), from, to));
  }
  const angles = (transmission.dyads ?? []).map((dyad) => angleBetween(model, dyad));
  if (angles.length === 0 || angles.includes(null)) {
    return [];
  }
  const least = ({ x, pose }) => [x, Math.min(...angles.map((angle) => angle(pose)))];
  return sweep.spans.flatMap(({ from, to, rows }) => bandsBelow(rows.map(least), from, to));
}

/** The folded angle between the two links of a dyad, if its samples in the report say that it is that of its two unknowns. */
function angleBetween(model, dyad) {
  const names = dyad.split(", ");
  const known =
    names.length === 2 &&
    names.every((name) => model.unknowns.some((unknown) => unknown.declared === name && unknown.dimension === "angle"));
  const check = model.report.transmission.worst?.[model.report.transmission.dyads.indexOf(dyad)];
  if (!known || !check) {
    return null;
  }
  const [one, other] = names.map((name) => model.unknowns.find(({ declared }) => declared === name).name);
  const angle = (pose) => Math.asin(Math.min(1, Math.abs(Math.sin(pose[one][0] - pose[other][0]))));
  const rows = model.givenRows ?? [];
  const least = Math.min(...rows.map(({ pose }) => angle(pose)));
  return Math.abs(least - check.angle) < 0.01 ? angle : null;
}

/** The stretches on which a curve lies below 40 degrees, with their ends between its points by a straight line; they reach the ends of what closes. */
function bandsBelow(points, from, to) {
  const bands = [];
  let open = null;
  points.forEach(([x, angle], index) => {
    const [before, last] = points[index - 1] ?? [x, angle];
    const crossing = before + ((x - before) * (POOR - last)) / (angle - last || 1);
    if (angle < POOR && open === null) {
      open = index === 0 ? from : crossing;
    } else if (angle >= POOR && open !== null) {
      bands.push([open, crossing]);
      open = null;
    }
  });
  if (open !== null) {
    bands.push([open, to]);
  }
  return bands;
}

/** The least transmission angle of the report, with its place, or null. @param {import("./model.mjs").Model} model */
export function worstTransmission(model) {
  const worst = (model.report.transmission?.worst ?? []).filter(Boolean);
  return worst.length === 0 ? null : worst.reduce((least, one) => (one.angle < least.angle ? one : least));
}
