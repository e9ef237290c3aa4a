#!/usr/bin/env bash
# FMPy 0.3.32: `write_csv` writes scalars exactly and elements of arrays rounded to 16 digits.
#
# Guessed: a result that is written to CSV and read again has the same doubles, in each column.
# Seen:    a scalar column does; of 1,000 doubles in an array column, about a fifth come back changed in the last bit.
# So:      compare arrays of a co-simulation in memory, not by FMPy's CSV file.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/python"
"$folder/python/bin/pip" --quiet --disable-pip-version-check install fmpy==0.3.32 numpy==2.3.4
"$folder/python/bin/python" - "$folder/result.csv" <<'PYTHON' | tee "$folder/printed"
import csv, random, sys
import numpy as np
import fmpy
from fmpy.util import write_csv

random.seed(1)
numbers = [random.random() for _ in range(1000)]
rows = np.array(
    [(float(step), number, (number, 0.0)) for step, number in enumerate(numbers)],
    dtype=[("time", np.float64), ("scalar", np.float64), ("array", np.float64, (2,))],
)
write_csv(sys.argv[1], rows)
with open(sys.argv[1]) as file:
    read = list(csv.DictReader(file))
scalars = sum(float(row["scalar"].removeprefix("np.float64(").rstrip(")")) != number for row, number in zip(read, numbers))
arrays = sum(float(row["array"].split()[0]) != number for row, number in zip(read, numbers))
print(f"FMPy {fmpy.__version__}, numpy {np.__version__}")
print(f"changed by writing and reading: {scalars} of 1000 scalars, {arrays} of 1000 elements of arrays")
PYTHON
grep -q 'changed by writing and reading: 0 of 1000 scalars, [1-9][0-9]* of 1000 elements' "$folder/printed"
