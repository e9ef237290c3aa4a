/*
 * Predictive control by the code of OSQP: states and inputs are unknown, and the first rows are the dynamics.
 */
#include "qp.h"

#include "osqp.h"
#include "problem.h"
#include "workspace.h"

static double low[NX * PERIODS + UNKNOWNS];
static double high[NX * PERIODS + UNKNOWNS];

void start(void)
{
    for (size_t i = 0; i < UNKNOWNS; i++) {
        low[NX * PERIODS + i] = -MOST[i];
        high[NX * PERIODS + i] = MOST[i];
    }
}

void step(const double state[NX], double input[NU])
{
    for (size_t i = 0; i < NX; i++) {
        double next = 0.0;
        for (size_t k = 0; k < NX; k++) {
            next -= PLANT_A[NX * k + i] * state[k];
        }
        low[i] = next;
        high[i] = next;
    }
    (void)osqp_update_data_vec(&solver, NULL, low, high);
    (void)osqp_solve(&solver);
    for (size_t i = 0; i < NU; i++) {
        input[i] = solver.solution->x[NX * PERIODS + i];
    }
}
