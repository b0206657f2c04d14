/** The largest exponent for which both the power of two and its reciprocal have full precision. */
const KIN_EXPONENTS = @RANGE@;

const kinBits = new DataView(new ArrayBuffer(8));

/**
 * @param {number} exponent
 * @returns {number}
 */
function kinClamped(exponent) {
  return Math.max(-KIN_EXPONENTS, Math.min(KIN_EXPONENTS, exponent));
}

/**
 * The power of two with an exponent of at most KIN_EXPONENTS + 1.
 * @param {number} exponent
 * @returns {number}
 */
function kinPowerOfTwo(exponent) {
  kinBits.setUint32(0, (exponent + 1023) * 1048576);
  kinBits.setUint32(4, 0);
  return kinBits.getFloat64(0);
}

/**
 * The exponent of the power of two that scales a number to between 2 and 4.
 * @param {number} largest
 * @returns {number}
 */
function kinLevelling(largest) {
  if (largest === 0) {
    return 1;
  }
  kinBits.setFloat64(0, largest);
  return 1 + kinClamped(1023 - ((kinBits.getUint32(0) >>> 20) & 2047));
}

/**
 * A number multiplied by a power of two of any exponent.
 * @param {number} number
 * @param {number} exponent
 * @returns {number}
 */
function kinScaled(number, exponent) {
  while (exponent !== 0) {
    const step = kinClamped(exponent);
    number *= kinPowerOfTwo(step);
    exponent -= step;
  }
  return number;
}

/**
 * The triangular factors of a square matrix: multipliers below the diagonal, pivots on it, the remaining entries to the
 * right. Rows and columns are scaled by powers of two. Its `code` is empty, `singular` or `not finite`.
 * @typedef {{rows: number[][], origins: number[], rowExponents: number[], columnExponents: number[], odd: boolean,
 *   code: string, detail: number}} KinFactors
 */

/**
 * The product of the pivots, which is the determinant of the scaled matrix.
 * @param {KinFactors} factors
 * @returns {number}
 */
function kinPivots(factors) {
  return factors.rows.reduce((product, row, step) => product * row[step], factors.odd ? -1 : 1);
}

/**
 * The exponent of the power of two that turns that product into the determinant.
 * @param {KinFactors} factors
 * @returns {number}
 */
function kinExponent(factors) {
  let sum = 0;
  for (let index = 0; index < factors.rows.length; index++) {
    sum += factors.rowExponents[index] + factors.columnExponents[index];
  }
  return -sum;
}

/**
 * The triangular factors of a matrix. Its rows are overwritten. It is scaled as that of other factors if there are any,
 * and otherwise so that the largest entry of each row, and then of each column, lies between 2 and 4.
 * @param {number[][]} rows
 * @param {KinFactors} [scaled]
 * @returns {KinFactors}
 */
function kinFactor(rows, scaled) {
  const count = rows.length;
  const origins = rows.map((_, row) => row);
  /** @type {KinFactors} */
  const factors = { rows, origins, rowExponents: [], columnExponents: [], odd: false, code: "", detail: 0 };
  if (!rows.every((row) => row.every(Number.isFinite))) {
    factors.code = "not finite";
    return factors;
  }
  /** @type {(largest: number, entry: number) => number} */
  const larger = (largest, entry) => Math.max(largest, Math.abs(entry));
  for (let row = 0; row < count; row++) {
    const exponent = scaled ? scaled.rowExponents[row] : kinLevelling(rows[row].reduce(larger, 0));
    const power = kinPowerOfTwo(exponent);
    factors.rowExponents.push(exponent);
    for (let column = 0; column < count; column++) {
      rows[row][column] *= power;
    }
  }
  let largest = 0;
  for (let column = 0; column < count; column++) {
    const entries = rows.map((row) => row[column]);
    const exponent = scaled ? scaled.columnExponents[column] : kinLevelling(entries.reduce(larger, 0));
    const power = kinPowerOfTwo(exponent);
    factors.columnExponents.push(exponent);
    for (const row of rows) {
      row[column] *= power;
      largest = larger(largest, row[column]);
    }
  }
  let singular = false;
  for (let step = 0; step < count; step++) {
    let best = step;
    for (let row = step + 1; row < count; row++) {
      if (Math.abs(rows[row][step]) > Math.abs(rows[best][step])) {
        best = row;
      }
    }
    if (best !== step) {
      [rows[best], rows[step]] = [rows[step], rows[best]];
      [factors.origins[best], factors.origins[step]] = [factors.origins[step], factors.origins[best]];
      factors.odd = !factors.odd;
    }
    const pivot = rows[step][step];
    if (!(Math.abs(pivot) > 2 * count * Number.EPSILON * largest)) {
      singular = true;
    }
    if (!(Math.abs(pivot) > 0)) {
      break;
    }
    for (let row = step + 1; row < count; row++) {
      const multiplier = rows[row][step] / pivot;
      rows[row][step] = multiplier;
      for (let column = step + 1; column < count; column++) {
        rows[row][column] -= multiplier * rows[step][column];
        largest = Math.max(largest, Math.abs(rows[row][column]));
      }
    }
  }
  if (singular) {
    factors.detail = kinScaled(kinPivots(factors), kinExponent(factors));
    factors.code = Number.isFinite(factors.detail) ? "singular" : "not finite";
  }
  return factors;
}

/**
 * The solution for a right-hand side given in the order of the rows of the matrix.
 * @param {KinFactors} factors
 * @param {number[]} right
 * @returns {number[]}
 */
function kinSubstitute(factors, right) {
  const { rows, origins, rowExponents, columnExponents } = factors;
  /** @type {number[]} */
  const solution = [];
  for (let row = 0; row < rows.length; row++) {
    let sum = right[origins[row]] * kinPowerOfTwo(rowExponents[origins[row]]);
    for (let column = 0; column < row; column++) {
      sum -= rows[row][column] * solution[column];
    }
    solution.push(sum);
  }
  for (let row = rows.length - 1; row >= 0; row--) {
    let sum = solution[row];
    for (let column = row + 1; column < rows.length; column++) {
      sum -= rows[row][column] * solution[column];
    }
    solution[row] = sum / rows[row][row];
  }
  return solution.map((entry, column) => entry * kinPowerOfTwo(columnExponents[column]));
}
