#!/usr/bin/env bash
# pymavlink 2.4.50: an integer parameter that is sent as the bits of a float, as PX4 does, arrives changed for some values.
#
# Guessed: MAVLink's encoding by bytes (MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE) brings each INT32 through PARAM_VALUE unchanged.
# Seen:    -5000000 is read as -805696: its bits, 0xFFB3B4C0, are those of a signalling NaN. pymavlink unpacks the field as a float of
#          Python, a double, and this conversion makes the NaN quiet. One integer of 512 is such: 0x7F800001 to 0x7FBFFFFF, and
#          the same with the sign. The bytes of the message are right.
# So:      read such parameters from the message's bytes, and do not pass `param_value` on as the bits of an integer.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/python"
"$folder/python/bin/pip" --quiet --disable-pip-version-check install pymavlink==2.4.50
"$folder/python/bin/python" - <<'PYTHON' | tee "$folder/printed"
import platform, struct
from importlib.metadata import version
from pymavlink.dialects.v20 import common

print(f"pymavlink {version('pymavlink')}, Python {platform.python_version()}")
HEADER = 10  # of MAVLink 2
for number in [5000000, -4194304, -5000000, 2139095041]:
    encoder = common.MAVLink(None, 1, 1)
    message = common.MAVLink_param_value_message(b"LON_0", 0.0, common.MAV_PARAM_TYPE_INT32, 1, 0)
    sent = bytearray(message.pack(encoder))
    # As firmware writes it: the bits of the integer, and the checksum over them.
    sent[HEADER : HEADER + 4] = struct.pack("<i", number)
    crc = common.x25crc(bytes(sent[1:-2]))
    crc.accumulate(struct.pack("B", message.crc_extra))
    sent[-2:] = struct.pack("<H", crc.crc)
    (read,) = common.MAVLink(None).parse_buffer(sent)
    (as_read,) = struct.unpack("<i", struct.pack("<f", read.param_value))
    (in_bytes,) = struct.unpack_from("<i", read.get_msgbuf(), HEADER)
    print(f"{number} is read as {as_read}, and {in_bytes} is in the bytes")
PYTHON
grep -qx '5000000 is read as 5000000, and 5000000 is in the bytes' "$folder/printed"
grep -qx -- '-4194304 is read as -4194304, and -4194304 is in the bytes' "$folder/printed"
grep -qx -- '-5000000 is read as -805696, and -5000000 is in the bytes' "$folder/printed"
grep -qx '2139095041 is read as 2143289345, and 2139095041 is in the bytes' "$folder/printed"
