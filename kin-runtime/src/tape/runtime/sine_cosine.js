/** The largest angle that is reduced here. */
const KIN_NEAR = @LIMIT@;

/** A number whose addition rounds to an integer. */
const KIN_ROUNDING = @ROUNDING@;

/** π/2 as a sum. The products of the first two parts with a number of right angles are exact. */
const KIN_RIGHT_ANGLE = [@RIGHT_ANGLE@];

/** (r - sin r) / r³ and (cos r - 1 + r²/2) / r⁴ in powers of r², for |r| ≤ π/4. */
const KIN_SINE = [@SINE@];
const KIN_COSINE = [@COSINE@];

/**
 * A polynomial of six coefficients.
 * @param {number[]} c
 * @param {number} z
 * @returns {number}
 */
function kinSix(c, z) {
  const square = z * z;
  return c[0] + c[1] * z + (c[2] + c[3] * z) * square + (c[4] + c[5] * z) * (square * square);
}

/**
 * The sine and the cosine of an angle in radians: at most 4/3 units in the last place from the exact values, and the
 * same bits as those of kin. Angles beyond KIN_NEAR are left to Math.
 * @param {number} angle
 * @returns {[number, number]}
 */
function kinSineCosine(angle) {
  if (!(Math.abs(angle) <= KIN_NEAR)) {
    return [Math.sin(angle), Math.cos(angle)];
  }
  const shifted = angle * @TWO_OVER_PI@ + KIN_ROUNDING;
  const right_angles = shifted - KIN_ROUNDING;
  const first = angle - right_angles * KIN_RIGHT_ANGLE[0];
  const second = right_angles * KIN_RIGHT_ANGLE[1];
  const r = first - second;
  // The amount by which r is too large.
  const tail = right_angles * KIN_RIGHT_ANGLE[2] + (second - (first - r));
  const z = r * r;
  const s = r - (r * z * kinSix(KIN_SINE, z) + tail);
  const c = 1 - (0.5 * z - z * z * kinSix(KIN_COSINE, z));
  switch (right_angles & 3) {
    case 0:
      return [s, c];
    case 1:
      return [c, -s];
    case 2:
      return [-s, -c];
    default:
      return [-c, s];
  }
}
