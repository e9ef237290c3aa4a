#!/usr/bin/env bash
# Runs the drone's campaign by local clusters of Ray and Dask, whose workers and driver are killed (engines.py). Outside of CI: it
# installs both from PyPI into target/engines, 500 MB, and takes some minutes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."

python3 -m venv target/engines
target/engines/bin/pip install --quiet ray 'dask[distributed]' psutil
cargo run --quiet --package cargo-bessemer -- bessemer campaign --package sim --profile campaign --wheel target/engines
target/engines/bin/pip install --quiet --force-reinstall target/engines/sim_campaign-*.whl
RAY_AUTH_MODE=disabled target/engines/bin/python sim/campaign/tests/engines.py sim_campaign spread 0..4000 100
