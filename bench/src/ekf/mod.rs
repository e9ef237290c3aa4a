//! Measures extended Kalman filters against code that SymForce and CasADi generate for the same models.
//!
//! One has twelve states and six measured numbers, the other is an autopilot's with twenty-four states.

pub mod page;

use crate::peers::Subject;

/// The filter, with its state, the lower triangle of its covariance, and six sines and cosines.
pub const FILTER: Subject = Subject {
    name: "ekf",
    source: "bench/ekf/filter.rs",
    packages: &[("symforce", "0.12.0"), ("casadi", "3.8.2")],
    contenders: &["emitted C", "SymForce", "CasADi"],
    parts: &["step"],
    angles: true,
    words: 12 + 78 + 6,
    tolerances: [1e-12, 1e-4],
};

/// The autopilot's filter, with its state and the lower triangle of its covariance.
pub const AUTOPILOT: Subject = Subject {
    name: "autopilot",
    source: "tests/corpus/src/programs/cookbook/autopilot.rs",
    packages: &[("symforce", "0.12.0")],
    contenders: &["emitted C", "SymForce"],
    parts: &["prediction", "velocity and position", "magnetic field"],
    angles: false,
    words: 24 + 300,
    tolerances: [1e-12, 1e-3],
};
