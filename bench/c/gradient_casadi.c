/*
 * The gradient with the C that CasADi generates.
 */
#include "gradient.h"

#include <math.h>

int gradient_step(const real **arg, real **res, int *iw, real *w, int mem);

const real *step(const real start[STATES], const real inputs[INPUTS], real period, real *cost)
{
    static real slopes[INPUTS];
    const real *arg[3] = {start, inputs, &period};
    real *res[2] = {cost, slopes};
    (void)gradient_step(arg, res, 0, 0, 0);
    return slopes;
}

void angles(real angle, real two[2])
{
#ifdef BENCH_SINGLE
    two[0] = sinf(angle);
    two[1] = cosf(angle);
#else
    two[0] = sin(angle);
    two[1] = cos(angle);
#endif
}
