/*
 * The filter with the C++ that SymForce generates.
 */
#include "ekf.h"

#include "step.h"

/* Two places in turn: the generated code writes results while it still reads arguments. */
static Eigen::Matrix<real, STATES, 1> state[2];
static Eigen::Matrix<real, HALF, 1> covariance[2];
static int now;

void start(const real spread[STATES])
{
    for (int i = 0; i < STATES; i++) {
        covariance[0](i * (i + 1) / 2 + i, 0) = spread[i];
    }
}

void step(const real rate[3], const real force[3], real period, const real measured[6])
{
    Eigen::Matrix<real, 3, 1> turning, pushing;
    Eigen::Matrix<real, 6, 1> seen;
    for (int i = 0; i < 3; i++) {
        turning(i, 0) = rate[i];
        pushing(i, 0) = force[i];
    }
    for (int i = 0; i < 6; i++) {
        seen(i, 0) = measured[i];
    }
    const int last = now;
    now = 1 - now;
    sym::Step<real>(state[last], covariance[last], turning, pushing, period, seen, &state[now],
        &covariance[now]);
}

void angles(const real three[3], real six[6])
{
    for (int i = 0; i < 3; i++) {
        six[2 * i] = std::sin(three[i]);
        six[2 * i + 1] = std::cos(three[i]);
    }
}

void finish(real a[STATES], real b[HALF])
{
    for (int i = 0; i < STATES; i++) {
        a[i] = state[now](i, 0);
    }
    for (int i = 0; i < HALF; i++) {
        b[i] = covariance[now](i, 0);
    }
}
