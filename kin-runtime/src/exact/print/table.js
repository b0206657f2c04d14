/** The coefficients of a polynomial about another point, by Horner's scheme. */
function shifted(coefficients, way) {
    for (let first = 0; first < ORDERS; first++) {
        for (let index = coefficients.length - 2; index >= first; index--) {
            coefficients[index] += way * coefficients[index + 1];
        }
    }
    return coefficients;
}

/** The polynomial that agrees with two rows in all orders, at a part of the way between them. */
function piece(left, right, length, part) {
    const factors = [1];
    for (let order = 0; order + 1 < ORDERS; order++) factors.push(factors[order] * (length / (order + 1)));
    const start = left.map((value, order) => value * factors[order]);
    const rest = right.map((value, order) => value * factors[order]);
    const moved = start.slice();
    moved[0] -= rest[0];
    rest[0] = 0;
    shifted(moved, 1);
    for (let order = 0; order < ORDERS; order++) rest[order] -= moved[order];
    for (let time = 0; time < ORDERS; time++) {
        for (let order = 1; order < ORDERS; order++) rest[order] -= rest[order - 1];
    }
    const powers = shifted(start.concat(shifted(rest, -1)), part).slice(0, ORDERS);
    let factor = 1;
    for (let order = 0; order < ORDERS; order++) {
        powers[order] *= factor;
        factor *= (order + 1) / length;
    }
    return powers;
}

/**
 * All columns at a parameter: for each of COLUMNS the value and its derivatives by time, while the parameter changes at a speed.
 * At the speed 1 they are the derivatives by the parameter.
 * @param {number} parameter
 * @param {number} [speed]
 * @returns {number[][]}
 */
export function at(parameter, speed = 1) {
    const rows = TABLE.length, low = TABLE[0][0], high = TABLE[rows - 1][0];
    let periods = 0, left = 0, right = rows - 1;
    if (IS_CLOSED) {
        periods = Math.floor((parameter - low) / (high - low));
        if (Math.abs(periods) > MOST_PERIODS) {
            throw new RangeError(`${parameter} is too many periods of ${high - low} away to tell its part of one`);
        }
        parameter = Math.min(Math.max(parameter - periods * (high - low), low), high);
    }
    if (!(low <= parameter && parameter <= high && Number.isFinite(speed))) {
        throw new RangeError(`the table runs from ${low} to ${high}; the parameter is ${parameter}, the speed ${speed}`);
    }
    while (right - left > 1) {
        const middle = (left + right) >> 1;
        if (TABLE[middle][0] <= parameter) left = middle;
        else right = middle;
    }
    const start = TABLE[left][0], length = TABLE[right][0] - start, part = (parameter - start) / length;
    return CHANGES.map((change, column) => {
        const own = [left, right].map((row) => TABLE[row].slice(1 + column * ORDERS, 1 + (column + 1) * ORDERS));
        const found = piece(own[0], own[1], length, part);
        found[0] += periods * change;
        let factor = 1;
        for (let order = 0; order < ORDERS; order++) {
            found[order] *= factor;
            factor *= speed;
        }
        return found;
    });
}
