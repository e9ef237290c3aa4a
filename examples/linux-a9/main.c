/*
 * main.c: the onboard software as a process of Linux on a Cortex-A9, 200 times a second.
 *
 *     onboard PERIODS
 *
 * Each period begins at its time on the monotonic clock, whatever the one before took; one that begins more than half a
 * period late is counted. The sensors are those of an aircraft that stands on the ground: put your drivers in
 * the place of sense() and act().
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#define _POSIX_C_SOURCE 200112L

#include <inttypes.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "onboard.h"
#include "tuning.h"

#define NANOSECONDS 1000000000L

/** A period of 200 Hz, ns. */
#define PERIOD 5000000L

/** Counts of the accelerometer for 1 g. */
#define ONE_G 4096

/** What the sensors say in a period of an aircraft at rest, with some noise: Vicon at 100 Hz, the altimeter at 20 Hz. */
static void sense(uint32_t period, inputs_t *inputs)
{
    memset(inputs, 0, sizeof *inputs);
    inputs->time = 1000000U + (uint64_t)period * 5000U;
    inputs->readings.inertial.fresh = true;
    inputs->readings.inertial.gyroscope[0] = (int16_t)((int32_t)(period % 7U) - 3);
    inputs->readings.inertial.accelerometer[0] = (int16_t)((int32_t)(period % 5U) - 2);
    inputs->readings.inertial.accelerometer[2] = ONE_G;
    inputs->readings.vicon.fresh = period % 2U == 0U;
    inputs->readings.echo.fresh = period % 10U == 0U;
    inputs->readings.echo.delay = 100U;
}

/** What the motors are told: here nobody listens. */
static void act(const command_t *command)
{
    (void)command;
}

/** How much later one time is than another, ns. */
static int64_t since(const struct timespec *later, const struct timespec *earlier)
{
    return ((int64_t)later->tv_sec - (int64_t)earlier->tv_sec) * NANOSECONDS + (later->tv_nsec - earlier->tv_nsec);
}

static void print(const char *name, const double values[3])
{
    (void)printf("%s", name);
    for (unsigned n = 0U; n < 3U; ++n) {
        uint64_t bits;
        memcpy(&bits, &values[n], sizeof bits);
        (void)printf(" %016" PRIx64, bits);
    }
    (void)printf("\n");
}

int main(int argc, char **argv)
{
    static onboard_t onboard;
    static settings_t settings;
    static inputs_t inputs;
    static outputs_t outputs;
    static onboard_step_work_t work;
    const uint32_t periods = (argc == 2) ? (uint32_t)strtoul(argv[1], NULL, 10) : 0U;
    uint32_t late = 0U;
    int64_t longest = 0;
    struct timespec due;
    struct timespec begun;
    struct timespec ended;

    if (periods == 0U) {
        (void)fprintf(stderr, "usage: onboard PERIODS\n");
        return 2;
    }
    onboard_init(&onboard);
    settings_mambo(&settings);
    (void)clock_gettime(CLOCK_MONOTONIC, &due);
    for (uint32_t n = 0U; n < periods; ++n) {
        while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, NULL) != 0) {
        }
        (void)clock_gettime(CLOCK_MONOTONIC, &begun);
        sense(n, &inputs);
        onboard_step(&onboard, &settings, &inputs, &work, &outputs);
        (void)settings_grant(&settings, &outputs.wish, outputs.reference.motors);
        act(&outputs.command);
        (void)clock_gettime(CLOCK_MONOTONIC, &ended);

        late += (since(&begun, &due) > PERIOD / 2) ? 1U : 0U;
        longest = (since(&ended, &begun) > longest) ? since(&ended, &begun) : longest;
        due.tv_nsec += PERIOD;
        if (due.tv_nsec >= NANOSECONDS) {
            due.tv_nsec -= NANOSECONDS;
            ++due.tv_sec;
        }
    }
    print("position", outputs.estimate.position);
    print("angles", outputs.estimate.angles);
    (void)fprintf(stderr, "%" PRIu32 " periods, %" PRIu32 " late, the longest step took %" PRId64 " us\n", periods, late,
        longest / 1000);
    return 0;
}
