#!/usr/bin/env bash
# AHRS 0.4.0: the filters of Madgwick and Mahony, and AQUA, ignore the accelerometer while the gyroscope reads exactly zero.
#
# Guessed: at rest the accelerometer corrects the attitude, the more so the less the gyroscope has to say.
# Seen:    20 s at a roll of 0.5 rad: with rates of zero the estimate stays level; with rates of 10⁻¹² rad/s it is 0.5. The update returns
#          the old attitude if the norm of the rates is zero. The Kalman filter (`EKF`) of the package corrects with both.
# So:      a simulation without noise, and a gyroscope whose resolution hides slow motion, need a tiny rate to be tested with it.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/python"
"$folder/python/bin/pip" --quiet --disable-pip-version-check install AHRS==0.4.0 numpy==2.4.6
"$folder/python/bin/python" - <<'PYTHON' | tee "$folder/printed"
from importlib.metadata import version
import numpy as np
from ahrs import filters

print(f"AHRS {version('AHRS')}, numpy {np.__version__}")
roll = 0.5
force = 9.81 * np.array([0.0, np.sin(roll), np.cos(roll)])


def estimated(kind, rate):
    estimator = kind(frequency=100.0)
    step = estimator.update if kind is filters.EKF else estimator.updateIMU
    attitude = np.array([1.0, 0.0, 0.0, 0.0])
    for _ in range(2000):
        attitude = np.asarray(step(attitude, np.full(3, rate), force))
    # AQUA's quaternion is that of the opposite rotation.
    return abs(2 * np.arctan2(attitude[1], attitude[0]))


for kind in [filters.Madgwick, filters.Mahony, filters.AQUA, filters.EKF]:
    print(f"{kind.__name__}: {estimated(kind, 0.0):.2f} with rates of 0, {estimated(kind, 1e-12):.2f} with rates of 1e-12")
PYTHON
for kind in Madgwick Mahony AQUA; do
    grep -qx "$kind: 0.00 with rates of 0, 0.50 with rates of 1e-12" "$folder/printed"
done
grep -qx 'EKF: 0.50 with rates of 0, 0.50 with rates of 1e-12' "$folder/printed"
