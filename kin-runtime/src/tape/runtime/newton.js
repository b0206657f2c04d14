/**
 * A point on the way. The Jacobian is that of unknowns in their sizes.
 * @typedef {{unknowns: number[], residuals: number[], jacobian: number[][]}} KinPoint
 */

/**
 * The result of Newton's method. Its `code` is empty, `not converged`, `singular` or `not finite`; `detail` is the
 * residual of an iteration that does not converge, or the determinant of a singular Jacobian.
 * @typedef {{unknowns: number[], code: string, detail: number}} KinRoot
 */

/**
 * The largest magnitude, or NaN if an entry is NaN.
 * @param {number[]} vector
 * @returns {number}
 */
function kinLargest(vector) {
  return vector.reduce((largest, entry) => Math.max(largest, Math.abs(entry)), 0);
}

/**
 * The largest difference of the entries of `one` and of `factor` times those of `other`.
 * @param {number[]} one
 * @param {number} factor
 * @param {number[]} other
 * @returns {number}
 */
function kinDistance(one, factor, other) {
  return kinLargest(one.map((entry, index) => entry - factor * other[index]));
}

/**
 * Whether rounding may explain a correction that does not fall.
 * @param {number} length
 * @param {KinPoint} point
 * @param {number[]} sizes
 * @param {KinFactors} factors
 * @returns {boolean}
 */
function kinIsRounding(length, point, sizes, factors) {
  if (length * length <= @LINEAR_STEP@ * Number.EPSILON) {
    return true;
  }
  const sums = sizes.map(() => 0);
  point.jacobian.forEach((row, column) => {
    const weight = row.reduce((sum, entry) => sum + Math.abs(entry), 0);
    const unit = sizes.map((_, index) => (index === column ? 1 : 0));
    kinSubstitute(factors, unit).forEach((entry, index) => {
      sums[index] += Math.abs(entry) * weight;
    });
  });
  const size = point.unknowns.reduce((size, entry, index) => Math.max(size, Math.abs(entry) / sizes[index]), 1);
  return length <= 16 * Number.EPSILON * size * sums.reduce((largest, sum) => (sum > largest ? sum : largest), 0);
}

/**
 * Accepts a root, unless a change of the size of rounding errors alters the determinant by a quarter of itself.
 * @param {number[]} unknowns
 * @param {KinFactors | undefined} previous
 * @param {KinFactors} factors
 * @returns {KinRoot}
 */
function kinDistinct(unknowns, previous, factors) {
  let ratio = 1;
  if (previous) {
    const exponent = kinClamped(kinExponent(factors) - kinExponent(previous));
    ratio = (kinPivots(factors) / kinPivots(previous)) * kinPowerOfTwo(exponent);
  }
  if (ratio >= 0.75 && ratio <= 1.25) {
    return { unknowns, code: unknowns.every(Number.isFinite) ? "" : "not finite", detail: 0 };
  }
  const detail = kinScaled(kinPivots(factors), kinExponent(factors));
  return { unknowns, code: Number.isFinite(detail) ? "singular" : "not finite", detail };
}

/**
 * The root of a block near a guess, by Newton's method with the damping of P. Deuflhard, Newton Methods for Nonlinear
 * Problems, Springer 2004, section 3.3.3.
 * @param {number[]} guess
 * @param {number[]} sizes - the natural size of each unknown
 * @param {(unknowns: number[]) => [number[], number[][]]} equations - the residuals and their Jacobian, one row for each
 *   equation
 * @returns {KinRoot}
 */
