#ifdef KIN_PLATFORM_FUNCTIONS

/* The sine and the cosine of an angle in radians. */
static void kin_sine_cosine(double angle, double *sine, double *cosine)
{
    *sine = sin(angle);
    *cosine = cos(angle);
}

#else

/* The largest angle that is reduced here. */
#define KIN_NEAR @LIMIT@

/* A number whose addition rounds to an integer. */
#define KIN_ROUNDING @ROUNDING@

/* pi/2 as a sum. The products of the first two parts with a number of right angles are exact. */
static const double kin_right_angle[3] = {@RIGHT_ANGLE@};

/* (r - sin r) / r^3 and (cos r - 1 + r^2/2) / r^4 in powers of r^2, for |r| <= pi/4. */
static const double kin_sine[6] = {@SINE@};
static const double kin_cosine[6] = {@COSINE@};

/* A polynomial of six coefficients. */
static double kin_six(const double *c, double z)
{
    const double square = z * z;
    return ((c[0] + c[1] * z) + (c[2] + c[3] * z) * square) + (c[4] + c[5] * z) * (square * square);
}

/* The sine and the cosine of an angle in radians: at most 4/3 units in the last place from the exact values, and the
   same bits as those of kin. Angles beyond KIN_NEAR are left to <math.h>. */
static void kin_sine_cosine(double angle, double *sine, double *cosine)
{
    if (fabs(angle) <= KIN_NEAR) {
        const double shifted = angle * @TWO_OVER_PI@ + KIN_ROUNDING;
        const double right_angles = shifted - KIN_ROUNDING;
        const double first = angle - right_angles * kin_right_angle[0];
        const double second = right_angles * kin_right_angle[1];
        const double r = first - second;
        /* The amount by which r is too large. */
        const double tail = right_angles * kin_right_angle[2] + (second - (first - r));
        const double z = r * r;
        const double s = r - ((r * z) * kin_six(kin_sine, z) + tail);
        const double c = 1.0 - (0.5 * z - (z * z) * kin_six(kin_cosine, z));
        switch ((unsigned long)(long)right_angles & 3UL) {
        case 0:
            *sine = s;
            *cosine = c;
            break;
        case 1:
            *sine = c;
            *cosine = -s;
            break;
        case 2:
            *sine = -s;
            *cosine = -c;
            break;
        default:
            *sine = -c;
            *cosine = s;
            break;
        }
    } else {
        *sine = sin(angle);
        *cosine = cos(angle);
    }
}

#endif
