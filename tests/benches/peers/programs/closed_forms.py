"""The closed forms of two linkages in any package of symbols, as a person would write them by hand.

A package is an object with sin, cos, sqrt and atan2. Both functions take dimensions and the crank's motion from the
position through snap, and return the motions of both unknowns, one after the other.
"""


def turned(rates):
    """What the n-th derivative of a unit vector is made of: with its angle's derivatives `rates`, of which the last is n - 1,
    it is (along + (across + the n-th derivative of the angle) i) times the unit vector."""
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
    """The n-th derivative of a vector whose angle is known through order n."""
    along, across = turned(rates)
    x, y = vector
    return along * x - (across + highest) * y, along * y + (across + highest) * x


def four_bar(package, dimensions, crank):
    """r2 cis(theta2) + r3 cis(theta3) == r1 + r4 cis(theta4), by the intersection of two circles."""
    r1, r2, r3, r4 = dimensions
    pin = r2 * package.cos(crank[0]), r2 * package.sin(crank[0])
    # the diagonal from the rocker's pivot to the crank's pin
    x, y = pin[0] - r1, pin[1]
    square = x * x + y * y
    along = (square + r4 * r4 - r3 * r3) / (2 * square)
    across = -package.sqrt(r4 * r4 / square - along * along)
    rocker = along * x - across * y, along * y + across * x
    coupler = rocker[0] - x, rocker[1] - y
    theta3 = [package.atan2(coupler[1], coupler[0])]
    theta4 = [package.atan2(rocker[1], rocker[0])]
    determinant = coupler[0] * rocker[1] - coupler[1] * rocker[0]
    for order in range(1, 5):
        known = [
            driven(pin, crank[:order], crank[order]),
            driven(coupler, theta3, 0),
            driven(rocker, theta4, 0),
        ]
        rest = [one + other - third for one, other, third in zip(*known)]
        theta3.append(-(rest[0] * rocker[0] + rest[1] * rocker[1]) / determinant)
        theta4.append(-(rest[0] * coupler[0] + rest[1] * coupler[1]) / determinant)
    return theta3 + theta4


def slider_crank(package, dimensions, crank):
    """r sin(theta) == l sin(phi) and s == r cos(theta) + l cos(phi)."""
    r, l = dimensions
    pin = r * package.cos(crank[0]), r * package.sin(crank[0])
    # the rod from the pin to the slider, whose angle is -phi
    rod = package.sqrt(l * l - pin[1] * pin[1]), -pin[1]
    angle = [package.atan2(rod[1], rod[0])]
    s = [pin[0] + rod[0]]
    for order in range(1, 5):
        of_crank = driven(pin, crank[:order], crank[order])
        of_rod = driven(rod, angle, 0)
        highest = -(of_crank[1] + of_rod[1]) / rod[0]
        angle.append(highest)
        s.append(of_crank[0] + of_rod[0] - highest * rod[1])
    return [-own for own in angle] + s


LINKAGES = {"four_bar": (four_bar, 4), "slider_crank": (slider_crank, 2)}


def symbols(linkage, symbol):
    """The symbols of a linkage, and its dimensions and crank made of them."""
    count = LINKAGES[linkage][1]
    dimensions = [symbol(f"d{index}") for index in range(count)]
    crank = [symbol(f"t{index}") for index in range(5)]
    return dimensions, crank
