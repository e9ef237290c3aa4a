#!/usr/bin/env bash
# CasADi 3.8.2: an interpolant by splines is 0 beyond its grid; one by lines is extended.
#
# Guessed: the two kinds of `interpolant` differ in smoothness only; beyond the last point both extend, or both hold.
# Seen:    over 0 … 4 with the squares as values, both are near 16 at 4. At 4.001 the lines have 16.007 and the spline 0, in the generated
#          C as well: a controller that looks up a table drops to 0 at the first value outside.
# So:      limit the argument to the grid (`fmin`, `fmax`) before an interpolant of the kind `bspline`.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv python
python/bin/pip --quiet --disable-pip-version-check install casadi==3.8.2 numpy==2.4.6
python/bin/python - <<'PYTHON' | tee printed
import subprocess
import casadi

print(f"CasADi {casadi.__version__}")
grid = [0.0, 1.0, 2.0, 3.0, 4.0]
for kind in ["linear", "bspline"]:
    table = casadi.interpolant("table", kind, [grid], [x * x for x in grid])
    at = casadi.MX.sym("at")
    function = casadi.Function("looked_up", [at], [table(at)])
    function.generate(f"{kind}.c")
    subprocess.run(["cc", "-shared", "-fPIC", f"{kind}.c", "-o", f"{kind}.so", "-lm"], check=True)
    compiled = casadi.external("looked_up", f"./{kind}.so")
    for name, each in [("Python", function), ("C", compiled)]:
        # `+ 0.0` because the sum of the spline's terms may be -0.
        print(f"{kind} in {name}:", *(f"{x}: {float(each(x)) + 0.0:.3f}" for x in [-0.001, 1.0, 4.0, 4.001]))
PYTHON
for name in Python C; do
    grep -qx "linear in $name: -0.001: -0.001 1.0: 1.000 4.0: 16.000 4.001: 16.007" printed
    grep -qx "bspline in $name: -0.001: 0.000 1.0: 1.000 4.0: 16.000 4.001: 0.000" printed
done
