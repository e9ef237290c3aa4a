"""Writes a predictive control as C: its numbers for the blocks, and the code of OSQP and CVXPYgen for
`cargo xtask bench --only qp`: `python peers.py FOLDER`."""

import shutil
import sys
from pathlib import Path

import cvxpy
import cvxpygen.cpg
import numpy as np
import osqp
from scipy import linalg, sparse

STATES, INPUTS, HORIZON, STEPS = 12, 4, 10, 20
PERIOD, GRAVITY = 0.05, 9.81
# TinyMPC's weight, of which its last cost depends: all contenders have that cost.
WEIGHT = 80.0
# OSQP's settings: a step size that takes the fewest iterations of those tried, and a tolerance that gives 1e-6.
OSQP = {"eps_abs": 1e-9, "eps_rel": 1e-9, "max_iter": 20000, "rho": 100.0, "adaptive_rho": False}
MOST = np.array([1.0, 0.2, 0.2, 0.05])


def model():
    """Linear model of a quadcopter: position, attitude, velocity, rates; thrust and torques by mass and inertia."""
    a, b = np.zeros((STATES, STATES)), np.zeros((STATES, INPUTS))
    a[0:3, 6:9] = a[3:6, 9:12] = np.eye(3)
    a[6, 4], a[7, 3] = GRAVITY, -GRAVITY
    b[8, 0] = 5.0
    b[9:12, 1:4] = np.diag([40.0, 40.0, 25.0])
    whole = linalg.expm(PERIOD * np.block([[a, b], [np.zeros((INPUTS, STATES + INPUTS))]]))
    return whole[:STATES, :STATES], whole[:STATES, STATES:]


def condensed(a, b, q, r, p):
    """The program in the inputs alone: its second derivative, and the gradient for each state."""
    free = np.vstack([np.linalg.matrix_power(a, k + 1) for k in range(HORIZON)])
    forced = np.zeros((STATES * HORIZON, INPUTS * HORIZON))
    for row in range(HORIZON):
        for col in range(row + 1):
            power = np.linalg.matrix_power(a, row - col)
            forced[STATES * row : STATES * (row + 1), INPUTS * col : INPUTS * (col + 1)] = power @ b
    weight = linalg.block_diag(*[q] * (HORIZON - 1), p)
    hessian = forced.T @ weight @ forced + linalg.block_diag(*[r] * HORIZON)
    return (hessian + hessian.T) / 2, forced.T @ weight @ free


def table(name, numbers):
    """A table of C; matrices by columns."""
    flat = np.asarray(numbers, dtype=float).flatten(order="F")
    return f"static const double {name}[{len(flat)}] = {{{', '.join(float(x).hex() for x in flat)}}};\n"


def main(folder):
    a, b = model()
    q = np.diag([100.0] * 3 + [4.0] * 3 + [4.0] * 3 + [1.0] * 3)
    r = np.diag([4.0] * INPUTS)
    p = linalg.solve_discrete_are(a, b, q + WEIGHT * np.eye(STATES), r + WEIGHT * np.eye(INPUTS)) - WEIGHT * np.eye(STATES)
    hessian, gradient = condensed(a, b, q, r, p)
    most = np.tile(MOST, HORIZON)
    exact = osqp.OSQP()
    exact.setup(sparse.csc_matrix(hessian), np.zeros(len(most)), sparse.eye(len(most), format="csc"), -most, most,
                eps_abs=1e-11, eps_rel=1e-11, max_iter=200000, polishing=True, verbose=False)
    states, state = [], np.array([1.0, -0.8, 0.6, 0.1, -0.2, 0.3, 0.5, 0.0, -0.5, 0.0, 0.4, 0.2])
    for _ in range(STEPS):
        states.append(state)
        exact.update(q=gradient @ state)
        found = exact.solve().x
        state = a @ state + b @ found[:INPUTS]
    inverse = np.linalg.inv(np.linalg.cholesky(hessian)).T
    weights = np.full(len(most), 300.0)
    (folder / "problem.h").write_text(
        f"#define STEPS {STEPS}\n#define WEIGHT {WEIGHT}\n"
        + table("INVERSE", inverse) + table("GRADIENT", gradient) + table("MOST", most)
        + table("SPLIT", np.linalg.inv(hessian + np.diag(weights))) + table("WEIGHTS", weights)
        + table("STATES", np.array(states).T)
        + table("PLANT_A", a) + table("PLANT_B", b) + table("Q", np.diag(q)) + table("R", np.diag(r))
        + table("COST_TO_GO", p + WEIGHT * np.eye(STATES))
    )
    # The sparse form, which both tools take: states and inputs are unknown.
    size = HORIZON * (STATES + INPUTS)
    cost = sparse.block_diag([sparse.kron(sparse.eye(HORIZON - 1), q), p, sparse.kron(sparse.eye(HORIZON), r)], "csc")
    shift = sparse.kron(sparse.eye(HORIZON, k=-1), a) - sparse.eye(HORIZON * STATES)
    dynamics = sparse.hstack([shift, sparse.kron(sparse.eye(HORIZON), b)])
    limits = sparse.hstack([sparse.csc_matrix((len(most), HORIZON * STATES)), sparse.eye(len(most))])
    start = np.concatenate([-a @ states[0], np.zeros((HORIZON - 1) * STATES)])
    solver = osqp.OSQP()
    solver.setup(cost, np.zeros(size), sparse.vstack([dynamics, limits], "csc"), np.concatenate([start, -most]),
                 np.concatenate([start, most]), verbose=False, **OSQP)
    shutil.rmtree(folder / "osqp", ignore_errors=True)
    solver.codegen(str(folder / "osqp"), parameters="vectors", force_rewrite=True, prefix="")
    x, u = cvxpy.Variable((STATES, HORIZON + 1), name="x"), cvxpy.Variable((INPUTS, HORIZON), name="u")
    now = cvxpy.Parameter(STATES, name="now")
    square = lambda weight, it: cvxpy.sum_squares(np.linalg.cholesky(weight).T @ it)
    problem = cvxpy.Problem(
        cvxpy.Minimize(square(q, x[:, 1:HORIZON]) + square(p, x[:, HORIZON]) + square(r, u)),
        [x[:, 0] == now, x[:, 1:] == a @ x[:, :HORIZON] + b @ u, cvxpy.abs(u) <= np.tile(MOST[:, None], (1, HORIZON))],
    )
    cvxpygen.cpg.generate_code(problem, code_dir=str(folder / "cvxpygen"), solver="OSQP", wrapper=False,
                               solver_opts=OSQP)


main(Path(sys.argv[1]))
