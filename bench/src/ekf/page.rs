//! The pages of the results, `bench/results/ekf.md` and `autopilot.md`.

use serde_json::Value;

use super::{AUTOPILOT, FILTER};
use crate::peers;

/// Returns the page of a result file.
pub fn markdown(json: &Value) -> String {
    let mut text = String::from(
        "# An extended Kalman filter beside SymForce and CasADi\n\n\
         One step of a filter of twelve states (position, velocity, attitude, bias of the gyro) with six measured numbers: its prediction and its\n\
         correction, in executed instructions, by gcc `-O2` without contraction, counted under QEMU. Instructions are no cycles: there is no cache and no\n\
         pipeline. Code is in bytes, with constants, without elementary functions.\n\n\
         The emitted C comes from [bench/ekf/filter.rs](../ekf/filter.rs), written as a user writes it, without a derivative by its author. It also returns\n\
         the surprise of the measurement, applies a gate, and refuses a covariance that would not stay positive; the peers do not. The peers' code comes from\n\
         [bench/ekf/peers.py](../ekf/peers.py): the whole step as one function, half of the covariance, the six numbers one by one. States and covariances\n\
         after twenty steps are compared before the counts. `cargo xtask bench --only ekf` measures it again, and writes [ekf.json](ekf.json) and this page.\n",
    );
    peers::tables(&mut text, &FILTER, json, &PER_STEP);
    text
}

/// Rows of the tables.
const PER_STEP: [(&str, &str); 3] = [
    ("instructions", "instructions of a step"),
    ("sines and cosines", "of which its sines and cosines"),
    ("text", "code, bytes"),
];

/// Returns the page of a result file of the autopilot's filter.
pub fn of_autopilot(json: &Value) -> String {
    let mut text = String::from(
        "# An autopilot's filter of 24 states beside SymForce\n\n\
         A filter of attitude, velocity, position, biases, magnetic fields and wind: its prediction, its correction by velocity and position, and its\n\
         correction by the magnetic field, in executed instructions, by gcc `-O2` without contraction, counted under QEMU. Instructions are no\n\
         cycles: there is no cache and no pipeline. Code is in bytes, with constants.\n\n\
         The emitted C comes from [a recipe of the book](../../docs/book/cookbook/autopilot.md), written as a user writes it, without a derivative by its\n\
         author. It also returns the surprise of each measurement, applies a gate, and refuses a covariance that would not stay positive; SymForce's does\n\
         not. SymForce's code comes from [bench/autopilot/peers.py](../autopilot/peers.py): a function for each part, half of the covariance, measured\n\
         numbers one by one. States and covariances after twenty steps are compared before the counts. `cargo xtask bench --only autopilot` measures it\n\
         again, and writes [autopilot.json](autopilot.json) and this page.\n",
    );
    peers::tables(&mut text, &AUTOPILOT, json, &PER_PART);
    text
}

/// Rows of the autopilot's tables.
const PER_PART: [(&str, &str); 5] = [
    ("instructions", "instructions of a step"),
    ("prediction", "of which its prediction"),
    ("velocity and position", "of which velocity and position"),
    ("magnetic field", "of which the magnetic field"),
    ("text", "code, bytes"),
];
