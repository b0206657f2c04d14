/** Searches along a line: the one root finder of the page, and what is made of it. */

/**
 * The last place at which something holds, between one where it does and one where it does not, by halving.
 * @param {number} apart how far the place may be from the next one where it does not hold
 */
export function lastPlace(holds, inside, outside, apart) {
  while (Math.abs(outside - inside) > apart) {
    const x = 0.5 * (inside + outside);
    if (x === inside || x === outside) {
      break;
    }
    [inside, outside] = holds(x) ? [x, outside] : [inside, x];
  }
  return inside;
}

/** The highest place of a curve that rises and then falls: where it is no longer higher a little further on. */
export function highestPlace(value, low, high, apart) {
  const little = 1e-5 * (high - low);
  return lastPlace((x) => value(x + little) > value(x), low, high - little, apart) + 0.5 * little;
}

/** The index of the last of some ascending entries that is not beyond a place; the first one's if all are. */
export function lastIndex(entries, x, placeOf) {
  let [low, high] = [0, entries.length];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    [low, high] = placeOf(entries[middle]) <= x ? [middle, high] : [low, middle];
  }
  return low;
}

/** A number, or the end of a range next to it. */
export function clamped(x, low, high) {
  return Math.min(high, Math.max(low, x));
}
