"""Generates the autopilot's filter by SymForce, for `cargo xtask bench --only autopilot`: `python peers.py FOLDER`."""

import sys
from pathlib import Path

STATES = 24
GRAVITY = 9.80665
# Of attitude, velocity, position, bias of the rates, bias of the force, field, the body's field, wind.
SIZES = [4, 3, 3, 3, 3, 3, 3, 2]
NOISES = [1e-6, 0.01, 0.0, 1e-8, 1e-6, 1e-6, 1e-6, 0.01]
VARIANCES = [0.01] * 3 + [0.25] * 3
MAGNETIC = 0.0025


def rotation(w, x, y, z):
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]


def advanced(state, rate, force, period):
    """Returns the state after one period."""
    w, x, y, z = state[:4]
    half = [0.5 * period * (rate[i] - state[10 + i]) for i in range(3)]
    push = [period * (force[i] - state[13 + i]) for i in range(3)]
    following = list(state)
    following[0] = w - x * half[0] - y * half[1] - z * half[2]
    following[1] = x + w * half[0] + y * half[2] - z * half[1]
    following[2] = y + w * half[1] + z * half[0] - x * half[2]
    following[3] = z + w * half[2] + x * half[1] - y * half[0]
    turn = rotation(w, x, y, z)
    for i in range(3):
        following[4 + i] = state[4 + i] + sum(turn[i][k] * push[k] for k in range(3))
        following[7 + i] = state[7 + i] + period * state[4 + i]
    following[6] = following[6] + GRAVITY * period
    return following


def magnetic(state):
    """Returns the field that the body measures."""
    turn = rotation(*state[:4])
    return [sum(turn[k][i] * state[16 + k] for k in range(3)) + state[19 + i] for i in range(3)]


def corrected(state, rows, row, innovation, variance):
    """Returns the state and the lower triangle after a measurement whose Jacobian has the elements `row`."""
    at = lambda r, c: rows[max(r, c)][min(r, c)]
    spread = [sum(row[k] * at(r, k) for k in row) for r in range(STATES)]
    scale = 1 / (sum(row[k] * spread[k] for k in row) + variance)
    gain = [scale * element for element in spread]
    state = [state[r] + gain[r] * innovation for r in range(STATES)]
    rows = [[rows[r][c] - gain[r] * spread[c] for c in range(r + 1)] for r in range(STATES)]
    return state, rows


def unpacked(elements):
    rows, first = [], 0
    for row in range(STATES):
        rows.append(list(elements[first : first + row + 1]))
        first += row + 1
    return rows


def by_symforce(folder):
    import symforce

    symforce.set_epsilon_to_number(0.0)
    import symforce.symbolic as sf
    from symforce import codegen
    from symforce import typing as T

    half = STATES * (STATES + 1) // 2
    V24, V300 = type(sf.Matrix(STATES, 1)), type(sf.Matrix(half, 1))
    packed = lambda rows: sf.Matrix([element for row in rows for element in row])

    def predict(state: V24, covariance: V300, rate: sf.V3, force: sf.V3, period: T.Scalar):
        following = advanced(list(state), list(rate), list(force), period)
        jacobian = sf.Matrix(following).jacobian(state)
        rows = unpacked(list(covariance))
        full = [[rows[max(r, c)][min(r, c)] for c in range(STATES)] for r in range(STATES)]
        product = jacobian * sf.Matrix(full) * jacobian.T
        rows = [[product[r, c] for c in range(r + 1)] for r in range(STATES)]
        noises = [noise for noise, size in zip(NOISES, SIZES) for _ in range(size)]
        for row in range(STATES):
            rows[row][row] = rows[row][row] + noises[row] * period
        length = sf.sqrt(sum(element * element for element in following[:4]))
        following[:4] = [element / length for element in following[:4]]
        return sf.Matrix(following), packed(rows)

    def place(state: V24, covariance: V300, measured: sf.V6):
        now, rows = list(state), unpacked(list(covariance))
        for i, variance in enumerate(VARIANCES):
            now, rows = corrected(now, rows, {4 + i: 1}, measured[i] - now[4 + i], variance)
        return sf.Matrix(now), packed(rows)

    def compass(state: V24, covariance: V300, measured: sf.V3):
        before = list(state)
        now, rows, expected = before, unpacked(list(covariance)), magnetic(before)
        jacobian = sf.Matrix(expected).jacobian(state)
        for i in range(3):
            row = {k: jacobian[i, k] for k in range(STATES) if jacobian[i, k] != 0}
            moved = sum(row[k] * (now[k] - before[k]) for k in row)
            now, rows = corrected(now, rows, row, measured[i] - expected[i] - moved, MAGNETIC)
        return sf.Matrix(now), packed(rows)

    for function in (predict, place, compass):
        generated = codegen.Codegen.function(
            func=function, config=codegen.CppConfig(), output_names=["following", "grown"]
        )
        generated.generate_function(output_dir=folder / "symforce", skip_directory_nesting=True)


if __name__ == "__main__":
    by_symforce(Path(sys.argv[1]))
