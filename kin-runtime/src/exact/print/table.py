def _shifted(coefficients, way):
    """The coefficients of a polynomial about another point, by Horner's scheme."""
    for first in range(ORDERS):
        for index in range(len(coefficients) - 2, first - 1, -1):
            coefficients[index] += way * coefficients[index + 1]
    return coefficients


def _piece(left, right, length, part):
    """The polynomial that agrees with two rows in all orders, at a part of the way between them."""
    factors = [1.0]
    for order in range(1, ORDERS):
        factors.append(factors[-1] * (length / order))
    start = [value * factor for value, factor in zip(left, factors)]
    rest = [value * factor for value, factor in zip(right, factors)]
    moved = _shifted([start[0] - rest[0]] + start[1:], 1.0)
    rest = [value - other for value, other in zip([0.0] + rest[1:], moved)]
    for _ in range(ORDERS):
        for order in range(1, ORDERS):
            rest[order] -= rest[order - 1]
    powers = _shifted(start + _shifted(rest, -1.0), part)
    factor = 1.0
    for order in range(ORDERS):
        powers[order] *= factor
        factor *= (order + 1) / length
    return powers[:ORDERS]


def at(parameter: float, speed: float = 1.0) -> list[list[float]]:
    """All columns at a parameter: for each of COLUMNS the value and its derivatives by time, while the parameter changes at a speed.

    At the speed 1 they are the derivatives by the parameter. Raises ValueError for a parameter that is not in the table.
    """
    low, high, periods, left, right = _TABLE[0][0], _TABLE[-1][0], 0.0, 0, len(_TABLE) - 1
    if IS_CLOSED and math.isfinite(parameter):
        periods = (parameter - low) / (high - low)
        periods = float(math.floor(periods)) if math.isfinite(periods) else periods
        if abs(periods) > MOST_PERIODS:
            raise ValueError(f"{parameter} is too many periods of {high - low} away to tell its part of one")
        parameter = min(max(parameter - periods * (high - low), low), high)
    if not (low <= parameter <= high and math.isfinite(speed)):
        raise ValueError(f"the table runs from {low} to {high}; the parameter is {parameter}, the speed {speed}")
    while right - left > 1:
        middle = (left + right) // 2
        if _TABLE[middle][0] <= parameter:
            left = middle
        else:
            right = middle
    start, length = _TABLE[left][0], _TABLE[right][0] - _TABLE[left][0]
    result = []
    for column, change in enumerate(_CHANGES):
        numbers = slice(1 + column * ORDERS, 1 + (column + 1) * ORDERS)
        found = _piece(_TABLE[left][numbers], _TABLE[right][numbers], length, (parameter - start) / length)
        found[0] += periods * change
        factor = 1.0
        for order in range(ORDERS):
            found[order] *= factor
            factor *= speed
        result.append(found)
    return result
