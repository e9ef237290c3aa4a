//! Parts of estimators, written in the DSL: covariances, their prediction and correction, discrete models.
//!
//! An author's package depends on this crate beside `bessemer`; only called functions become C.
//!
//! * [`Symmetric`]: a covariance, symmetric to the last bit after each operation; [`Symmetric::congruence`] predicts it.
//! * [`Symmetric::correct`] and [`Symmetric::correct_jointly`]: corrections with a gate, which report a covariance that
//!   would not stay positive.
//! * [`Factored`]: the same covariance as U D Uᵀ, which cannot lose its sign.
//! * [`Diagonal`], [`Selection`]: structured matrices whose products skip the zeros.
//! * [`discretized`]: transition and process noise of a continuous model over a period.
//!
//! Invariant: a covariance that an operation refuses stays as it was.
//!
//! Must not know: the meaning of a state, and any sensor.

#![no_std]
#![allow(clippy::assign_op_pattern, clippy::needless_range_loop, clippy::neg_cmp_op_on_partial_ord)]

mod continuous;
mod correct;
mod factored;
mod structured;
mod symmetric;

pub use continuous::*;
pub use correct::*;
pub use factored::*;
pub use structured::*;
pub use symmetric::*;
