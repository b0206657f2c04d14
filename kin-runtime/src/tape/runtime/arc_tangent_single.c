#ifdef KIN_PLATFORM_FUNCTIONS

/* The angle from the x axis to the point (x, y). */
static float kin_atan2(float y, float x)
{
    return atan2f(y, x);
}

#else

/* pi/4 as a sum. The products of the first part with the numbers up to 4 are exact. */
static const float kin_half_right_angle[2] = {@HALF_RIGHT_ANGLE@};

/* (t - atan t) / t^3 in powers of t^2, for |t| <= 1/2. */
static const float kin_arc_tangent[6] = {@ARC_TANGENT@};

/* The angle from the x axis to the point (x, y): at most 4 units in the last place from the exact value. The origin,
   and coordinates that are not finite or whose sum overflows, are left to <math.h>. */
static float kin_atan2(float y, float x)
{
    const float height = fabsf(y);
    const float width = fabsf(x);
    const float greater = height > width ? height : width;
    const float lesser = height > width ? width : height;
    const int slanting = lesser > greater - lesser;
    const float side = copysignf(1.0f, x);
    const float sense = side * copysignf(1.0f, width - height);
    /* 0, 2 or 4 at the nearest axis, and 1 or 3 at a diagonal. */
    const float multiple = (2.0f - side) - (slanting ? 0.0f : sense);
    const float across = slanting ? lesser - greater : lesser;
    const float along = slanting ? greater + lesser : greater;
    const float fraction = across / along;
    if (fabsf(along * fraction) <= FLT_MAX) {
        const float *c = kin_arc_tangent;
        const float z = fraction * fraction;
        const float square = z * z;
        const float oriented = sense * fraction;
        const float series = ((c[0] + c[1] * z) + (c[2] + c[3] * z) * square) + (c[4] + c[5] * z) * (square * square);
        const float rest = multiple * kin_half_right_angle[1] - (oriented * z) * series;
        return copysignf(multiple * kin_half_right_angle[0] + (oriented + rest), y);
    }
    return atan2f(y, x);
}

#endif
