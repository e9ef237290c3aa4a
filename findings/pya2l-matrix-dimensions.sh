#!/usr/bin/env bash
# pya2l 0.4.0: an array of one or two dimensions in a file of ASAP2 1.71 is a syntax error; three dimensions are read.
#
# Guessed: `MATRIX_DIM 3 4` is read, since ASAP2 has a list of dimensions there from version 1.70 on, and the file says 1.71.
# Seen:    one, two and four numbers are a syntax error, and no part of the file is read; `MATRIX_DIM 3 4 1`, the form of 1.60, is
#          accepted. pya2ldb 1.0.355, another reader with the same module name, reads them all.
# So:      write three dimensions, the last ones 1: this is valid in both versions.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in pya2l==0.4.0 pya2ldb==1.0.355; do
    python3 -m venv "${package%%=*}"
    "${package%%=*}/bin/pip" --quiet --disable-pip-version-check install "$package"
done
cat > read.py <<'PYTHON'
import sys
from pya2l import import_a2l, model

session = import_a2l(sys.argv[1], in_memory=True, encoding="utf-8", loglevel="ERROR", progress_bar=False)
print(*session.query(model.Measurement).one().matrix_dim.numbers)
PYTHON
{
    pya2l/bin/pip list --disable-pip-version-check 2> /dev/null | grep -E '^pya2l '
    pya2ldb/bin/pip list --disable-pip-version-check 2> /dev/null | grep -E '^pya2ldb '
    for dimensions in 3 '3 4' '3 4 1' '3 4 1 2'; do
        cat > array.a2l <<A2L
ASAP2_VERSION 1 71
/begin PROJECT motor ""
  /begin MODULE motor ""
    /begin COMPU_METHOD NONE "" IDENTICAL "%.17" "" /end COMPU_METHOD
    /begin MEASUREMENT gains "" FLOAT64_IEEE NONE 0 0 0 5 ECU_ADDRESS 0x20000000 MATRIX_DIM $dimensions /end MEASUREMENT
  /end MODULE
/end PROJECT
A2L
        first=read
        pya2l/bin/pya2l array.a2l to_json -o array.json > errors 2>&1 && [ -s array.json ] || first=$(grep -o 'no viable alternative' errors)
        echo "MATRIX_DIM $dimensions: $first; $(pya2ldb/bin/python read.py array.a2l 2> /dev/null | tail -n 1)"
    done
} | tee printed
grep -qx 'MATRIX_DIM 3: no viable alternative; 3' printed
grep -qx 'MATRIX_DIM 3 4: no viable alternative; 3 4' printed
grep -qx 'MATRIX_DIM 3 4 1: read; 3 4 1' printed
grep -qx 'MATRIX_DIM 3 4 1 2: no viable alternative; 3 4 1 2' printed
