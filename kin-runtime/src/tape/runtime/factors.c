/* The result of a factorisation and of Newton's method. */
enum { KIN_FOUND = 0, KIN_NOT_CONVERGED = 1, KIN_SINGULAR = 2, KIN_NOT_FINITE = 3 };

/* The largest exponent for which both the power of two and its reciprocal have full precision. */
#define KIN_EXPONENTS @RANGE@

/* A square matrix, and then its triangular factors: multipliers below the diagonal, pivots on it, the remaining entries
   to the right. Rows and columns are scaled by powers of two. */
typedef struct {
    double entries[KIN_UNKNOWNS][KIN_UNKNOWNS];
    /* The row of the matrix from which each row came. */
    int origins[KIN_UNKNOWNS];
    double row_scales[KIN_UNKNOWNS];
    double column_scales[KIN_UNKNOWNS];
    /* Whether an odd number of pairs of rows was exchanged. */
    int odd;
} kin_factors;

static int kin_clamped(int exponent)
{
    if (exponent > KIN_EXPONENTS) {
        return KIN_EXPONENTS;
    }
    return exponent < -KIN_EXPONENTS ? -KIN_EXPONENTS : exponent;
}

/* The power of two that scales a number to between 2 and 4. */
static double kin_levelling(double largest)
{
    int exponent = 1;
    if (largest > 0.0) {
        (void)frexp(largest, &exponent);
    }
    return ldexp(1.0, 1 - kin_clamped(exponent - 1));
}

/* The product of the pivots, which is the determinant of the scaled matrix. */
static double kin_pivots(int count, const kin_factors *factors)
{
    double product = factors->odd ? -1.0 : 1.0;
    for (int step = 0; step < count; step++) {
        product = product * factors->entries[step][step];
    }
    return product;
}

/* The exponent of the power of two that turns that product into the determinant. */
static int kin_exponent(int count, const kin_factors *factors)
{
    int sum = 0;
    for (int index = 0; index < count; index++) {
        int row, column;
        (void)frexp(factors->row_scales[index], &row);
        (void)frexp(factors->column_scales[index], &column);
        sum += row - 1 + column - 1;
    }
    return -sum;
}

/* Replaces a matrix of `count` rows by its triangular factors. It is scaled as that of other factors if there are any,
   and otherwise so that the largest entry of each row, and then of each column, lies between 2 and 4. If it is singular
   up to rounding, the determinant is stored in `detail`. */
static int kin_factor(int count, kin_factors *factors, const kin_factors *scaled, double *detail)
{
    double largest = 0.0;
    int singular = 0;
    factors->odd = 0;
    for (int row = 0; row < count; row++) {
        double size = 0.0;
        for (int column = 0; column < count; column++) {
            const double entry = fabs(factors->entries[row][column]);
            if (!(entry <= DBL_MAX)) {
                *detail = 0.0;
                return KIN_NOT_FINITE;
            }
            size = entry > size ? entry : size;
        }
        factors->row_scales[row] = scaled ? scaled->row_scales[row] : kin_levelling(size);
        factors->origins[row] = row;
    }
    for (int row = 0; row < count; row++) {
        for (int column = 0; column < count; column++) {
            factors->entries[row][column] *= factors->row_scales[row];
        }
    }
    for (int column = 0; column < count; column++) {
        double size = 0.0;
        for (int row = 0; row < count; row++) {
            const double entry = fabs(factors->entries[row][column]);
            size = entry > size ? entry : size;
        }
        factors->column_scales[column] = scaled ? scaled->column_scales[column] : kin_levelling(size);
        for (int row = 0; row < count; row++) {
            factors->entries[row][column] *= factors->column_scales[column];
            if (fabs(factors->entries[row][column]) > largest) {
                largest = fabs(factors->entries[row][column]);
            }
        }
    }
    for (int step = 0; step < count; step++) {
        int best = step;
        for (int row = step + 1; row < count; row++) {
            if (fabs(factors->entries[row][step]) > fabs(factors->entries[best][step])) {
                best = row;
            }
        }
        if (best != step) {
            const int origin = factors->origins[best];
            factors->origins[best] = factors->origins[step];
            factors->origins[step] = origin;
            for (int column = 0; column < count; column++) {
                const double entry = factors->entries[best][column];
                factors->entries[best][column] = factors->entries[step][column];
                factors->entries[step][column] = entry;
            }
            factors->odd = !factors->odd;
        }
        const double pivot = factors->entries[step][step];
        if (!(fabs(pivot) > 2.0 * (double)count * DBL_EPSILON * largest)) {
            singular = 1;
        }
        if (!(fabs(pivot) > 0.0)) {
            break;
        }
        for (int row = step + 1; row < count; row++) {
            const double multiplier = factors->entries[row][step] / pivot;
            factors->entries[row][step] = multiplier;
            for (int column = step + 1; column < count; column++) {
                const double product = multiplier * factors->entries[step][column];
                factors->entries[row][column] = factors->entries[row][column] - product;
                if (fabs(factors->entries[row][column]) > largest) {
                    largest = fabs(factors->entries[row][column]);
                }
            }
        }
    }
    *detail = 0.0;
    if (singular) {
        *detail = ldexp(kin_pivots(count, factors), kin_exponent(count, factors));
        return fabs(*detail) <= DBL_MAX ? KIN_SINGULAR : KIN_NOT_FINITE;
    }
    return KIN_FOUND;
}

/* The solution for a right-hand side given in the order of the rows of the matrix. */
static void kin_substitute(int count, const kin_factors *factors, const double *right, double *solution)
{
    /* The compiler does not know that a matrix has at most as many rows as there are places. */
    for (int row = 0; row < count && row < KIN_UNKNOWNS; row++) {
        const int origin = factors->origins[row];
        double sum = right[origin] * factors->row_scales[origin];
        for (int column = 0; column < row; column++) {
            const double product = factors->entries[row][column] * solution[column];
            sum = sum - product;
        }
        solution[row] = sum;
    }
    for (int row = count - 1; row >= 0; row--) {
        double sum = solution[row];
        for (int column = row + 1; column < count; column++) {
            const double product = factors->entries[row][column] * solution[column];
            sum = sum - product;
        }
        solution[row] = sum / factors->entries[row][row];
    }
    for (int row = 0; row < count; row++) {
        solution[row] *= factors->column_scales[row];
    }
}
