"""Generates the step of the filter by SymForce and by CasADi, for `cargo xtask bench --only ekf`: `python peers.py FOLDER`."""

import re
import sys
from pathlib import Path

STATES = 12
MEASURED = 6
GRAVITY = 9.81
VARIANCES = [0.25] * 3 + [0.01] * 3
NOISES = [0.0] * 3 + [0.01] * 3 + [1e-5] * 3 + [1e-8] * 3


def advanced(state, rate, force, period, sin, cos):
    """Returns the state after one period; plain operations, so that both libraries take it."""
    sin_roll, cos_roll = sin(state[6]), cos(state[6])
    sin_pitch, cos_pitch = sin(state[7]), cos(state[7])
    sin_yaw, cos_yaw = sin(state[8]), cos(state[8])
    lift = sin_roll * force[1] + cos_roll * force[2]
    ahead = cos_pitch * force[0] + sin_pitch * lift
    right = cos_roll * force[1] - sin_roll * force[2]
    down = cos_pitch * lift - sin_pitch * force[0]
    acceleration = [
        cos_yaw * ahead - sin_yaw * right,
        sin_yaw * ahead + cos_yaw * right,
        down + GRAVITY,
    ]
    p, q, r = (rate[i] - state[9 + i] for i in range(3))
    turn = (sin_roll * q + cos_roll * r) / cos_pitch
    rates = [p + sin_pitch * turn, cos_roll * q - sin_roll * r, turn]
    following = [state[i] for i in range(STATES)]
    for i in range(3):
        following[i] = following[i] + period * state[i + 3]
        following[i + 3] = following[i + 3] + period * acceleration[i]
        following[i + 6] = following[i + 6] + period * rates[i]
    return following


def predicted(covariance, jacobian, period):
    """Returns the lower triangle of F P F^T + Q, by rows."""
    product = jacobian * covariance * jacobian.T
    rows = []
    for row in range(STATES):
        rows.append([product[row, col] for col in range(row + 1)])
        rows[row][row] = rows[row][row] + NOISES[row] * period
    return rows


def corrected(state, rows, index, innovation):
    """Returns the state and the lower triangle after a measurement of one element."""
    at = lambda row, col: rows[max(row, col)][min(row, col)]
    spread = [at(row, index) for row in range(STATES)]
    scale = 1 / (spread[index] + VARIANCES[index])
    gain = [scale * element for element in spread]
    state = [state[row] + gain[row] * innovation for row in range(STATES)]
    rows = [
        [rows[row][col] - gain[row] * spread[col] for col in range(row + 1)] for row in range(STATES)
    ]
    return state, rows


def packed(rows):
    return [element for row in rows for element in row]


def unpacked(elements):
    rows, first = [], 0
    for row in range(STATES):
        rows.append(list(elements[first : first + row + 1]))
        first += row + 1
    return rows


def square(rows):
    return [[rows[max(r, c)][min(r, c)] for c in range(STATES)] for r in range(STATES)]


def by_symforce(folder):
    import symforce

    symforce.set_epsilon_to_number(0.0)
    import symforce.symbolic as sf
    from symforce import codegen
    from symforce import typing as T

    half = STATES * (STATES + 1) // 2
    V12, V78 = type(sf.Matrix(STATES, 1)), type(sf.Matrix(half, 1))

    def step(
        state: V12, covariance: V78, rate: sf.V3, force: sf.V3, period: T.Scalar, measured: sf.V6
    ):
        following = advanced(list(state), list(rate), list(force), period, sf.sin, sf.cos)
        jacobian = sf.Matrix(following).jacobian(state)
        rows = predicted(sf.Matrix(square(unpacked(list(covariance)))), jacobian, period)
        for index in range(MEASURED):
            following, rows = corrected(following, rows, index, measured[index] - following[index])
        return sf.Matrix(following), sf.Matrix(packed(rows))

    generated = codegen.Codegen.function(
        func=step, config=codegen.CppConfig(), output_names=["following", "grown"]
    )
    generated.generate_function(output_dir=folder / "symforce", skip_directory_nesting=True)


def by_casadi(folder):
    import casadi as ca

    half = STATES * (STATES + 1) // 2
    state, elements = ca.SX.sym("x", STATES), ca.SX.sym("p", half)
    rate, force, period = ca.SX.sym("w", 3), ca.SX.sym("f", 3), ca.SX.sym("t")
    measured = ca.SX.sym("z", MEASURED)
    following = advanced(state, rate, force, period, ca.sin, ca.cos)
    jacobian = ca.jacobian(ca.vertcat(*following), state)
    full = square(unpacked([elements[i] for i in range(half)]))
    covariance = ca.vertcat(*[ca.horzcat(*row) for row in full])
    product = ca.mtimes([jacobian, covariance, jacobian.T])
    rows = [[product[r, c] for c in range(r + 1)] for r in range(STATES)]
    for row in range(STATES):
        rows[row][row] += NOISES[row] * period
    for index in range(MEASURED):
        following, rows = corrected(following, rows, index, measured[index] - following[index])
    step = ca.Function(
        "ekf_step",
        [state, elements, rate, force, period, measured],
        [ca.vertcat(*following), ca.vertcat(*packed(rows))],
        {"cse": True},
    )
    target = folder / "casadi"
    target.mkdir(parents=True, exist_ok=True)
    for real in ["double", "float"]:
        generator = ca.CodeGenerator(f"ekf_{real}.c", {"casadi_real": real, "casadi_int": "int"})
        generator.add(step)
        generator.generate(f"{target}/")
    # CasADi calls the functions of double precision for every type.
    single = target / "ekf_float.c"
    single.write_text(re.sub(r"\b(sin|cos)\(", r"\1f(", single.read_text()))


if __name__ == "__main__":
    by_casadi(Path(sys.argv[1]))
    by_symforce(Path(sys.argv[1]))
