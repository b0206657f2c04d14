#: The largest angle that is reduced here.
_NEAR = @LIMIT@

#: A number whose addition rounds to an integer.
_ROUNDING = @ROUNDING@

#: π/2 as a sum. The products of the first two parts with a number of right angles are exact.
_RIGHT_ANGLE = (@RIGHT_ANGLE@)

#: (r - sin r) / r³ and (cos r - 1 + r²/2) / r⁴ in powers of r², for |r| ≤ π/4.
_SINE = (@SINE@)
_COSINE = (@COSINE@)


def _six(c: tuple[float, ...], z: Array) -> Array:
    """A polynomial of six coefficients."""
    square = z * z
    return ((c[0] + c[1] * z) + (c[2] + c[3] * z) * square) + (c[4] + c[5] * z) * (square * square)


def _sine_cosine(angle: Array) -> tuple[Array, Array]:
    """The sine and the cosine of an angle in radians: at most 4/3 units in the last place from the exact values, and
    the same bits as those of kin. Angles beyond _NEAR are left to NumPy."""
    angle = np.asarray(angle, dtype=np.float64)
    near = np.abs(angle) <= _NEAR
    inside = np.where(near, angle, 0.0)
    shifted = inside * @TWO_OVER_PI@ + _ROUNDING
    right_angles = shifted - _ROUNDING
    first = inside - right_angles * _RIGHT_ANGLE[0]
    second = right_angles * _RIGHT_ANGLE[1]
    r = first - second
    # The amount by which r is too large.
    tail = right_angles * _RIGHT_ANGLE[2] + (second - (first - r))
    z = r * r
    s = r - ((r * z) * _six(_SINE, z) + tail)
    c = 1.0 - (0.5 * z - (z * z) * _six(_COSINE, z))
    quarters = right_angles.astype(np.int64)
    odd = (quarters & 1) != 0
    sine, cosine = np.where(odd, c, s), np.where(odd, s, c)
    sine = np.where((quarters & 2) != 0, -sine, sine)
    cosine = np.where(((quarters + 1) & 2) != 0, -cosine, cosine)
    if not np.all(near):
        sine, cosine = np.where(near, sine, np.sin(angle)), np.where(near, cosine, np.cos(angle))
    return sine, cosine
