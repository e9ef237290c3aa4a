/*
 * The filter with the emitted C.
 */
#include "ekf.h"

#include "navigation.h"
#include "sine.h"

#include <string.h>

static navigation_t navigation;
static navigation_step_work_t work;


void start(const real spread[STATES])
{
    navigation_init(&navigation);
    navigation_start(&navigation, spread);
}

void step(const real rate[3], const real force[3], real period, const real measured[6])
{
    inertial_t inertial;
    (void)memcpy(inertial.rate, rate, sizeof inertial.rate);
    (void)memcpy(inertial.force, force, sizeof inertial.force);
    (void)navigation_step(&navigation, &inertial, period, measured, &work);
}

void angles(const real three[3], real six[6])
{
    for (size_t i = 0; i < 3; i++) {
#ifdef BENCH_SINGLE
        pair_f32_f32_t pair;
        sine_sin_cosf(three[i], &pair);
#else
        pair_f64_f64_t pair;
        sine_sin_cos(three[i], &pair);
#endif
        six[2 * i] = pair.first;
        six[2 * i + 1] = pair.second;
    }
}

void finish(real state[STATES], real covariance[HALF])
{
    (void)memcpy(state, navigation.state, sizeof navigation.state);
    for (size_t row = 0; row < STATES; row++) {
        for (size_t col = 0; col <= row; col++) {
            *covariance++ = navigation.covariance.elements[row + STATES * col];
        }
    }
}
