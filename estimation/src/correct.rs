//! Reports of corrections by measurements.

use bessemer::prelude::*;

/// Result of a correction.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Status {
    /// State and covariance are corrected.
    #[default]
    Corrected,
    /// The innovation exceeds the gate, or is not a number; nothing changed.
    Rejected,
    /// The covariance would not stay positive; nothing changed.
    Lost,
}

/// Report of a correction.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Correction<T: Real> {
    /// Normalised innovation squared, νᵀ S⁻¹ ν: on average the number of measurements, if the filter is consistent.
    pub surprise: T,
    /// Result of the correction.
    pub status: Status,
}
