"""Generates the gradient of the cost by CasADi, for `cargo xtask bench --only gradient`: `python peers.py FOLDER`."""

import re
import sys
from pathlib import Path

import casadi as ca

PERIODS = 50


def advanced(state, thrust, turn, period):
    """Returns the state after one period."""
    sin, cos = ca.sin(state[4]), ca.cos(state[4])
    drag = 0.1 * ca.sqrt(state[2] * state[2] + state[3] * state[3] + 1.0)
    ahead = thrust * sin - drag * state[2]
    up = thrust * cos - drag * state[3] - 9.81
    rates = [state[2], state[3], ahead, up, turn]
    return [state[i] + rates[i] * period for i in range(5)]


def main(folder):
    start, inputs, period = ca.SX.sym("x", 5), ca.SX.sym("u", 2, PERIODS), ca.SX.sym("t")
    state, total = [start[i] for i in range(5)], 0
    for k in range(PERIODS):
        thrust, turn = inputs[0, k], inputs[1, k]
        state = advanced(state, thrust, turn, period)
        ahead, up = state[0] - 5.0, state[1] - 2.0
        total += ahead * ahead + up * up + 0.01 * (thrust - 9.81) * (thrust - 9.81)
        total += 0.1 * (turn * turn + state[2] * state[2] + state[3] * state[3])
    step = ca.Function(
        "gradient_step", [start, inputs, period], [total, ca.gradient(total, inputs)], {"cse": True}
    )
    target = folder / "casadi"
    target.mkdir(parents=True, exist_ok=True)
    for real in ["double", "float"]:
        name = f"gradient_{real}.c"
        generator = ca.CodeGenerator(name, {"casadi_real": real, "casadi_int": "int"})
        generator.add(step)
        generator.generate(f"{target}/")
    # CasADi calls the functions of double precision for every type.
    single = target / "gradient_float.c"
    single.write_text(re.sub(r"\b(sin|cos|sqrt)\(", r"\1f(", single.read_text()))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
