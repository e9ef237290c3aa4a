// Model predictive control with TinyMPC, whose folder the caller names. Its workspace is filled here, so that the
// problem equals the other contenders'.
extern "C" {
#include "dsp_plan.h"
}

#include "tinympc/admm.hpp"

namespace {

tinyMatrix matrix(const float *numbers, int rows, int columns)
{
    return Eigen::Map<const Eigen::MatrixXf>(numbers, rows, columns).cast<tinytype>();
}

tinyMatrix repeated(const float *numbers, int rows, int columns)
{
    return matrix(numbers, rows, 1).replicate(1, columns);
}

} // namespace

extern "C" void run_jobs(void)
{
    static problem_t problem;
    fill_problem(&problem);
    static TinySolution solution;
    static TinySettings settings;
    static TinyCache cache;
    static TinyWorkspace work;
    static TinySolver solver = {&solution, &settings, &cache, &work};

    settings.max_iter = 10;
    settings.check_termination = 1;
    settings.en_state_bound = 1;
    settings.en_input_bound = 1;
    settings.abs_pri_tol = 0;
    settings.abs_dua_tol = 0;
    cache.rho = problem.rho;
    cache.Kinf = matrix(problem.gain, INPUTS, STATES);
    cache.Pinf = matrix(problem.cost_to_go, STATES, STATES).transpose();
    cache.Quu_inv = matrix(problem.inverse, INPUTS, INPUTS);
    cache.AmBKt = matrix(problem.closed, STATES, STATES);
    cache.APf = tinyVector::Zero(STATES);
    cache.BPf = tinyVector::Zero(INPUTS);
    work.nx = STATES;
    work.nu = INPUTS;
    work.N = HORIZON;
    for (tinyMatrix *it : {&work.x, &work.q, &work.p, &work.v, &work.vnew, &work.g}) {
        *it = tinyMatrix::Zero(STATES, HORIZON);
    }
    for (tinyMatrix *it : {&work.u, &work.r, &work.d, &work.z, &work.znew, &work.y, &work.Uref}) {
        *it = tinyMatrix::Zero(INPUTS, HORIZON - 1);
    }
    work.x_min = repeated(problem.low, STATES, HORIZON);
    work.x_max = repeated(problem.high, STATES, HORIZON);
    work.u_min = repeated(problem.least, INPUTS, HORIZON - 1);
    work.u_max = repeated(problem.most, INPUTS, HORIZON - 1);
    work.Q = matrix(problem.cost, STATES, 1);
    work.R = tinyVector::Zero(INPUTS);
    work.Adyn = matrix(problem.a, STATES, STATES);
    work.Bdyn = matrix(problem.b, STATES, INPUTS);
    work.fdyn = tinyVector::Zero(STATES);
    work.Xref = repeated(problem.target, STATES, HORIZON);
    for (uint32_t i = 0; i < STEPS; i++) {
        float state[STATES];
        fill(state, STATES, 11U + i);
        work.x.col(0) = matrix(state, STATES, 1);
        bench_begin();
        (void)solve(&solver);
        bench_end();
        Eigen::VectorXf input = work.u.col(0).cast<float>();
        report(input.data(), INPUTS);
    }
}
