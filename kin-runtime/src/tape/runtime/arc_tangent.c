#ifdef KIN_PLATFORM_FUNCTIONS

/* The angle from the x axis to the point (x, y). */
static double kin_atan2(double y, double x)
{
    return atan2(y, x);
}

#else

/* pi/4 as a sum. The products of the first part with the numbers up to 4 are exact. */
static const double kin_half_right_angle[2] = {@HALF_RIGHT_ANGLE@};

/* (t - atan t) / t^3 in powers of t^2, for |t| <= 1/2. */
static const double kin_arc_tangent[12] = {@ARC_TANGENT@};

/* A polynomial of twelve coefficients. */
static double kin_twelve(const double *c, double z)
{
    const double z2 = z * z;
    const double z4 = z2 * z2;
    const double low = (c[0] + c[1] * z) + (c[2] + c[3] * z) * z2;
    const double middle = (c[4] + c[5] * z) + (c[6] + c[7] * z) * z2;
    const double high = (c[8] + c[9] * z) + (c[10] + c[11] * z) * z2;
    return (low + middle * z4) + high * (z4 * z4);
}

/* The angle from the x axis to the point (x, y): at most 1.5 units in the last place from the exact value, and the same
   bits as those of kin. The origin, and coordinates that are not finite or whose sum overflows, are left to <math.h>. */
static double kin_atan2(double y, double x)
{
    const double height = fabs(y);
    const double width = fabs(x);
    const double greater = height > width ? height : width;
    const double lesser = height > width ? width : height;
    const int slanting = lesser > greater - lesser;
    const double side = copysign(1.0, x);
    const double sense = side * copysign(1.0, width - height);
    /* 0, 2 or 4 at the nearest axis, and 1 or 3 at a diagonal. */
    const double multiple = (2.0 - side) - (slanting ? 0.0 : sense);
    const double across = slanting ? lesser - greater : lesser;
    const double along = slanting ? greater + lesser : greater;
    const double fraction = across / along;
    if (fabs(along * fraction) <= DBL_MAX) {
        const double z = fraction * fraction;
        const double turned = sense * fraction;
        const double rest = multiple * kin_half_right_angle[1] - (turned * z) * kin_twelve(kin_arc_tangent, z);
        return copysign(multiple * kin_half_right_angle[0] + (turned + rest), y);
    }
    return atan2(y, x);
}

#endif
