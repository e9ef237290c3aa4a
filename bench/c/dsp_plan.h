/*
 * The problem of model predictive control, equal for each contender: matrices by columns, small enough that nothing
 * grows. The same instructions run for any numbers.
 */
#ifndef DSP_PLAN_H
#define DSP_PLAN_H

#include "dsp.h"

enum { STATES = 12, INPUTS = 4, HORIZON = 10, STEPS = 2 };

typedef struct {
    float a[STATES * STATES];
    float b[STATES * INPUTS];
    float gain[INPUTS * STATES];
    float closed[STATES * STATES];
    float inverse[INPUTS * INPUTS];
    float cost_to_go[STATES * STATES];
    float cost[STATES];
    float target[STATES];
    float low[STATES];
    float high[STATES];
    float least[INPUTS];
    float most[INPUTS];
    float rho;
} problem_t;

static inline void scaled(float *numbers, size_t count, uint32_t seed, float scale)
{
    fill(numbers, count, seed);
    for (size_t i = 0; i < count; i++) {
        numbers[i] *= scale;
    }
}

static inline void fill_problem(problem_t *problem)
{
    scaled(problem->a, STATES * STATES, 1U, 0.05f);
    scaled(problem->b, STATES * INPUTS, 2U, 0.3f);
    scaled(problem->gain, INPUTS * STATES, 3U, 0.1f);
    scaled(problem->closed, STATES * STATES, 4U, 0.04f);
    scaled(problem->inverse, INPUTS * INPUTS, 5U, 0.1f);
    scaled(problem->cost_to_go, STATES * STATES, 6U, 0.2f);
    scaled(problem->target, STATES, 7U, 1.0f);
    for (size_t i = 0; i < STATES; i++) {
        problem->a[i + STATES * i] += 0.6f;
        problem->closed[i + STATES * i] += 0.5f;
        problem->cost_to_go[i + STATES * i] += 2.0f;
        problem->cost[i] = 1.0f + 0.1f * (float)i;
        problem->low[i] = -0.75f;
        problem->high[i] = 0.5f;
    }
    for (size_t i = 0; i < INPUTS; i++) {
        problem->inverse[i + INPUTS * i] += 0.5f;
        problem->least[i] = -0.25f;
        problem->most[i] = 0.5f;
    }
    problem->rho = 0.5f;
}

#endif
