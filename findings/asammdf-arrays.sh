#!/usr/bin/env bash
# asammdf 8.8.28: a signal whose samples are a matrix of numpy is read back as its first numbers, one for each row.
#
# Guessed: four samples of two numbers, an array of the shape (4, 2), are written as an array channel, or refused.
# Seen:    appended, saved and opened again, 0 … 7 has become 0, 1, 2, 3, which is neither a column (0, 2, 4, 6) nor a row.
#          Nothing warns. The same numbers in a record with a field of two numbers come back right.
# So:      pass arrays as records (`np.rec.fromarrays` with a type such as `(2,)<f8`), or one signal for each element.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv python
python/bin/pip --quiet --disable-pip-version-check install asammdf==8.8.28 numpy==2.4.6
python/bin/python - <<'PYTHON' | tee printed
from importlib.metadata import version
import numpy as np
from asammdf import MDF, Signal

print(f"asammdf {version('asammdf')}, numpy {np.__version__}")
currents = np.arange(8.0).reshape(4, 2)
record = np.rec.fromarrays([currents], dtype=np.dtype([("current", "(2,)<f8")]))


def read_again(samples):
    measured = MDF()
    measured.append([Signal(samples, np.arange(4) * 0.1, name="current")])
    measured.save("measured.mf4", overwrite=True)
    read = MDF("measured.mf4").get("current").samples
    return read["current"] if read.dtype.names else read


print("written:", currents.tolist())
print("as a matrix:", read_again(currents).tolist())
print("as a record:", read_again(record).tolist())
PYTHON
grep -qx 'written: \[\[0.0, 1.0\], \[2.0, 3.0\], \[4.0, 5.0\], \[6.0, 7.0\]\]' printed
grep -qx 'as a matrix: \[0.0, 1.0, 2.0, 3.0\]' printed
grep -qx 'as a record: \[\[0.0, 1.0\], \[2.0, 3.0\], \[4.0, 5.0\], \[6.0, 7.0\]\]' printed
