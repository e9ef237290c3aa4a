//! Parts of estimators, written in the DSL: covariances, their prediction and correction, discrete models.
//!
//! An author's package depends on this crate beside `bessemer`; only called functions become C.
//!
//! * [`Symmetric`]: a covariance, symmetric to the last bit after each operation; [`Symmetric::congruence`] predicts
//!   it.
//! * [`Symmetric::correct`], [`Symmetric::correct_selected`], [`Symmetric::correct_part`] and
//!   [`Symmetric::correct_jointly`]: corrections with a gate, which report a covariance that would not stay positive.
//! * [`Symmetric::correct_joseph`]: Joseph's form; [`Symmetric::correct_considering`]: a correction that leaves elements of
//!   the state as they are.
//! * [`Factored`], [`Rooted`]: the same covariance as U D Uᵀ or L Lᵀ, which cannot lose its sign.
//! * [`unscented`]: a distribution behind a function, without its derivative; [`Symmetric::correct_unscented`] and
//!   [`Rooted`] filter by it.
//! * [`smoothed`]: a recorded filter, corrected by what came after.
//! * [`Diagonal`], [`Selection`], [`UpperTriangular`]: structured matrices whose products skip the zeros;
//!   [`BlockSparse`]: a matrix of blocks, most of which are zero by its type.
//! * [`exponential`], [`discretized`]: transition and process noise of a continuous model over a period;
//!   [`runge_kutta`] and [`runge_kutta_jacobian`] step a nonlinear one.
//!
//! Invariant: a covariance that an operation refuses stays as it was.
//!
//! Must not know: the meaning of a state, and any sensor.

#![no_std]
#![allow(clippy::assign_op_pattern, clippy::needless_range_loop, clippy::neg_cmp_op_on_partial_ord)]

mod continuous;
mod correct;
mod factored;
mod joseph;
mod record;
mod rooted;
mod selected;
mod sparse;
mod structured;
mod symmetric;
mod transform;

pub use continuous::*;
pub use correct::*;
pub use factored::*;
pub use record::*;
pub use rooted::*;
pub use sparse::*;
pub use structured::*;
pub use symmetric::*;
pub use transform::*;
