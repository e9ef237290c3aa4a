// Predictive control with TinyMPC, whose folder the caller names.
#include "qp.h"

extern "C" {
#include "problem.h"
}

#include "tinympc/tiny_api.hpp"

#include <iostream>

static TinySolver *solver;

static tinyMatrix matrix(const double *numbers, int rows, int columns)
{
    return Eigen::Map<const Eigen::MatrixXd>(numbers, rows, columns).cast<tinytype>();
}

extern "C" void start(void)
{
    // It prints the number of its iterations.
    std::cout.setstate(std::ios::failbit);
    const int stages = PERIODS + 1;
    const tinyMatrix most = matrix(MOST, NU, PERIODS);
    const tinyMatrix far = tinyMatrix::Constant(NX, stages, 1e9);
    (void)tiny_setup(&solver, matrix(PLANT_A, NX, NX), matrix(PLANT_B, NX, NU), tinyMatrix::Zero(NX, 1),
        matrix(Q, NX, 1).asDiagonal(), matrix(R, NU, 1).asDiagonal(), WEIGHT, NX, NU, stages, 0);
    // The setup adds its weight to the costs twice, and stops before the gain is exact to the last digits.
    const tinyMatrix a = matrix(PLANT_A, NX, NX);
    const tinyMatrix b = matrix(PLANT_B, NX, NU);
    const tinyMatrix cost = matrix(COST_TO_GO, NX, NX);
    const tinyMatrix r = matrix(R, NU, 1).asDiagonal();
    TinyCache *cache = solver->cache;
    cache->Pinf = cost;
    cache->Quu_inv = (r + WEIGHT * tinyMatrix::Identity(NU, NU) + b.transpose() * cost * b).inverse();
    cache->Kinf = cache->Quu_inv * b.transpose() * cost * a;
    cache->AmBKt = (a - b * cache->Kinf).transpose();
    (void)tiny_set_bound_constraints(solver, -far, far, -most, most);
    solver->settings->max_iter = 20000;
    solver->settings->abs_pri_tol = 1e-9;
    solver->settings->abs_dua_tol = 1e-9;
    solver->settings->check_termination = 1;
    solver->settings->en_state_bound = 0;
}

extern "C" void step(const double state[NX], double input[NU])
{
    (void)tiny_set_x0(solver, matrix(state, NX, 1));
    (void)tiny_solve(solver);
    for (int i = 0; i < NU; i++) {
        input[i] = solver->solution->u(i, 0);
    }
}
