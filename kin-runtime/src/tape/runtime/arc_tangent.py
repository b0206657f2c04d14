#: π/4 as a sum. The products of the first part with the numbers up to 4 are exact.
_HALF_RIGHT_ANGLE = (@HALF_RIGHT_ANGLE@)

#: (t - atan t) / t³ in powers of t², for |t| ≤ 1/2.
_ARC_TANGENT = (@ARC_TANGENT@)


def _twelve(c: tuple[float, ...], z: Array) -> Array:
    """A polynomial of twelve coefficients."""
    z2 = z * z
    z4 = z2 * z2
    low = (c[0] + c[1] * z) + (c[2] + c[3] * z) * z2
    middle = (c[4] + c[5] * z) + (c[6] + c[7] * z) * z2
    high = (c[8] + c[9] * z) + (c[10] + c[11] * z) * z2
    return (low + middle * z4) + high * (z4 * z4)


def _atan2(y: Array, x: Array) -> Array:
    """The angle from the x axis to the point (x, y): at most 1.5 units in the last place from the exact value, and the
    same bits as those of kin. The origin, and coordinates that are not finite or whose sum overflows, are left to
    NumPy."""
    height, width = np.abs(y), np.abs(x)
    greater = np.where(height > width, height, width)
    lesser = np.where(height > width, width, height)
    slanting = lesser > greater - lesser
    side = np.copysign(1.0, x)
    sense = side * np.copysign(1.0, width - height)
    # 0, 2 or 4 at the nearest axis, and 1 or 3 at a diagonal.
    multiple = (2.0 - side) - np.where(slanting, 0.0, sense)
    across = np.where(slanting, lesser - greater, lesser)
    along = np.where(slanting, greater + lesser, greater)
    fraction = across / along
    ordinary = np.isfinite(along * fraction)
    z = fraction * fraction
    oriented = sense * fraction
    rest = multiple * _HALF_RIGHT_ANGLE[1] - (oriented * z) * _twelve(_ARC_TANGENT, z)
    angle = np.copysign(multiple * _HALF_RIGHT_ANGLE[0] + (oriented + rest), y)
    if not np.all(ordinary):
        angle = np.where(ordinary, angle, np.arctan2(y, x))
    return angle
