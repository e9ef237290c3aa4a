/*
 * Predictive control by the emitted active set.
 */
#include "qp.h"

#include "exact.h"
#include "problem.h"

#include <string.h>

static exact_t solver;
static exact_step_work_t work;
static active_set_program_f64_40_40_t program;
static double low[UNKNOWNS];

void start(void)
{
    exact_init(&solver);
    /* The rows are the unknowns, so A L^-T is L^-T. */
    (void)memcpy(program.inverse, INVERSE, sizeof program.inverse);
    (void)memcpy(program.rows, INVERSE, sizeof program.rows);
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
    exact_step(&solver, &program, gradient, low, MOST, &work, &found);
    (void)memcpy(input, found.point, NU * sizeof input[0]);
}
