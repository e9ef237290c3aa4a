// Model predictive control with Eigen and fixed sizes, written for the purpose: each stage's vectors are updated in
// one expression, and nothing is allocated.
extern "C" {
#include "dsp_plan.h"
}

#include <Eigen/Dense>

namespace {

using State = Eigen::Matrix<float, STATES, 1>;
using Input = Eigen::Matrix<float, INPUTS, 1>;
using Square = Eigen::Matrix<float, STATES, STATES>;
using Into = Eigen::Matrix<float, STATES, INPUTS>;
using Gain = Eigen::Matrix<float, INPUTS, STATES>;
using Small = Eigen::Matrix<float, INPUTS, INPUTS>;

struct Solver {
    Square a, closed, cost_to_go;
    Into b;
    Gain gain;
    Small inverse;
    State cost, target, low, high;
    Input least, most;
    float rho;
    State x[HORIZON], slack[HORIZON], dual[HORIZON], q[HORIZON], p[HORIZON];
    Input u[HORIZON], slack_u[HORIZON], dual_u[HORIZON], r[HORIZON], d[HORIZON];
    float primal, residual;
};

Solver solver;

template <typename M> void load(M &matrix, const float *numbers)
{
    matrix = Eigen::Map<const M>(numbers);
}

__attribute__((noinline)) void step(Solver &s, const State &state, Input &input)
{
    const int last = HORIZON - 1;
    s.x[0] = state;
    for (int iteration = 0; iteration < 10; iteration++) {
        for (int i = 0; i < HORIZON; i++) {
            s.q[i] = -s.target.cwiseProduct(s.cost) - (s.slack[i] - s.dual[i]) * s.rho;
        }
        for (int i = 0; i < last; i++) {
            s.r[i] = -(s.slack_u[i] - s.dual_u[i]) * s.rho;
        }
        s.p[last] = -(s.cost_to_go.lazyProduct(s.target)) - (s.slack[last] - s.dual[last]) * s.rho;
        for (int i = last - 1; i >= 0; i--) {
            const Input sum = s.b.transpose().lazyProduct(s.p[i + 1]) + s.r[i];
            s.d[i] = s.inverse.lazyProduct(sum);
            s.p[i] = s.q[i] + s.closed.lazyProduct(s.p[i + 1]) - s.gain.transpose().lazyProduct(s.r[i]);
        }
        for (int i = 0; i < last; i++) {
            s.u[i] = -(s.gain.lazyProduct(s.x[i])) - s.d[i];
            s.x[i + 1] = s.a.lazyProduct(s.x[i]) + s.b.lazyProduct(s.u[i]);
        }
        s.primal = 0.0f;
        s.residual = 0.0f;
        for (int i = 0; i < HORIZON; i++) {
            const State slack = (s.x[i] + s.dual[i]).cwiseMax(s.low).cwiseMin(s.high);
            s.dual[i] += s.x[i] - slack;
            s.primal = std::max(s.primal, (s.x[i] - slack).cwiseAbs().maxCoeff());
            s.residual = std::max(s.residual, (s.slack[i] - slack).cwiseAbs().maxCoeff() * s.rho);
            s.slack[i] = slack;
        }
        for (int i = 0; i < last; i++) {
            const Input slack = (s.u[i] + s.dual_u[i]).cwiseMax(s.least).cwiseMin(s.most);
            s.dual_u[i] += s.u[i] - slack;
            s.primal = std::max(s.primal, (s.u[i] - slack).cwiseAbs().maxCoeff());
            s.residual = std::max(s.residual, (s.slack_u[i] - slack).cwiseAbs().maxCoeff() * s.rho);
            s.slack_u[i] = slack;
        }
    }
    input = s.u[0];
}

} // namespace

extern "C" void run_jobs(void)
{
    static problem_t problem;
    fill_problem(&problem);
    load(solver.a, problem.a);
    load(solver.b, problem.b);
    load(solver.gain, problem.gain);
    load(solver.closed, problem.closed);
    load(solver.inverse, problem.inverse);
    load(solver.cost_to_go, problem.cost_to_go);
    load(solver.cost, problem.cost);
    load(solver.target, problem.target);
    load(solver.low, problem.low);
    load(solver.high, problem.high);
    load(solver.least, problem.least);
    load(solver.most, problem.most);
    solver.rho = problem.rho;
    for (int i = 0; i < HORIZON; i++) {
        for (State *vector : {solver.x, solver.slack, solver.dual, solver.q, solver.p}) {
            vector[i].setZero();
        }
        for (Input *vector : {solver.u, solver.slack_u, solver.dual_u, solver.r, solver.d}) {
            vector[i].setZero();
        }
    }
    for (uint32_t i = 0; i < STEPS; i++) {
        float numbers[STATES];
        fill(numbers, STATES, 11U + i);
        State state;
        load(state, numbers);
        Input input;
        bench_begin();
        step(solver, state, input);
        bench_end();
        report(input.data(), INPUTS);
    }
}
