#!/usr/bin/env bash
# SciPy 1.17.1: `dlsim` with times of `linspace` leaves out a sample for a third of the lengths, and spreads the others over the time.
#
# Guessed: an input for each of the four times 0, 0.1, 0.2, 0.3 gives an output for each, if the period is 0.1.
# Seen:    three outputs, at 0, 0.15 and 0.3: the number of samples is the last time divided by the period, rounded down, and
#          0.3 / 0.1 is just below 3 in doubles. The input is interpolated at the wrong times, and the system steps by its own period.
# So:      leave out `t`: then each sample of the input is one of the output, at any length.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/python"
"$folder/python/bin/pip" --quiet --disable-pip-version-check install numpy==2.4.6 scipy==1.17.1
"$folder/python/bin/python" - <<'PYTHON' | tee "$folder/printed"
from importlib.metadata import version
import numpy as np
from scipy import signal

print(f"SciPy {version('scipy')}, numpy {np.__version__}")
LAG = ([1.0], [1.0, -0.5])


def outputs(count, period, **times):
    return signal.dlsim((*LAG, period), np.ones(count), **times)


times, values = outputs(4, 0.1, t=np.linspace(0, 0.3, 4))
print("with t:", " ".join(f"{time:.2f}" for time in times))
print("without t:", " ".join(f"{time:.2f}" for time in outputs(4, 0.1)[0]))
shorter = sum(len(outputs(n, 0.1, t=np.linspace(0, (n - 1) / 10, n))[0]) < n for n in range(2, 1002))
same = all(len(outputs(n, 0.1)[0]) == n for n in range(2, 1002))
print(f"shorter than the input: {shorter} of 1000 lengths with t, {0 if same else 'some'} without")
PYTHON
grep -qx 'with t: 0.00 0.15 0.30' "$folder/printed"
grep -qx 'without t: 0.00 0.10 0.20 0.30' "$folder/printed"
grep -q '^shorter than the input: [1-9][0-9]* of 1000 lengths with t, 0 without$' "$folder/printed"
