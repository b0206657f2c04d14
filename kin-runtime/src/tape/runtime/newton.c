/* The equations of a block: stores residuals and their Jacobian, one row for each equation, at some unknowns. */
typedef void (*kin_equations)(const void *given, const double *unknowns, double *residuals,
                              double jacobian[KIN_UNKNOWNS][KIN_UNKNOWNS]);

/* A block whose root is sought. */
typedef struct {
    int count;
    kin_equations equations;
    /* The numbers that the equations know besides the unknowns. */
    const void *given;
    /* The natural size of each unknown. */
    const double *sizes;
} kin_block;

/* A point on the way. The Jacobian is that of unknowns in their sizes. */
typedef struct {
    double unknowns[KIN_UNKNOWNS];
    double residuals[KIN_UNKNOWNS];
    double jacobian[KIN_UNKNOWNS][KIN_UNKNOWNS];
} kin_point;

/* Whether the residuals and the Jacobian at the unknowns of a point, which are stored there, are finite. */
static int kin_evaluate(const kin_block *block, kin_point *point)
{
    int finite = 1;
    block->equations(block->given, point->unknowns, point->residuals, point->jacobian);
    for (int row = 0; row < block->count; row++) {
        finite = finite && fabs(point->residuals[row]) <= DBL_MAX;
        for (int column = 0; column < block->count; column++) {
            point->jacobian[row][column] = point->jacobian[row][column] * block->sizes[column];
            finite = finite && fabs(point->jacobian[row][column]) <= DBL_MAX;
        }
    }
    return finite;
}

/* The factors of the Jacobian of a point, which is scaled as that of other factors if there are any. */
static int kin_factor_at(int count, const kin_point *point, const kin_factors *scaled, kin_factors *factors,
                         double *detail)
{
    for (int row = 0; row < count; row++) {
        for (int column = 0; column < count; column++) {
            factors->entries[row][column] = point->jacobian[row][column];
        }
    }
    return kin_factor(count, factors, scaled, detail);
}

/* The step of Newton's method from these residuals. */
static void kin_correction(int count, const kin_factors *factors, const double *residuals, double *correction)
{
    kin_substitute(count, factors, residuals, correction);
    for (int index = 0; index < count; index++) {
        correction[index] = -correction[index];
    }
}

/* The largest magnitude, or NaN if an entry is NaN. */
static double kin_largest(int count, const double *vector)
{
    double largest = 0.0;
    for (int index = 0; index < count; index++) {
        const double size = fabs(vector[index]);
        if (!(size <= largest) && largest <= DBL_MAX) {
            largest = size;
        } else if (!(size <= DBL_MAX) && !(size > DBL_MAX)) {
            largest = size;
        }
    }
    return largest;
}

/* The largest difference of the entries of `one` and of `factor` times those of `other`. */
static double kin_distance(int count, const double *one, double factor, const double *other)
{
    double difference[KIN_UNKNOWNS];
    for (int index = 0; index < count; index++) {
        const double product = factor * other[index];
        difference[index] = one[index] - product;
    }
    return kin_largest(count, difference);
}

static void kin_move(const kin_block *block, const double *from, const double *correction, double part, double *to)
{
    for (int index = 0; index < block->count; index++) {
        const double change = part * correction[index] * block->sizes[index];
        to[index] = from[index] + change;
    }
}

/* Whether rounding may explain a correction that does not fall. */
static int kin_is_rounding(const kin_block *block, double length, const kin_point *point, const kin_factors *factors)
{
    double size = 1.0;
    double sums[KIN_UNKNOWNS] = {0.0};
    double amplification = 0.0;
    if (length * length <= @LINEAR_STEP@ * DBL_EPSILON) {
        return 1;
    }
    for (int index = 0; index < block->count; index++) {
        const double ratio = fabs(point->unknowns[index]) / block->sizes[index];
        size = ratio > size ? ratio : size;
    }
    for (int column = 0; column < block->count; column++) {
        double unit[KIN_UNKNOWNS] = {0.0};
        double solution[KIN_UNKNOWNS];
        double weight = 0.0;
        unit[column] = 1.0;
        kin_substitute(block->count, factors, unit, solution);
        for (int index = 0; index < block->count; index++) {
            weight = weight + fabs(point->jacobian[column][index]);
        }
        for (int index = 0; index < block->count; index++) {
            const double product = fabs(solution[index]) * weight;
            sums[index] = sums[index] + product;
        }
    }
    for (int index = 0; index < block->count; index++) {
        amplification = sums[index] > amplification ? sums[index] : amplification;
    }
    return length <= 16.0 * DBL_EPSILON * size * amplification;
}

