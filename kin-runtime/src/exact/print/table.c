/* The coefficients of a polynomial about another point, by Horner's scheme. */
static void shifted(double *coefficients, int length, double way, int count)
{
    for (int first = 0; first < count; first++) {
        for (int index = length - 2; index >= first; index--) {
            coefficients[index] += way * coefficients[index + 1];
        }
    }
}

/* The polynomial that agrees with two rows in all orders, at a part of the way between them. */
static void piece(const double *left, const double *right, double length, double part, double *result)
{
    double powers[2 * ORDERS] = {0.0}, rest[ORDERS], moved[ORDERS], factor = 1.0;
    for (int order = 0; order < ORDERS; order++) {
        moved[order] = powers[order] = left[order] * factor;
        rest[order] = right[order] * factor;
        factor *= length / (order + 1);
    }
    moved[0] -= rest[0];
    rest[0] = 0.0;
    shifted(moved, ORDERS, 1.0, ORDERS);
    for (int order = 0; order < ORDERS; order++) {
        rest[order] -= moved[order];
    }
    for (int time = 0; time < ORDERS; time++) {
        for (int order = 1; order < ORDERS; order++) {
            rest[order] -= rest[order - 1];
        }
    }
    shifted(rest, ORDERS, -1.0, ORDERS);
    for (int order = 0; order < ORDERS; order++) {
        powers[ORDERS + order] = rest[order];
    }
    shifted(powers, 2 * ORDERS, part, ORDERS);
    factor = 1.0;
    for (int order = 0; order < ORDERS; order++) {
        result[order] = powers[order] * factor;
        factor *= (order + 1) / length;
    }
}

int PREFIX_at(double parameter, double speed, double result[UPPER_COLUMNS][UPPER_ORDERS])
{
    const double low = table[0][0], high = table[ROWS - 1][0];
    double periods = 0.0;
    int left = 0, right = ROWS - 1;
    if (!(parameter - parameter == 0.0 && speed - speed == 0.0)) {
        return 1;
    }
    if (IS_CLOSED) {
        periods = floor((parameter - low) / (high - low));
        if (!(-MOST_PERIODS <= periods && periods <= MOST_PERIODS)) {
            return 1;
        }
        parameter -= periods * (high - low);
        parameter = parameter < low ? low : parameter > high ? high : parameter;
    }
    if (!(low <= parameter && parameter <= high)) {
        return 1;
    }
    while (right - left > 1) {
        const int middle = (left + right) / 2;
        if (table[middle][0] <= parameter) {
            left = middle;
        } else {
            right = middle;
        }
    }
    const double length = table[right][0] - table[left][0], part = (parameter - table[left][0]) / length;
    for (int column = 0; column < COLUMNS; column++) {
        const int first = 1 + column * ORDERS;
        double factor = 1.0;
        piece(&table[left][first], &table[right][first], length, part, result[column]);
        result[column][0] += periods * changes[column];
        for (int order = 0; order < ORDERS; order++) {
            result[column][order] *= factor;
            factor *= speed;
        }
    }
    return 0;
}
