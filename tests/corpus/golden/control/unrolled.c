/* The C of tests/corpus/src/programs/control/unrolled.rs. Written by a test. */

/* unrolled.c */

/* So many passes of the loop are written out at once; 1 keeps the loop. Nothing where the compiler is not known. */
#ifndef BESSEMER_UNROLL
#if defined(__clang__)
#define BESSEMER_PRAGMA(text) _Pragma(#text)
#define BESSEMER_UNROLL(count) BESSEMER_PRAGMA(unroll count)
#elif defined(__GNUC__) && __GNUC__ >= 8
#define BESSEMER_PRAGMA(text) _Pragma(#text)
#define BESSEMER_UNROLL(count) BESSEMER_PRAGMA(GCC unroll count)
#else
#define BESSEMER_UNROLL(count)
#endif
#endif

float unrolled_weighted(const float values[16], const float weights[16])
{
    float sum = 0.0F;
    BESSEMER_UNROLL(4)
    for (uint32_t i = 0U; i < 16U; i++) {
        sum += values[i] * weights[i];
    }
    return sum;
}

float unrolled_short(const float values[4], const float weights[4])
{
    float sum = 0.0F;
    BESSEMER_UNROLL(1)
    for (uint32_t i = 0U; i < 4U; i++) {
        const float weight = weights[i];
        sum += values[i] * weight;
    }
    return sum;
}