/* Accepts a root, unless a change of the size of rounding errors alters the determinant by a quarter of itself. */
static int kin_distinct(int count, const double *root, const kin_factors *previous, const kin_factors *factors,
                        double *found, double *detail)
{
    double ratio = 1.0;
    int finite = 1;
    if (previous) {
        const int exponent = kin_exponent(count, factors) - kin_exponent(count, previous);
        ratio = ldexp(kin_pivots(count, factors) / kin_pivots(count, previous), kin_clamped(exponent));
    }
    for (int index = 0; index < count; index++) {
        found[index] = root[index];
        finite = finite && fabs(root[index]) <= DBL_MAX;
    }
    *detail = 0.0;
    if (ratio >= 0.75 && ratio <= 1.25) {
        return finite ? KIN_FOUND : KIN_NOT_FINITE;
    }
    *detail = ldexp(kin_pivots(count, factors), kin_exponent(count, factors));
    return fabs(*detail) <= DBL_MAX ? KIN_SINGULAR : KIN_NOT_FINITE;
}

/* The root of a block near a guess, by Newton's method with the damping of P. Deuflhard, Newton Methods for Nonlinear
   Problems, Springer 2004, section 3.3.3. The residual of an iteration that does not converge, and the determinant of a
   singular Jacobian, is stored in `detail`. `found` may be the guess. */
