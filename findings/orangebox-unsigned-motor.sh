#!/usr/bin/env bash
# orangebox 0.5.0: a motor below the minimum output is read as its value plus 2^32.
#
# Guessed: a reader of Betaflight's blackbox gives the motor values that the firmware had.
# Seen:    a disarmed motor has 1000 where the minimum output is 1055. Betaflight writes the difference, -55, as an unsigned number of
#          32 bits, as its simulator's logs show; the reader adds without wrapping, and gives 4294968296.
# So:      reduce motor values modulo 2^32 before comparing with another reader.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/python"
# pip cannot install its script `bb2csv`; the package itself is imported from the wheel.
"$folder/python/bin/pip" --quiet --disable-pip-version-check download --no-deps --dest "$folder" orangebox==0.5.0
PYTHONPATH=$(echo "$folder"/orangebox-*.whl) "$folder/python/bin/python" - "$folder/log.bbl" <<'PYTHON' | tee "$folder/printed"
import sys
from importlib.metadata import version
from orangebox import Parser

head = """H Product:Blackbox flight data recorder by Nicholas Sherlock
H Data version:2
H Field I name:loopIteration,time,motor[0]
H Field I signed:0,0,0
H Field I predictor:0,0,11
H Field I encoding:1,1,1
H Field P predictor:6,2,3
H Field P encoding:9,0,0
H I interval:1
H P interval:1
H motorOutput:1055,2000
"""


def unsigned(number):
    """Variable bytes, as the firmware's blackboxWriteUnsignedVB writes them."""
    written = bytearray()
    while number > 127:
        written.append(number & 0x7F | 0x80)
        number >>= 7
    return bytes(written) + bytes([number])


below = (1000 - 1055) % 2**32
frames = b"".join(b"I" + unsigned(n) + unsigned(1000 + n) + unsigned(below) for n in range(3))
with open(sys.argv[1], "wb") as file:
    file.write(head.encode() + frames + b"E\xffEnd of log\0")
motors = [frame.data[2] for frame in Parser.load(sys.argv[1]).frames()]
print(f"orangebox {version('orangebox')}")
print(f"motor of a frame that was written as 1000: {motors[0]}, which is 1000 modulo 2^32: {motors[0] % 2**32 == 1000}")
PYTHON
grep -q 'written as 1000: 4294968296, which is 1000 modulo 2^32: True' "$folder/printed"
