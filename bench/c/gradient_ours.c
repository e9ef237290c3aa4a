/*
 * The gradient with the emitted C.
 */
#include "gradient.h"

#include "models.h"
#include "sine.h"

#ifdef BENCH_SINGLE
typedef pair_f32_matrix2x50_f32_t pair_t;
#else
typedef pair_f64_matrix2x50_f64_t pair_t;
#endif

const real *step(const real start[STATES], const real inputs[INPUTS], real period, real *cost)
{
    static pair_t pair;
#ifdef BENCH_SINGLE
    models_slopes(start, inputs, period, &pair);
#else
    /* At least as many numbers as the header wants. */
    static real work[1000];
    models_slopes(start, inputs, period, work, &pair);
#endif
    *cost = pair.first;
    return pair.second;
}

void angles(real angle, real two[2])
{
#ifdef BENCH_SINGLE
    two[0] = sine_sinf(angle);
    two[1] = sine_cosf(angle);
#else
    two[0] = sine_sin(angle);
    two[1] = sine_cos(angle);
#endif
}
