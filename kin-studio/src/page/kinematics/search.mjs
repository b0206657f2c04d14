/** Searches along a line: the root finder of the page, and its uses. */

/**
 * The last value at which a condition holds, between a value where it holds and a value where it does not, by halving.
 * @param {number} apart the largest distance to the next value where it does not hold
 */
export function bisected(holds, inside, outside, apart) {
  while (Math.abs(outside - inside) > apart) {
    const x = 0.5 * (inside + outside);
    if (x === inside || x === outside) {
      break;
    }
    [inside, outside] = holds(x) ? [x, outside] : [inside, x];
  }
  return inside;
}

/** The value at which a curve that rises and then falls is highest: from there on, the curve falls. */
export function highestAt(value, low, high, apart) {
  const little = 1e-5 * (high - low);
  return bisected((x) => value(x + little) > value(x), low, high - little, apart) + 0.5 * little;
}

/** The index of the last of some ascending entries that is not beyond a value; the first index if all are beyond. */
export function lastIndex(entries, x, keyOf) {
  let [low, high] = [0, entries.length];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    [low, high] = keyOf(entries[middle]) <= x ? [middle, high] : [low, middle];
  }
  return low;
}

/** A number, or the end of a range next to it. */
export function clamped(x, low, high) {
  return Math.min(high, Math.max(low, x));
}
