
/* Reads cases and writes results, as doubles. */
#include <stdio.h>

static int numbers(FILE *file, int count, double *values)
{
    return fread(values, sizeof values[0], (size_t)count, file) == (size_t)count;
}

static void four_bar(const void *given, const double *u, double *residuals, double jacobian[KIN_UNKNOWNS][KIN_UNKNOWNS])
{
    const double *r = given;
    double s2, c2, s3, c3, s4, c4;
    kin_sine_cosine(r[4], &s2, &c2);
    kin_sine_cosine(u[0], &s3, &c3);
    kin_sine_cosine(u[1], &s4, &c4);
    residuals[0] = r[1] * c2 + r[2] * c3 - r[0] - r[3] * c4;
    residuals[1] = r[1] * s2 + r[2] * s3 - r[3] * s4;
    jacobian[0][0] = -(r[2] * s3);
    jacobian[0][1] = r[3] * s4;
    jacobian[1][0] = r[2] * c3;
    jacobian[1][1] = -(r[3] * c4);
}

static void surfaces(const void *given, const double *u, double *residuals, double jacobian[KIN_UNKNOWNS][KIN_UNKNOWNS])
{
    const double *g = given;
    residuals[0] = u[0] * u[0] + u[1] * u[1] + u[2] * u[2] - g[0];
    residuals[1] = u[0] * u[1] - g[1] * u[2];
    residuals[2] = u[0] + u[1] * u[2] - g[2];
    jacobian[0][0] = 2.0 * u[0];
    jacobian[0][1] = 2.0 * u[1];
    jacobian[0][2] = 2.0 * u[2];
    jacobian[1][0] = u[1];
    jacobian[1][1] = u[0];
    jacobian[1][2] = -g[1];
    jacobian[2][0] = 1.0;
    jacobian[2][1] = u[2];
    jacobian[2][2] = u[1];
}

static int elementary(FILE *in, FILE *out)
{
    double point[2];
    while (numbers(in, 2, point)) {
        double found[3];
        kin_sine_cosine(point[0], &found[0], &found[1]);
        found[2] = kin_atan2(point[0], point[1]);
        fwrite(found, sizeof found, 1, out);
    }
    return 0;
}

static int newton(FILE *in, FILE *out, int count, int given_count, kin_equations equations, const double *sizes)
{
    double given[12];
    while (numbers(in, given_count + count, given)) {
        double found[KIN_UNKNOWNS + 2] = {0.0};
        kin_block block = {0, 0, 0, 0};
        block.count = count;
        block.equations = equations;
        block.given = given;
        block.sizes = sizes;
        found[0] = (double)kin_newton(&block, given + given_count, found + 2, found + 1);
        fwrite(found, sizeof found[0], (size_t)(count + 2), out);
    }
    return 0;
}

static int matrices(FILE *in, FILE *out)
{
    double given[20];
    while (numbers(in, 20, given)) {
        kin_factors factors;
        double found[6] = {0.0};
        for (int row = 0; row < 4; row++) {
            for (int column = 0; column < 4; column++) {
                factors.entries[row][column] = given[4 * row + column];
            }
        }
        const int outcome = kin_factor(4, &factors, 0, found + 1);
        found[0] = (double)outcome;
        if (outcome == KIN_FOUND) {
            kin_substitute(4, &factors, given + 16, found + 2);
        }
        fwrite(found, sizeof found, 1, out);
    }
    return 0;
}

int main(int count, char **arguments)
{
    static const double angles[2] = {1.0, 1.0};
    static const double lengths[3] = {1.0, 2.0, 0.5};
    FILE *in = count == 2 ? fopen("in", "rb") : NULL;
    FILE *out = in ? fopen("out", "wb") : NULL;
    if (!in || !out) {
        return 1;
    }
    switch (arguments[1][0]) {
    case 'e':
        elementary(in, out);
        break;
    case 'f':
        newton(in, out, 2, 5, four_bar, angles);
        break;
    case 's':
        newton(in, out, 3, 3, surfaces, lengths);
        break;
    default:
        matrices(in, out);
        break;
    }
    fclose(in);
    return fclose(out);
}
