#ifdef KIN_PLATFORM_FUNCTIONS

/* The sine and the cosine of an angle in radians. */
static void kin_sine_cosine(float angle, float *sine, float *cosine)
{
    *sine = sinf(angle);
    *cosine = cosf(angle);
}

#else

/* The largest angle that is reduced here. */
#define KIN_NEAR @LIMIT@

/* A number whose addition rounds to an integer. */
#define KIN_ROUNDING @ROUNDING@

/* pi/2 as a sum. The products of the first four parts with a number of right angles are exact. */
static const float kin_right_angle[5] = {@RIGHT_ANGLE@};

/* (r - sin r) / r^3 and (cos r - 1 + r^2/2) / r^4 in powers of r^2, for |r| <= pi/4. */
static const float kin_sine[4] = {@SINE@};
static const float kin_cosine[3] = {@COSINE@};

/* The sine and the cosine of an angle in radians: at most 4 units in the last place from the exact values. Angles
   beyond KIN_NEAR are left to <math.h>. */
static void kin_sine_cosine(float angle, float *sine, float *cosine)
{
    if (fabsf(angle) <= KIN_NEAR) {
        const float shifted = angle * @TWO_OVER_PI@ + KIN_ROUNDING;
        const float right_angles = shifted - KIN_ROUNDING;
        const float first = ((angle - right_angles * kin_right_angle[0]) - right_angles * kin_right_angle[1])
            - right_angles * kin_right_angle[2];
        const float second = right_angles * kin_right_angle[3];
        const float r = first - second;
        /* The amount by which r is too large. */
        const float tail = right_angles * kin_right_angle[4] + (second - (first - r));
        const float z = r * r;
        const float cubic = (kin_sine[0] + kin_sine[1] * z) + (kin_sine[2] + kin_sine[3] * z) * (z * z);
        const float quartic = (kin_cosine[0] + kin_cosine[1] * z) + kin_cosine[2] * (z * z);
        const float s = r - ((r * z) * cubic + tail);
        const float c = 1.0f - (0.5f * z - (z * z) * quartic);
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
        *sine = sinf(angle);
        *cosine = cosf(angle);
    }
}

#endif
