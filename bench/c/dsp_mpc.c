/*
 * Model predictive control with the emitted C.
 */
#include "dsp_plan.h"

#include "models.h"
#include "mpc.h"

#include <string.h>

static problem_t problem;
static plan_t plan;
static mpc_t mpc;

void run_jobs(void)
{
    fill_problem(&problem);
    (void)memcpy(&plan, &problem, sizeof plan);
    for (size_t i = 0; i < STEPS; i++) {
        float state[STATES];
        float input[INPUTS];
        fill(state, STATES, 11U + (uint32_t)i);
        bench_begin();
        mpc_step(&mpc, &plan, state, input);
        bench_end();
        report(input, INPUTS);
    }
    bench_begin();
    const float sine = models_sine(0.7f);
    bench_end();
    report(&sine, 1);
    bench_begin();
    const float fast = models_sine_fast(0.7f);
    bench_end();
    report(&fast, 1);
    float output[2];
    bench_begin();
    models_clarke_park_at(0.5f, -0.25f, 0.7f, output);
    bench_end();
    report(output, 2);
    bench_begin();
    models_clarke_park_fast(0.5f, -0.25f, 0.7f, output);
    bench_end();
    report(output, 2);
}