static int kin_newton(const kin_block *block, const double *guess, double *found, double *detail)
{
    const int count = block->count;
    /* Two points and two matrices that take turns. */
    kin_point points[2];
    kin_factors matrices[2];
    int now = 0;
    double correction[KIN_UNKNOWNS] = {0.0};
    double expected[KIN_UNKNOWNS] = {0.0};
    double previous = 0.0;
    double part = 0.0;
    double limit = @FIRST_STEP@;
    int tested = 0;
    int outcome;

    *detail = 0.0;
    for (int index = 0; index < count; index++) {
        points[0].unknowns[index] = guess[index];
        if (!(block->sizes[index] > 0.0 && block->sizes[index] <= DBL_MAX)) {
            return KIN_NOT_FINITE;
        }
    }
    if (!kin_evaluate(block, &points[0])) {
        return KIN_NOT_FINITE;
    }
    outcome = kin_factor_at(count, &points[0], 0, &matrices[0], detail);
    if (outcome != KIN_FOUND) {
        return outcome;
    }
    for (int iteration = 0; iteration < @ITERATIONS@; iteration++) {
        kin_point *const point = &points[now];
        kin_point *const next = &points[1 - now];
        kin_factors *const factors = &matrices[now];
        kin_factors *const other = &matrices[1 - now];
        double length;
        double contraction = INFINITY;
        double foreseen = 1.0;
        double next_length;
        double fall = 0.0;
        int lost = 1;
        int last;
        int accepted = 0;

        kin_correction(count, factors, point->residuals, correction);
        length = kin_largest(count, correction);
        if (!(length <= DBL_MAX)) {
            *detail = kin_largest(count, point->residuals);
            return KIN_NOT_CONVERGED;
        }
        for (int index = 0; index < count; index++) {
            const double size = fabs(point->unknowns[index]);
            const double unit = block->sizes[index];
            if (!(fabs(correction[index]) * unit <= DBL_EPSILON * (size > unit ? size : unit))) {
                lost = 0;
            }
        }
        /* How the correction compares with the one before, if that was taken in full. */
        if (iteration > 0 && part >= 1.0) {
            contraction = length / previous;
        }
        next_length = contraction * contraction * length;
        /* Whether the next correction may be a simplified one, by these factors, and is the last. */
        last = contraction <= @QUADRATIC@
            && 2.0 * contraction * contraction * next_length <= @NEGLIGIBLE@ * DBL_EPSILON;
        if (contraction <= @QUADRATIC@ && next_length <= @NEGLIGIBLE@ * DBL_EPSILON) {
            /* The next correction would disappear. */
            kin_move(block, point->unknowns, correction, 1.0, next->unknowns);
            return kin_distinct(count, next->unknowns, 0, factors, found, detail);
        }
        if (lost || (iteration > 0 && part >= 1.0 && length >= 0.5 * previous
                     && kin_is_rounding(block, length, point, factors))) {
            if (lost) {
                kin_move(block, point->unknowns, correction, 1.0, next->unknowns);
            }
            return kin_distinct(count, lost ? next->unknowns : point->unknowns, iteration > 0 ? other : 0, factors,
                                found, detail);
        }
        if (iteration > 0 && tested && !(contraction <= @CONVERGING@)) {
            const double distance = kin_distance(count, expected, 1.0, correction);
            const double forecast = part * previous * kin_largest(count, expected) / (distance * length);
            if (forecast < 1.0) {
                foreseen = forecast > @SMALLEST_PART@ ? forecast : @SMALLEST_PART@;
            }
        }
        part = limit / length < foreseen ? limit / length : foreseen;
        for (int trial = 0; trial < @TRIALS@ && !accepted; trial++) {
            double advice = 0.5 * part;
            kin_move(block, point->unknowns, correction, part, next->unknowns);
            if (kin_evaluate(block, next)) {
                double estimate;
                /* A correction that has fallen enough shows that the full step is in order. */
                tested = !(contraction <= @CONVERGING@ && part >= 1.0);
                fall = 0.0;
                if (tested || last) {
                    kin_correction(count, factors, next->residuals, expected);
                }
                if (tested) {
                    fall = kin_largest(count, expected) / length;
                } else if (last && kin_largest(count, expected) <= @QUADRATIC@ * length) {
                    kin_move(block, next->unknowns, expected, 1.0, next->unknowns);
                    return kin_distinct(count, next->unknowns, 0, factors, found, detail);
                }
                if (!tested || fall < 1.0 - 0.25 * part) {
                    accepted = 1;
                } else if (kin_is_rounding(block, length, point, factors)) {
                    outcome = kin_factor_at(count, next, 0, other, detail);
                    if (outcome != KIN_FOUND) {
                        return outcome;
                    }
                    return kin_distinct(count, fall < 1.0 ? next->unknowns : point->unknowns, factors, other, found,
                                        detail);
                } else {
                    estimate = 0.5 * length * part * part / kin_distance(count, expected, 1.0 - part, correction);
                    /* Shorten to a tenth at most: the estimate is rough if the step was much too long. */
                    if (estimate < advice) {
                        advice = estimate > 0.1 * part ? estimate : 0.1 * part;
                    }
                }
            }
            if (!accepted) {
                part = advice;
            }
        }
        if (!accepted) {
            *detail = kin_largest(count, point->residuals);
            return KIN_NOT_CONVERGED;
        }
        /* If the equations are nearly linear over a step, the next step may be longer. */
        if (tested && kin_distance(count, expected, 1.0 - part, correction) <= 0.25 * part * length) {
            limit = limit * 2.0;
        }
        previous = length;
        now = 1 - now;
        /* Scales are kept after a step that has hardly changed the Jacobian. */
        outcome = kin_factor_at(count, next, fall <= @CONVERGING@ ? factors : 0, other, detail);
        if (outcome != KIN_FOUND) {
            return outcome;
        }
    }
    *detail = kin_largest(count, points[now].residuals);
    return KIN_NOT_CONVERGED;
}
