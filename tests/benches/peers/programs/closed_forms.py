"""The closed forms of the linkages of the race in any package of symbols, as a person would write them by hand.

A package is an object with sin, cos, sqrt and atan2. Each function takes a list of dimensions and a list of the motions
of the inputs, from the position through snap. It returns the motions of the unknowns and those of the coordinates of
the outputs, one after the other.
"""

from math import comb

ORDERS = range(1, 5)


def turned(rates):
    """The terms of the n-th derivative of a unit vector that the derivatives of its angle up to n - 1, `rates`, are
    enough for: the derivative is (along + (across + the n-th derivative of the angle) i) times the unit vector."""
    match rates:
        case [_]:
            return 0, 0
        case [_, w]:
            return -w * w, 0
        case [_, w, a]:
            return -3 * w * a, -w * w * w
        case [_, w, a, j]:
            return w * w * w * w - 4 * w * j - 3 * a * a, -6 * w * w * a


def driven(vector, rates, highest):
    """The n-th derivative of a vector that rotates, whose angle has these derivatives."""
    along, across = turned(rates)
    x, y = vector
    return along * x - (across + highest) * y, along * y + (across + highest) * x


def rotating(package, vector, angle):
    """The motion of a vector that rotates with an angle."""
    x, y = vector
    c, s = package.cos(angle[0]), package.sin(angle[0])
    now = (x * c - y * s, y * c + x * s) if y is not None else (x * c, x * s)
    return [now] + [driven(now, angle[:n], angle[n]) for n in ORDERS]


def added(one, other):
    return [(x + u, y + v) for (x, y), (u, v) in zip(one, other)]


def fixed(x, y):
    return [(x, y)] + [(0, 0) for _ in ORDERS]


def dyad(package, start, first, end, second, sign):
    """The angles of two links, from `start` and from `end` to the joint between them. The second one lies to the left
    of the diagonal from `end` to `start` if the sign is 1, otherwise to the right. Returns both angles and both
    vectors."""
    (a, b), (c, d) = start[0], end[0]
    x, y = a - c, b - d
    square = x * x + y * y
    along = (square + second * second - first * first) / (2 * square)
    across = sign * package.sqrt(second * second / square - along * along)
    late = along * x - across * y, along * y + across * x
    early = late[0] - x, late[1] - y
    alpha, beta = [package.atan2(early[1], early[0])], [package.atan2(late[1], late[0])]
    determinant = early[0] * late[1] - early[1] * late[0]
    for n in ORDERS:
        known = driven(early, alpha, 0), driven(late, beta, 0)
        rest = [start[n][k] + known[0][k] - known[1][k] - end[n][k] for k in range(2)]
        alpha.append(-(rest[0] * late[0] + rest[1] * late[1]) / determinant)
        beta.append(-(rest[0] * early[0] + rest[1] * early[1]) / determinant)
    return alpha, beta, early, late


def motion_of(vector, angle):
    """The motion of a vector whose direction is that of a link with this angle."""
    return [vector] + [driven(vector, angle[:n], angle[n]) for n in ORDERS]


def in_frame(vector, unit):
    """A vector that is fixed to a link with this unit vector."""
    return vector[0] * unit[0] - vector[1] * unit[1], vector[1] * unit[0] + vector[0] * unit[1]


def coordinates(motion):
    return [x for x, _ in motion] + [y for _, y in motion]


def four_bar(package, dimensions, inputs):
    r1, r2, r3, r4 = dimensions
    pin = rotating(package, (r2, None), inputs[0])
    theta3, theta4, _, _ = dyad(package, pin, r3, fixed(r1, 0), r4, -1)
    return theta3 + theta4


def slider_crank(package, dimensions, inputs):
    r, l = dimensions
    (crank,) = inputs
    pin = r * package.cos(crank[0]), r * package.sin(crank[0])
    # the rod from the pin to the slider, whose angle is -phi
    rod = package.sqrt(l * l - pin[1] * pin[1]), -pin[1]
    angle, s = [package.atan2(rod[1], rod[0])], [pin[0] + rod[0]]
    for n in ORDERS:
        of_crank = driven(pin, crank[:n], crank[n])
        of_rod = driven(rod, angle, 0)
        highest = -(of_crank[1] + of_rod[1]) / rod[0]
        angle.append(highest)
        s.append(of_crank[0] + of_rod[0] - highest * rod[1])
    return [-own for own in angle] + s


def inverted_slider_crank(package, dimensions, inputs):
    r1, r2 = dimensions
    end = added(fixed(r1, 0), rotating(package, (r2, None), inputs[0]))
    x, y = end[0]
    r, theta = [package.sqrt(x * x + y * y)], [package.atan2(y, x)]
    unit = x / r[0], y / r[0]
    units = [unit]
    for n in ORDERS:
        of_unit = driven(unit, theta, 0)
        rest = [end[n][k] - r[0] * of_unit[k] for k in range(2)]
        for m in range(1, n):
            rest = [rest[k] - comb(n, m) * r[m] * units[n - m][k] for k in range(2)]
        r.append(rest[0] * unit[0] + rest[1] * unit[1])
        theta.append((rest[1] * unit[0] - rest[0] * unit[1]) / r[0])
        units.append((of_unit[0] - theta[n] * unit[1], of_unit[1] + theta[n] * unit[0]))
    return r + theta


