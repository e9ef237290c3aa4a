/*
 * The autopilot's filter with the C++ that SymForce generates.
 */
#include "autopilot_bench.h"

#include "compass.h"
#include "place.h"
#include "predict.h"

/* Two places in turn: the generated code writes results while it still reads arguments. */
static Eigen::Matrix<real, STATES, 1> held[2];
static Eigen::Matrix<real, HALF, 1> covariance[2];
static int now;

void start(const real state[STATES], const real spread[STATES])
{
    for (int i = 0; i < STATES; i++) {
        held[0](i, 0) = state[i];
        covariance[0](i * (i + 1) / 2 + i, 0) = spread[i];
    }
}

void predict(const real rate[3], const real force[3], real period)
{
    Eigen::Matrix<real, 3, 1> turning, pushing;
    for (int i = 0; i < 3; i++) {
        turning(i, 0) = rate[i];
        pushing(i, 0) = force[i];
    }
    const int last = now;
    now = 1 - now;
    sym::Predict<real>(held[last], covariance[last], turning, pushing, period, &held[now], &covariance[now]);
}

void place(const real measured[6])
{
    Eigen::Matrix<real, 6, 1> seen;
    for (int i = 0; i < 6; i++) {
        seen(i, 0) = measured[i];
    }
    const int last = now;
    now = 1 - now;
    sym::Place<real>(held[last], covariance[last], seen, &held[now], &covariance[now]);
}

void compass(const real measured[3])
{
    Eigen::Matrix<real, 3, 1> seen;
    for (int i = 0; i < 3; i++) {
        seen(i, 0) = measured[i];
    }
    const int last = now;
    now = 1 - now;
    sym::Compass<real>(held[last], covariance[last], seen, &held[now], &covariance[now]);
}

void finish(real a[STATES], real b[HALF])
{
    for (int i = 0; i < STATES; i++) {
        a[i] = held[now](i, 0);
    }
    for (int i = 0; i < HALF; i++) {
        b[i] = covariance[now](i, 0);
    }
}
