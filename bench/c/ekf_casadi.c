/*
 * The filter with the C that CasADi generates.
 */
#include "ekf.h"

#include <math.h>
#include <string.h>

int ekf_step(const real **arg, real **res, int *iw, real *w, int mem);

/* Two places in turn: the generated code writes results while it still reads arguments. */
static real state[2][STATES];
static real covariance[2][HALF];
static int now;

void start(const real spread[STATES])
{
    for (int i = 0; i < STATES; i++) {
        covariance[0][i * (i + 1) / 2 + i] = spread[i];
    }
}

void step(const real rate[3], const real force[3], real period, const real measured[6])
{
    const real *arg[6] = {state[now], covariance[now], rate, force, &period, measured};
    now = 1 - now;
    real *res[2] = {state[now], covariance[now]};
    (void)ekf_step(arg, res, 0, 0, 0);
}

void angles(const real three[3], real six[6])
{
    for (int i = 0; i < 3; i++) {
#ifdef BENCH_SINGLE
        six[2 * i] = sinf(three[i]);
        six[2 * i + 1] = cosf(three[i]);
#else
        six[2 * i] = sin(three[i]);
        six[2 * i + 1] = cos(three[i]);
#endif
    }
}

void finish(real a[STATES], real b[HALF])
{
    (void)memcpy(a, state[now], sizeof state[now]);
    (void)memcpy(b, covariance[now], sizeof covariance[now]);
}
