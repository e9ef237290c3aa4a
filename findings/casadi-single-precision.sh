#!/usr/bin/env bash
# CasADi 3.8.2: C that is generated with `casadi_real: float` computes sines, roots and maxima in double precision.
#
# Guessed: `CodeGenerator(…, {"casadi_real": "float"})` writes C in single precision, for processors that have no other.
# Seen:    variables and constants are `float`, but the C calls `sin`, `atan2`, `sqrt` and `fmax` of `double`: on a processor whose doubles are
#          software each call is a conversion there, a function in software, and one back.
# So:      name the functions of `float` before the generated file (`#define sin sinf`), and look for those of `double` in the object file.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv python
python/bin/pip --quiet --disable-pip-version-check install casadi==3.8.2 numpy==2.4.6
python/bin/python - <<'PYTHON' | tee printed
import casadi

print(f"CasADi {casadi.__version__}")
x, y = casadi.SX.sym("x"), casadi.SX.sym("y")
value = 0.1 * casadi.sin(x) + casadi.atan2(y, x) + casadi.fmax(x, y) + casadi.sqrt(y)
generator = casadi.CodeGenerator("single.c", {"casadi_real": "float", "casadi_int": "int"})
generator.add(casadi.Function("mixed", [x, y], [value]))
generator.generate("./")
PYTHON
grep "define casadi_real" single.c | tee -a printed
cc -std=c99 -O2 -fno-builtin -c single.c
nm --undefined-only single.o | awk '{ print $2 }' | grep -vE '^_GLOBAL' | sort | tee -a printed
grep -qx "#define casadi_real float" printed
for function in sin atan2 sqrt fmax; do
    grep -qx "$function" printed
    if grep -qx "${function}f" printed; then exit 1; fi
done
