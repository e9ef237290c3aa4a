/*
 * The autopilot's filter with the emitted C.
 */
#include "autopilot_bench.h"

#include "autopilot.h"

#include <string.h>

static autopilot_t autopilot;
static autopilot_place_work_t of_place;
static autopilot_compass_work_t of_compass;

void start(const real state[STATES], const real spread[STATES])
{
    autopilot_init(&autopilot);
    autopilot_start(&autopilot, state, spread);
}

void predict(const real rate[3], const real force[3], real period)
{
    imu_t imu;
    (void)memcpy(imu.rate, rate, sizeof imu.rate);
    (void)memcpy(imu.force, force, sizeof imu.force);
    autopilot_predict(&autopilot, &imu, period);
}

void place(const real measured[6])
{
    (void)autopilot_place(&autopilot, measured, &of_place);
}

void compass(const real measured[3])
{
    (void)autopilot_compass(&autopilot, measured, &of_compass);
}

void finish(real state[STATES], real covariance[HALF])
{
    (void)memcpy(state, autopilot.state, sizeof autopilot.state);
    for (size_t row = 0; row < STATES; row++) {
        for (size_t col = 0; col <= row; col++) {
            *covariance++ = autopilot.covariance.elements[row + STATES * col];
        }
    }
}
