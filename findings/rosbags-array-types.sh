#!/usr/bin/env bash
# rosbags 0.11.9: an array of int32 in a message whose field is float32 is written without an error, bit by bit.
#
# Guessed: an array of another type of numpy is converted, as a single number is, or refused, as an array of float64 is.
# Seen:    1 and 2 as int32 are read again as 1.4e-45 and 2.8e-45. Of arrays only the size of an element is checked, so float32 in the
#          other order of bytes is written wrongly as well; float64 raises `ValueError`.
# So:      convert with `np.asarray(…, dtype=np.float32)` before filling a message.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/python"
"$folder/python/bin/pip" --quiet --disable-pip-version-check install rosbags==0.11.9 numpy==2.4.6
"$folder/python/bin/python" - <<'PYTHON' | tee "$folder/printed"
from importlib.metadata import version
import numpy as np
from rosbags.typesys import Stores, get_typestore

print(f"rosbags {version('rosbags')}, numpy {np.__version__}")
store = get_typestore(Stores.ROS2_HUMBLE)
ARRAY, LAYOUT, NUMBER = "std_msgs/msg/Float32MultiArray", "std_msgs/msg/MultiArrayLayout", "std_msgs/msg/Float32"


def carried(message, name):
    return store.deserialize_cdr(store.serialize_cdr(message, name), name).data


for kind in ["<f4", "<i4", ">f4", "<f8"]:
    layout = store.types[LAYOUT](dim=[], data_offset=0)
    message = store.types[ARRAY](layout=layout, data=np.array([1, 2], dtype=kind))
    try:
        print(f"array of {kind}:", carried(message, ARRAY).tolist())
    except ValueError:
        print(f"array of {kind}: ValueError")
print("a number of <i4:", carried(store.types[NUMBER](data=np.int32(1)), NUMBER))
PYTHON
grep -qx 'array of <f4: \[1.0, 2.0\]' "$folder/printed"
grep -qx 'array of <i4: \[1.40[0-9]*e-45, 2.80[0-9]*e-45\]' "$folder/printed"
grep -qx 'array of >f4: \[4.60[0-9]*e-41, 8.96[0-9]*e-44\]' "$folder/printed"
grep -qx 'array of <f8: ValueError' "$folder/printed"
grep -qx 'a number of <i4: 1.0' "$folder/printed"
