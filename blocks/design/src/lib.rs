//! Design of controllers and filters on the desktop. Its results are constants of a model.
//!
//! A build script designs, and writes the constants with [`constants`]; the model includes them. The C then has plain
//! tables, and no design runs on the target.
//!
//! ```
//! use bessemer_design::{constants::Constants, lqr, zero_order_hold};
//! use nalgebra::{Matrix1, Matrix2, Vector2};
//!
//! // A cart on a rail: position and speed, pushed by a force.
//! let (a, b) = (Matrix2::new(0.0, 1.0, 0.0, -0.5), Vector2::new(0.0, 2.0));
//! let (discrete, input) = zero_order_hold(&a, &b, 0.01);
//! let gain = lqr(&discrete, &input, &Matrix2::identity(), &Matrix1::new(0.1)).expect("it can be stabilised");
//! let text = Constants::new().matrix("GAIN", "Gain of the state, N/m and N·s/m", &gain).text();
//! assert!(text.contains("pub const GAIN: bessemer::nalgebra::SMatrix<f64, 1, 2>"));
//! ```
//!
//! It runs with the machine's own elementary functions: the last bits of a constant can depend on the machine that
//! designs it, so commit the constants, or the C made of them. It never becomes C itself.

pub mod constants;
pub mod filters;
pub mod models;
pub mod predictive;
pub mod regulators;
pub mod responses;

pub use filters::*;
pub use models::*;
pub use predictive::*;
pub use regulators::*;
pub use responses::*;
