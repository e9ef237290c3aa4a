/*
 * Predictive control by the emitted alternating directions.
 */
#include "qp.h"

#include "split.h"
#include "problem.h"

#include <string.h>

static split_t solver;
static split_step_work_t work;
static admm_program_f64_40_40_t program;
static double low[UNKNOWNS];

void start(void)
{
    split_init(&solver);
    (void)memcpy(program.inverse, SPLIT, sizeof program.inverse);
    (void)memcpy(program.weights, WEIGHTS, sizeof program.weights);
    for (size_t i = 0; i < UNKNOWNS; i++) {
        program.rows[UNKNOWNS * i + i] = 1.0;
    }
    program.tolerance = 1e-9;
    for (size_t i = 0; i < UNKNOWNS; i++) {
        low[i] = -MOST[i];
    }
}

void step(const double state[NX], double input[NU])
{
    double gradient[UNKNOWNS] = {0};
    for (size_t k = 0; k < NX; k++) {
        for (size_t i = 0; i < UNKNOWNS; i++) {
            gradient[i] += GRADIENT[UNKNOWNS * k + i] * state[k];
        }
    }
    minimum_f64_40_t found;
    split_step(&solver, &program, gradient, low, MOST, &work, &found);
    (void)memcpy(input, found.point, NU * sizeof input[0]);
}
