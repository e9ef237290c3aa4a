#!/usr/bin/env bash
# filterpy 2.0.0: a second `update` of the unscented Kalman filter in one step uses the sigma points of before the first.
#
# Guessed: as of the linear filter, each `update` takes in one more measurement: two sensors of a step are two calls.
# Seen:    the points are drawn in `predict` only. For a constant of variance 1, measured twice as 1 with variance 0.01, the linear filter
#          has 0.995 with variance 0.005; the unscented one, whose model is linear as well, has 1.980 with a variance of -0.980.
# So:      stack the measurements of a step into one update, or draw `sigmas_f` again from the state before the second.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/python"
"$folder/python/bin/pip" --quiet --disable-pip-version-check install filterpy==2.0.0 numpy==2.4.6 scipy==1.17.1
"$folder/python/bin/python" - <<'PYTHON' | tee "$folder/printed"
from importlib.metadata import version
import numpy as np
from filterpy.kalman import KalmanFilter, MerweScaledSigmaPoints, UnscentedKalmanFilter

print(f"filterpy {version('filterpy')}, numpy {np.__version__}")


def same(state, *_):
    return state


def begin(estimator):
    estimator.x, estimator.P = np.zeros(1), np.eye(1)
    estimator.Q, estimator.R = np.zeros((1, 1)), np.array([[0.01]])
    return estimator


points = MerweScaledSigmaPoints(1, alpha=0.1, beta=2.0, kappa=2.0)
linear = begin(KalmanFilter(dim_x=1, dim_z=1))
linear.F = linear.H = np.eye(1)
unscented = begin(UnscentedKalmanFilter(1, 1, 1.0, hx=same, fx=same, points=points))
again = begin(UnscentedKalmanFilter(1, 1, 1.0, hx=same, fx=same, points=points))
for estimator in [linear, unscented, again]:
    estimator.predict()
    estimator.update(np.array([1.0]))
again.sigmas_f = points.sigma_points(again.x, again.P)
for name, estimator in [("linear", linear), ("unscented", unscented), ("unscented, drawn again", again)]:
    estimator.update(np.array([1.0]))
    print(f"{name}: {estimator.x.item():.3f}, variance {estimator.P.item():.3f}")
PYTHON
grep -qx 'linear: 0.995, variance 0.005' "$folder/printed"
grep -qx 'unscented: 1.980, variance -0.980' "$folder/printed"
grep -qx 'unscented, drawn again: 0.995, variance 0.005' "$folder/printed"