def geared_five_bar(package, dimensions, inputs):
    r1, r2, r3, r4, r5, ratio, phase = dimensions
    (crank,) = inputs
    theta5 = [ratio * crank[0] + phase] + [ratio * rate for rate in crank[1:]]
    pin = rotating(package, (r2, None), crank)
    gear = added(fixed(r1, 0), rotating(package, (r5, None), theta5))
    theta3, theta4, early, _ = dyad(package, pin, r3, gear, r4, -1)
    return theta3 + theta4 + theta5 + coordinates(added(pin, motion_of(early, theta3)))


def watt_two(package, dimensions, inputs):
    r1, r2, r3, r4, arm_x, arm_y, pivot_x, pivot_y, r5, r6 = dimensions
    pin = rotating(package, (r2, None), inputs[0])
    theta3, theta4, _, rocker = dyad(package, pin, r3, fixed(r1, 0), r4, -1)
    arm = in_frame((arm_x, arm_y), (rocker[0] / r4, rocker[1] / r4))
    start = added(fixed(r1, 0), motion_of(arm, theta4))
    theta5, theta6, _, _ = dyad(package, start, r5, fixed(pivot_x, pivot_y), r6, -1)
    return theta3 + theta4 + theta5 + theta6


def jansen_leg(package, dimensions, inputs):
    a, b, c, d, e, f, g, h, i, j, k, l, m = dimensions
    pin, pivot = rotating(package, (m, None), inputs[0]), fixed(-a, -l)
    angle_j, angle_b, _, of_b = dyad(package, pin, j, pivot, b, 1)
    angle_k, angle_c, _, of_c = dyad(package, pin, k, pivot, c, -1)
    d_along = (b * b + d * d - e * e) / (2 * b)
    d_beside = package.sqrt(d * d - d_along * d_along)
    i_along = (g * g + i * i - h * h) / (2 * g)
    i_beside = package.sqrt(i * i - i_along * i_along)
    knee = added(pivot, motion_of(of_c, angle_c))
    corner = added(pivot, motion_of(in_frame((d_along, d_beside), (of_b[0] / b, of_b[1] / b)), angle_b))
    angle_f, angle_g, _, of_g = dyad(package, corner, f, knee, g, 1)
    foot = added(knee, motion_of(in_frame((i_along, i_beside), (of_g[0] / g, of_g[1] / g)), angle_g))
    return angle_j + angle_b + angle_k + angle_c + angle_f + angle_g + coordinates(foot)


def rssr(package, dimensions, inputs):
    crank, *rest, rod = dimensions
    pivot, axis, arm = rest[:3], rest[3:6], rest[6:]
    dot = lambda one, other: sum(x * y for x, y in zip(one, other))
    scale = dot(axis, arm) / dot(axis, axis)
    size = package.sqrt(dot(axis, axis))
    beside = [x - scale * y for x, y in zip(arm, axis)]
    across = [
        (axis[1] * arm[2] - axis[2] * arm[1]) / size,
        (axis[2] * arm[0] - axis[0] * arm[2]) / size,
        (axis[0] * arm[1] - axis[1] * arm[0]) / size,
    ]
    middle = [x + scale * y for x, y in zip(pivot, axis)]
    pin = rotating(package, (crank, None), inputs[0])
    # a cos phi + b sin phi == c
    between = middle[0] - pin[0][0], middle[1] - pin[0][1], middle[2]
    a = [dot(between, beside)] + [-x * beside[0] - y * beside[1] for x, y in pin[1:]]
    b = [dot(between, across)] + [-x * across[0] - y * across[1] for x, y in pin[1:]]
    c = [(rod * rod - dot(between, between) - dot(beside, beside)) / 2]
    c += [x * middle[0] + y * middle[1] for x, y in pin[1:]]
    root = package.sqrt(a[0] * a[0] + b[0] * b[0] - c[0] * c[0])
    square = a[0] * a[0] + b[0] * b[0]
    cosine, sine = (a[0] * c[0] + b[0] * root) / square, (b[0] * c[0] - a[0] * root) / square
    phi = [package.atan2(sine, cosine)]
    units = [(cosine, sine)]
    for n in ORDERS:
        known = driven(units[0], phi, 0)
        value = a[0] * known[0] + b[0] * known[1] - c[n]
        for m in range(n):
            value = value + comb(n, m) * (a[n - m] * units[m][0] + b[n - m] * units[m][1])
        phi.append(-value / root)
        units.append((known[0] - phi[n] * sine, known[1] + phi[n] * cosine))
    ball = [[beside[k] * x + across[k] * y for x, y in units] for k in range(3)]
    for k in range(3):
        ball[k][0] = ball[k][0] + middle[k]
    return phi + ball[0] + ball[1] + ball[2]


