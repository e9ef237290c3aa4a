#!/usr/bin/env bash
# pyquaternion 0.9.9: rates that are documented as global are the body's, and yaw, pitch and roll are not those of the named order.
#
# Guessed: by its documentation, `integrate` takes rates about the global axes, and `yaw_pitch_roll` is the order z-y'-x'' (yaw first).
# Seen:    after 90° about x, 90° at a rate about z leave the body's x axis on the global z; a rate about the global z would leave it on y.
#          Of 30° about z, then 20° about the new y, then 10° about the new x, it has 28.5°, 22.2° and -1.1°: those of the order x-y'-z''.
# So:      pass rates of a gyroscope as they are, and compute Euler angles by SciPy: `Rotation.from_matrix(…).as_euler("ZYX")`.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/python"
"$folder/python/bin/pip" --quiet --disable-pip-version-check install pyquaternion==0.9.9 numpy==2.4.6 scipy==1.17.1
"$folder/python/bin/python" - <<'PYTHON' | tee "$folder/printed"
from importlib.metadata import version
import numpy as np
from pyquaternion import Quaternion
from scipy.spatial.transform import Rotation

print(f"pyquaternion {version('pyquaternion')}, numpy {np.__version__}, SciPy {version('scipy')}")
print("integrate documents global rates:", "global" in Quaternion.integrate.__doc__)
rolled = Quaternion(axis=[1, 0, 0], degrees=90)
rolled.integrate([0, 0, np.pi / 2], 1.0)
print("x axis after integrate:", "xyz"[int(np.argmax(rolled.rotate(np.array([1.0, 0.0, 0.0]))))])
in_global = Quaternion(axis=[0, 0, 1], degrees=90) * Quaternion(axis=[1, 0, 0], degrees=90)
print("x axis after a rotation about the global z:", "xyz"[int(np.argmax(in_global.rotate(np.array([1.0, 0.0, 0.0]))))])
print("yaw_pitch_roll documents z-y'-x'':", "z-y'-x''" in Quaternion.yaw_pitch_roll.__doc__)
attitude = Quaternion(axis=[0, 0, 1], degrees=30) * Quaternion(axis=[0, 1, 0], degrees=20) * Quaternion(axis=[1, 0, 0], degrees=10)
rotation = Rotation.from_matrix(attitude.rotation_matrix)


def shown(angles):
    return " ".join(f"{angle:.1f}" for angle in angles)


print("yaw_pitch_roll:", shown(np.degrees(attitude.yaw_pitch_roll)))
print("SciPy, ZYX:", shown(rotation.as_euler("ZYX", degrees=True)))
print("SciPy, XYZ, backwards:", shown(rotation.as_euler("XYZ", degrees=True)[::-1]))
PYTHON
grep -qx 'integrate documents global rates: True' "$folder/printed"
grep -qx 'x axis after integrate: z' "$folder/printed"
grep -qx 'x axis after a rotation about the global z: y' "$folder/printed"
grep -qx "yaw_pitch_roll documents z-y'-x'': True" "$folder/printed"
grep -qx 'yaw_pitch_roll: 28.5 22.2 -1.1' "$folder/printed"
grep -qx 'SciPy, ZYX: 30.0 20.0 10.0' "$folder/printed"
grep -qx 'SciPy, XYZ, backwards: 28.5 22.2 -1.1' "$folder/printed"
