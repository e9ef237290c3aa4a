#!/usr/bin/env bash
# pymavlink 2.4.50: the names of instances in a DataFlash log, such as `IMU[1]`, find nothing where messages are requested by name.
#
# Guessed: the reader lists the last messages by `IMU`, `IMU[0]` and `IMU[1]`, so each of these names can be passed to `recv_match`.
# Seen:    `recv_match(type="IMU[1]")` reads the whole log and returns nothing, while `messages["IMU[1]"]` then has the message; a condition
#          finds it.
# So:      filter by `recv_match(type="IMU", condition="IMU.I==1")`; an empty answer does not say that the log lacks the sensor.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/python"
"$folder/python/bin/pip" --quiet --disable-pip-version-check install pymavlink==2.4.50
"$folder/python/bin/python" - "$folder/flight.bin" <<'PYTHON' | tee "$folder/printed"
import struct, sys
from importlib.metadata import version
from pymavlink import mavutil


def written(kind, layout, *values):
    return b"\xa3\x95" + bytes([kind]) + struct.pack(layout, *values)


def described(kind, layout, name, letters, columns):
    length = 3 + struct.calcsize(layout)
    return written(128, "<BB4s16s64s", kind, length, name, letters, columns)


FMT, FMTU, UNIT, IMU = "<BB4s16s64s", "<QB16s16s", "<Qb64s", "<QBf"
log = described(128, FMT, b"FMT", b"BBnNZ", b"Type,Length,Name,Format,Columns")
log += described(129, FMTU, b"FMTU", b"QBNN", b"TimeUS,FmtType,UnitIds,MultIds")
log += described(130, UNIT, b"UNIT", b"QbZ", b"TimeUS,Id,Label")
log += described(140, IMU, b"IMU", b"QBf", b"TimeUS,I,GyrX")
log += written(130, UNIT, 0, ord("#"), b"instance") + written(129, FMTU, 0, 140, b"s#-", b"F--")
for time in range(3):
    for instance in range(2):
        log += written(140, IMU, 1000 * time, instance, 0.25 + instance)
with open(sys.argv[1], "wb") as file:
    file.write(log)

print(f"pymavlink {version('pymavlink')}")
reader = mavutil.mavlink_connection(sys.argv[1])
print("by name:", reader.recv_match(type="IMU[1]"))
print("in the table:", reader.messages["IMU[1]"].GyrX)
reader = mavutil.mavlink_connection(sys.argv[1])
print("by condition:", reader.recv_match(type="IMU", condition="IMU.I==1").GyrX)
PYTHON
grep -qx 'by name: None' "$folder/printed"
grep -qx 'in the table: 1.25' "$folder/printed"
grep -qx 'by condition: 1.25' "$folder/printed"
