//! Measures an extended Kalman filter of twelve states and six measured numbers against code that SymForce and CasADi
//! generate for the same model.

pub mod page;

use crate::peers::Subject;

/// The filter, with its state, the lower triangle of its covariance, and six sines and cosines.
pub const FILTER: Subject = Subject {
    name: "ekf",
    source: "filter.rs",
    packages: &[("symforce", "0.12.0"), ("casadi", "3.8.2")],
    contenders: &["emitted C", "SymForce", "CasADi"],
    words: 12 + 78 + 6,
    tolerances: [1e-12, 1e-4],
};
