/** The pace at which the page plays: at the pace 1 as fast as the mechanism moves. */

/** The times of a range that are watched with ease, in seconds; within them, the pace nearest to 1 is taken. */
const WATCHED = [3, 12];
/** The paces: 1, 2 and 5 times powers of ten. */
const PACES = [-6, -5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5, 6].flatMap((power) =>
  [1, 2, 5].map((part) => Number(`${part}e${power}`)),
);

/** The units of the report's time in a second. Units that are not listed count as seconds. */
export function secondsOf(unit) {
  const units = { ms: 1e3, s: 1, min: 1 / 60, h: 1 / 3600 };
  return units[unit] ?? 1;
}

/** The pace nearest to 1 at which the whole range can be watched. */
export function watchablePace(model, design) {
  const time = model.width / (Math.abs(design.speed) * secondsOf(model.units.time));
  const good = PACES.filter((pace) => time / pace >= WATCHED[0] && time / pace <= WATCHED[1]);
  return good.reduce((best, pace) => (Math.abs(Math.log(pace)) < Math.abs(Math.log(best)) ? pace : best), good[0] ?? 1);
}

/** The paces to choose from, ascending: some around one, and 1. @returns {number[]} */
export function pacesAround(pace) {
  const index = PACES.indexOf(pace);
  const some = PACES.slice(Math.max(0, index - 2), index + 3);
  return [...new Set([...some, 1])].sort((one, other) => one - other);
}

/** A pace in words. */
export function paceText(pace) {
  return pace < 1 ? `1/${Math.round(1 / pace)}×` : `${pace}×`;
}
