//! Blocks for models: controllers, filters, limits, tables, trajectories, drives, attitude, coordinates and bytes.
//!
//! A block is a plain type of the DSL with its state, beside a plain type with its parameters. A model has the
//! block as a field, passes the parameters in each period, and gets both in its C:
//!
//! ```
//! use bessemer::prelude::*;
//! use bessemer_blocks::{Pid, PidParameters};
//!
//! /// Holds a speed.
//! #[component]
//! #[derive(Clone, Debug, Default, PartialEq)]
//! pub struct SpeedLoop {
//!     pid: Pid<f32>,
//! }
//!
//! #[component]
//! impl SpeedLoop {
//!     /// Advances one period; returns the voltage.
//!     #[entry(infallible)]
//!     pub fn step(&mut self, parameters: &PidParameters<f32>, target: f32, speed: f32) -> f32 {
//!         self.pid.step(parameters, target, speed)
//!     }
//! }
//!
//! let parameters = PidParameters { proportional: 2.0, low: -12.0, high: 12.0, period: 0.001, ..Default::default() };
//! assert_eq!(SpeedLoop::default().step(&parameters, 3.0, 1.0), 4.0);
//! ```
//!
//! Each block is generic over [`Real`](bessemer::prelude::Real), `f32` or `f64`. The initial state of each is its
//! `Default`, and no input is a fault unless the block says so. The generator emits only the blocks that a
//! model uses. The book has a page for each family, with its C and its cost (`docs/book/blocks/`).

#![no_std]
// A comparison with NaN is false, and its negation is meant.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

pub mod admm;
pub mod attitude;
pub mod bytes;
pub mod calculus;
pub mod drives;
pub mod filters;
pub mod frames;
pub mod kalman_attitude;
pub mod limits;
pub mod logic;
pub mod machine;
pub mod pid;
pub mod quadratic;
pub mod receding;
pub mod riccati;
pub mod spectrum;
pub mod tables;
pub mod trajectories;
pub mod windows;

pub use admm::*;
pub use attitude::*;
pub use bytes::*;
pub use calculus::*;
pub use drives::*;
pub use filters::*;
pub use frames::*;
pub use kalman_attitude::*;
pub use limits::*;
pub use logic::*;
pub use machine::*;
pub use pid::*;
pub use quadratic::*;
pub use receding::*;
pub use riccati::*;
pub use spectrum::*;
pub use tables::*;
pub use trajectories::*;
pub use windows::*;