function kinNewton(guess, sizes, equations) {
  /** @type {(unknowns: number[]) => KinPoint | undefined} */
  const at = (unknowns) => {
    const [residuals, rows] = equations(unknowns);
    const jacobian = rows.map((row) => row.map((entry, column) => entry * sizes[column]));
    const finite = residuals.every(Number.isFinite) && jacobian.every((row) => row.every(Number.isFinite));
    return finite ? { unknowns, residuals, jacobian } : undefined;
  };
  /** @type {(point: KinPoint, scaled?: KinFactors) => KinFactors} */
  const factorsAt = (point, scaled) => kinFactor(point.jacobian.map((row) => row.slice()), scaled);
  /** @type {(from: number[], correction: number[], part: number) => number[]} */
  const moved = (from, correction, part) =>
    from.map((entry, index) => entry + part * correction[index] * sizes[index]);
  /** @type {(factors: KinFactors, residuals: number[]) => number[]} */
  const corrected = (factors, residuals) => kinSubstitute(factors, residuals).map((entry) => -entry);
  /** @type {(code: string, detail: number) => KinRoot} */
  const failed = (code, detail) => ({ unknowns: guess, code, detail });

  let point = sizes.every((size) => size > 0 && Number.isFinite(size)) ? at(guess) : undefined;
  if (!point) {
    return failed("not finite", 0);
  }
  let factors = factorsAt(point);
  if (factors.code) {
    return failed(factors.code, factors.detail);
  }
  let limit = @FIRST_STEP@;
  /** @type {{length: number, part: number, expected: number[] | undefined, factors: KinFactors} | undefined} */
  let before;
  for (let iteration = 0; iteration < @ITERATIONS@; iteration++) {
    const from = point;
    const correction = corrected(factors, from.residuals);
    const length = kinLargest(correction);
    if (!Number.isFinite(length)) {
      return failed("not converged", kinLargest(from.residuals));
    }
    const lost = correction.every(
      (entry, index) =>
        Math.abs(entry) * sizes[index] <= Number.EPSILON * Math.max(sizes[index], Math.abs(from.unknowns[index])),
    );
    // How the correction compares with the one before, if that was taken in full.
    const contraction = before?.part === 1 ? length / before.length : Infinity;
    const nextLength = contraction * contraction * length;
    // Whether the next correction may be a simplified one, by these factors, and is the last.
    const last =
      contraction <= @QUADRATIC@ &&
      2 * contraction * contraction * nextLength <= @NEGLIGIBLE@ * Number.EPSILON;
    if (contraction <= @QUADRATIC@ && nextLength <= @NEGLIGIBLE@ * Number.EPSILON) {
      // The next correction would disappear.
      return kinDistinct(moved(from.unknowns, correction, 1), undefined, factors);
    }
    const stalls = before !== undefined && before.part === 1 && length >= 0.5 * before.length;
    if (lost || (stalls && kinIsRounding(length, from, sizes, factors))) {
      return kinDistinct(lost ? moved(from.unknowns, correction, 1) : from.unknowns, before?.factors, factors);
    }
    const converging = contraction <= @CONVERGING@;
    let foreseen = 1;
    if (before?.expected && !converging) {
      const { part, expected } = before;
      foreseen = (part * before.length * kinLargest(expected)) / (kinDistance(expected, 1, correction) * length);
      foreseen = foreseen < 1 ? Math.max(foreseen, @SMALLEST_PART@) : 1;
    }
    let part = Math.min(foreseen, limit / length);
    /** @type {[KinPoint, number[] | undefined] | undefined} */
    let accepted;
    for (let trial = 0; trial < @TRIALS@; trial++) {
      const unknowns = moved(from.unknowns, correction, part);
      let advice = 0.5 * part;
      const next = at(unknowns);
      if (next && converging && part === 1) {
        // A correction that has fallen enough shows that the full step is in order.
        if (last) {
          const simplified = corrected(factors, next.residuals);
          if (kinLargest(simplified) <= @QUADRATIC@ * length) {
            return kinDistinct(moved(unknowns, simplified, 1), undefined, factors);
          }
        }
        accepted = [next, undefined];
        break;
      }
      if (next) {
        const expected = corrected(factors, next.residuals);
        const fall = kinLargest(expected) / length;
        if (fall < 1 - 0.25 * part) {
          accepted = [next, expected];
          break;
        }
        if (kinIsRounding(length, from, sizes, factors)) {
          const there = factorsAt(next);
          if (there.code) {
            return failed(there.code, there.detail);
          }
          return kinDistinct(fall < 1 ? unknowns : from.unknowns, factors, there);
        }
        const estimate = (0.5 * length * part * part) / kinDistance(expected, 1 - part, correction);
        // Shorten to a tenth at most: the estimate is rough if the step was much too long.
        if (estimate < advice) {
          advice = Math.max(estimate, 0.1 * part);
        }
      }
      part = advice;
    }
    if (!accepted) {
      return failed("not converged", kinLargest(from.residuals));
    }
    const [next, expected] = accepted;
    // If the equations are nearly linear over a step, the next step may be longer.
    if (expected && kinDistance(expected, 1 - part, correction) <= 0.25 * part * length) {
      limit *= 2;
    }
    before = { length, part, expected, factors };
    point = next;
    // Scales are kept after a step that has hardly changed the Jacobian.
    factors = factorsAt(point, expected && !(kinLargest(expected) / length <= @CONVERGING@) ? undefined : factors);
    if (factors.code) {
      return failed(factors.code, factors.detail);
    }
  }
  return failed("not converged", kinLargest(point.residuals));
}
