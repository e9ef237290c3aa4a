#!/usr/bin/env bash
# OSQP 1.1.3: the same problem with its cost multiplied by 10⁻⁶ is "solved" far from its minimum.
#
# Guessed: a factor of the cost, such as another unit, does not change the minimum; OSQP scales the cost itself (`scaling`).
# Seen:    the minimum of ½|x|² + 5 x₁ - 3 x₂ is at (-5, 3). With both terms times 10⁻⁶ the status is "solved", after 25 iterations, at
#          (-0.002, 0.001): the dual residual is measured without the scaling, and 10⁻³ allows it to be the whole gradient.
# So:      scale the cost so that gradients are about 1, or set `eps_abs` to a thousandth of their size.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/python"
"$folder/python/bin/pip" --quiet --disable-pip-version-check install osqp==1.1.3 numpy==2.4.6 scipy==1.17.1
"$folder/python/bin/python" - <<'PYTHON' | tee "$folder/printed"
from importlib.metadata import version
import numpy as np
import osqp
from scipy import sparse

print(f"OSQP {version('osqp')}, numpy {np.__version__}, SciPy {version('scipy')}")


def solved(factor, **settings):
    solver = osqp.OSQP()
    cost = factor * sparse.identity(2, format="csc")
    limit = np.full(2, 10.0)
    slope = factor * np.array([5.0, -3.0])
    solver.setup(cost, slope, sparse.identity(2, format="csc"), -limit, limit, verbose=False, **settings)
    result = solver.solve()
    x, y = result.x
    return f"{result.info.status} at ({x:.3f}, {y:.3f})"


print("cost times 1:", solved(1.0))
print("cost times 1e-6:", solved(1e-6))
print("cost times 1e-6, eps_abs 1e-10:", solved(1e-6, eps_abs=1e-10, eps_rel=1e-10, max_iter=100000))
PYTHON
grep -q '^cost times 1: solved at (-[45]\.[0-9]*, [23]\.[0-9]*)$' "$folder/printed"
grep -qx 'cost times 1e-6: solved at (-0.002, 0.001)' "$folder/printed"
grep -q '^cost times 1e-6, eps_abs 1e-10: solved at (-5.000, 3.000)$' "$folder/printed"
