/** π/4 as a sum. The products of the first part with the numbers up to 4 are exact. */
const KIN_HALF_RIGHT_ANGLE = [@HALF_RIGHT_ANGLE@];

/** (t - atan t) / t³ in powers of t², for |t| ≤ 1/2. */
const KIN_ARC_TANGENT = [@ARC_TANGENT@];

/**
 * A polynomial of twelve coefficients.
 * @param {number[]} c
 * @param {number} z
 * @returns {number}
 */
function kinTwelve(c, z) {
  const z2 = z * z;
  const z4 = z2 * z2;
  const low = c[0] + c[1] * z + (c[2] + c[3] * z) * z2;
  const middle = c[4] + c[5] * z + (c[6] + c[7] * z) * z2;
  const high = c[8] + c[9] * z + (c[10] + c[11] * z) * z2;
  return low + middle * z4 + high * (z4 * z4);
}

/**
 * 1 with the sign of a number, which may be a zero.
 * @param {number} number
 * @returns {number}
 */
function kinSign(number) {
  return number < 0 || Object.is(number, -0) ? -1 : 1;
}

/**
 * The angle from the x axis to the point (x, y): at most 1.5 units in the last place from the exact value, and the same
 * bits as those of kin. The origin, and coordinates that are not finite or whose sum overflows, are left to Math.
 * @param {number} y
 * @param {number} x
 * @returns {number}
 */
function kinAtan2(y, x) {
  const height = Math.abs(y);
  const width = Math.abs(x);
  const greater = height > width ? height : width;
  const lesser = height > width ? width : height;
  const slanting = lesser > greater - lesser;
  const side = kinSign(x);
  const sense = side * kinSign(width - height);
  // 0, 2 or 4 at the nearest axis, and 1 or 3 at a diagonal.
  const multiple = 2 - side - (slanting ? 0 : sense);
  const across = slanting ? lesser - greater : lesser;
  const along = slanting ? greater + lesser : greater;
  const fraction = across / along;
  if (!Number.isFinite(along * fraction)) {
    return Math.atan2(y, x);
  }
  const z = fraction * fraction;
  const oriented = sense * fraction;
  const rest = multiple * KIN_HALF_RIGHT_ANGLE[1] - oriented * z * kinTwelve(KIN_ARC_TANGENT, z);
  const angle = multiple * KIN_HALF_RIGHT_ANGLE[0] + (oriented + rest);
  return kinSign(y) * Math.abs(angle);
}