# Steps of Newton's method: from the guess of the race the last one changes nothing.
STEPS = 5


def class_three_triad(package, dimensions, inputs):
    base_b, base_c, platform_b, platform_c = (dimensions[k : k + 2] for k in range(0, 8, 2))
    a, b, c, near = inputs
    unit = lambda angle: (package.cos(angle), package.sin(angle))
    dot = lambda one, other: one[0] * other[0] + one[1] * other[1]
    left = lambda vector: (-vector[1], vector[0])

    def vectors(alpha, beta, gamma, phi):
        turn = unit(phi)
        return unit(alpha), unit(beta), unit(gamma), in_frame(platform_b, turn), in_frame(platform_c, turn)

    def solved(directions, one, other):
        """The changes of the angles by which both loops change by these vectors."""
        of_a, of_b, of_c, to_b, to_c = directions
        leg = a[0] * of_a[0], a[0] * of_a[1]
        rows = [(dot(left(leg), side), dot(left(platform), side)) for side, platform in ((of_b, to_b), (of_c, to_c))]
        right = dot(one, of_b), dot(other, of_c)
        determinant = rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0]
        alpha = (right[0] * rows[1][1] - right[1] * rows[0][1]) / determinant
        phi = (rows[0][0] * right[1] - rows[1][0] * right[0]) / determinant
        left_over = lambda platform, change, side: (
            alpha * dot(left(leg), left(side)) + phi * dot(left(platform), left(side)) - dot(change, left(side))
        )
        return alpha, left_over(to_b, one, of_b) / b[0], left_over(to_c, other, of_c) / c[0], phi

    angles = list(near)
    for _ in range(STEPS):
        directions = of_a, of_b, of_c, to_b, to_c = vectors(*angles)
        gap = lambda to, base, length, of: [a[0] * of_a[k] + to[k] - base[k] - length * of[k] for k in range(2)]
        gaps = gap(to_b, base_b, b[0], of_b), gap(to_c, base_c, c[0], of_c)
        changes = solved(directions, *([-x for x in own] for own in gaps))
        angles = [angle + change for angle, change in zip(angles, changes)]
    directions = of_a, of_b, of_c, to_b, to_c = vectors(*angles)
    motions = [[angle] for angle in angles]
    units = [[own] for own in (of_a, of_b, of_c)]

    def leg(length, units, n, known):
        """The n-th derivative of a leg, without the n-th derivative of its angle."""
        terms = [length[n] * units[0][k] + length[0] * known[k] for k in range(2)]
        for m in range(1, n):
            terms = [terms[k] + comb(n, m) * length[m] * units[n - m][k] for k in range(2)]
        return terms

    platforms = [[to_b], [to_c]]
    for n in ORDERS:
        known = [driven(own[0], motion, 0) for own, motion in zip(units, motions)]
        legs = [leg(length, own, n, part) for length, own, part in zip((a, b, c), units, known)]
        of_platform = [driven(own[0], motions[3], 0) for own in platforms]
        changes = [[legs[m][k] - legs[0][k] - of_platform[m - 1][k] for k in range(2)] for m in (1, 2)]
        found = solved(directions, *changes)
        for motion, value in zip(motions, found):
            motion.append(value)
        for own, part, value in zip(units, known, found):
            own.append(tuple(part[k] + value * left(own[0])[k] for k in range(2)))
        for own, part in zip(platforms, of_platform):
            own.append(tuple(part[k] + found[3] * left(own[0])[k] for k in range(2)))
    centre = []
    for n in range(5):
        of_leg = [sum(comb(n, m) * a[m] * units[0][n - m][k] for m in range(n + 1)) for k in range(2)]
        centre.append([of_leg[k] + (platforms[0][n][k] + platforms[1][n][k]) / 3 for k in range(2)])
    return [value for motion in motions for value in motion] + coordinates(centre)


# The function of a linkage, the count of its dimensions, and the counts of numbers of its inputs.
LINKAGES = {
    "four_bar": (four_bar, 4, [5]),
    "slider_crank": (slider_crank, 2, [5]),
    "inverted_slider_crank": (inverted_slider_crank, 2, [5]),
    "geared_five_bar": (geared_five_bar, 7, [5]),
    "watt_two": (watt_two, 10, [5]),
    "jansen_leg": (jansen_leg, 13, [5]),
    "rssr": (rssr, 11, [5]),
    "class_three_triad": (class_three_triad, 8, [5, 5, 5, 4]),
}


def form(linkage, package, symbol, dimensions=None):
    """The symbols of the arguments of a linkage, in the order of kin's, and the expressions of its results. Dimensions
    that are given as constants are no arguments."""
    function, count, inputs = LINKAGES[linkage]
    symbols = [] if dimensions else [symbol(f"d{index}") for index in range(count)]
    motions = [[symbol(f"t{number}_{index}") for index in range(length)] for number, length in enumerate(inputs)]
    return symbols + sum(motions, []), function(package, dimensions or symbols, motions)
