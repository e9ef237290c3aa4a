/*
 * Model predictive control with the emitted C.
 */
#include "dsp_plan.h"

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
}
