/*
 * The program around the predictive control of two contenders on the host, which alternate: `cargo xtask bench --only dsp`.
 *
 * It prints the median times of a step in microseconds, and the quartiles of the ratio of their times.
 */
#include "dsp_plan.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { CONTENDERS = 2, ROUNDS = 401, CALLS = 50 };

void run_emitted(void);
void run_eigen(void);

static struct timespec start;
static double spent;
static unsigned steps;
static float results[CONTENDERS][INPUTS];
static unsigned contender;

void bench_begin(void)
{
    (void)clock_gettime(CLOCK_MONOTONIC, &start);
}

void bench_end(void)
{
    struct timespec end;
    (void)clock_gettime(CLOCK_MONOTONIC, &end);
    /* The jobs after the predictive control do not count. */
    if (steps < STEPS) {
        spent += (double)(end.tv_sec - start.tv_sec) * 1e6 + (double)(end.tv_nsec - start.tv_nsec) * 1e-3;
    }
}

void report(const float *numbers, size_t count)
{
    if (steps == 0U && count == INPUTS) {
        for (size_t i = 0; i < INPUTS; i++) {
            results[contender][i] = numbers[i];
        }
    }
    steps++;
}

static double time_of(unsigned number)
{
    contender = number;
    spent = 0.0;
    for (int i = 0; i < CALLS; i++) {
        steps = 0U;
        if (number == 0U) {
            run_emitted();
        } else {
            run_eigen();
        }
    }
    return spent / (CALLS * STEPS);
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(void)
{
    static double times[CONTENDERS][ROUNDS];
    static double ratios[ROUNDS];
    /* The first call of each begins with no iteration done; later ones of the emitted C go on. */
    steps = 0U;
    contender = 0U;
    run_emitted();
    steps = 0U;
    contender = 1U;
    run_eigen();
    for (size_t i = 0; i < INPUTS; i++) {
        if (!(fabsf(results[0][i] - results[1][i]) <= 2e-4f)) {
            (void)fprintf(stderr, "the contenders have other results\n");
            return 1;
        }
    }
    for (unsigned round = 0; round < ROUNDS; round++) {
        const unsigned first = round % 2U;
        times[first][round] = time_of(first);
        times[1U - first][round] = time_of(1U - first);
        ratios[round] = times[0][round] / times[1][round];
    }
    qsort(times[0], ROUNDS, sizeof(double), ascending);
    qsort(times[1], ROUNDS, sizeof(double), ascending);
    qsort(ratios, ROUNDS, sizeof(double), ascending);
    (void)printf("%.3f %.3f %.4f %.4f %.4f\n", times[0][ROUNDS / 2], times[1][ROUNDS / 2],
        ratios[ROUNDS / 4], ratios[ROUNDS / 2], ratios[ROUNDS - 1 - ROUNDS / 4]);
    return 0;
}
