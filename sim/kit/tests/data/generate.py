"""Writes solutions of differential equations beside this file, by SciPy.

pip install numpy==2.4.6 scipy==1.17.1 && python3 generate.py

A line is a name and its numbers. `sim/kit/tests/all/scipy.rs` reads the file, so that the tests need no Python.
"""

import pathlib

import numpy as np
from scipy.integrate import RK45, solve_ivp
from scipy.integrate._ivp.rk import rk_step

SYSTEMS = {
    "van_der_pol": (lambda t, y: [y[1], 5.0 * (1.0 - y[0] ** 2) * y[1] - y[0]], [2.0, 0.0], 20.0),
    "lorenz": (
        lambda t, y: [10.0 * (y[1] - y[0]), y[0] * (28.0 - y[2]) - y[1], y[0] * y[1] - 8.0 / 3.0 * y[2]],
        [1.0, 1.0, 1.0],
        5.0,
    ),
    "predators": (
        lambda t, y: [1.5 * y[0] - y[0] * y[1], y[0] * y[1] - 3.0 * y[1]],
        [10.0, 5.0],
        15.0,
    ),
    "driven": (lambda t, y: [y[1], t - t * t / 8.0 - 0.2 * y[1] - 4.0 * y[0]], [0.0, 1.0], 10.0),
}

lines = []


def write(name, numbers):
    numbers = np.asarray(numbers).flatten().tolist()
    lines.append(" ".join([name] + [repr(number) for number in numbers]))


for name, (system, start, end) in SYSTEMS.items():
    times = np.linspace(0.0, end, 17)[1:]
    options = {"t_eval": times, "rtol": 1e-13, "atol": 1e-13}
    explicit = solve_ivp(system, (0.0, end), start, method="DOP853", **options).y.T
    implicit = solve_ivp(system, (0.0, end), start, method="Radau", **options).y.T
    # The dense output of DOP853 has order 7, so it is of less use than the steps are.
    steps = [
        solve_ivp(system, (0.0, time), start, method="DOP853", rtol=1e-13, atol=1e-13).y[:, -1] for time in times
    ]
    scale = np.abs(steps).max()
    print(name, "DOP853 and Radau differ by", np.abs(steps - implicit).max() / scale, "of the largest state")
    print(name, "DOP853 and its dense output differ by", np.abs(steps - explicit).max() / scale)
    write(f"{name}_times", times)
    write(f"{name}_states", steps)

    # One step of Dormand and Prince of length 1/64, from the start.
    k = np.empty((RK45.n_stages + 1, len(start)))
    start = np.asarray(start)
    fun = lambda t, y: np.asarray(system(t, y))
    k[0] = fun(0.0, start)
    step, _ = rk_step(fun, 0.0, start, k[0], 1.0 / 64.0, RK45.A, RK45.B, RK45.C, k)
    write(f"{name}_step", step)


def level(t, y):
    return y[0]


level.direction = -1.0
system, start, end = SYSTEMS["driven"]
events = solve_ivp(system, (0.0, end), start, method="DOP853", rtol=1e-13, atol=1e-13, events=level).t_events[0]
write("driven_falls", events)

here = pathlib.Path(__file__).parent
(here / "scipy.txt").write_text("\n".join(lines) + "\n")
