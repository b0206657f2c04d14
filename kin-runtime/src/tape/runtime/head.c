#include <float.h>
#include <math.h>

#if defined(__FAST_MATH__)
#error "the functions of kin need the rounding of IEEE 754: compile without -ffast-math"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0 && !defined(KIN_PLATFORM_FUNCTIONS)
#error "the functions of kin need numbers without extra digits: compile with -mfpmath=sse, or define KIN_PLATFORM_FUNCTIONS"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif
