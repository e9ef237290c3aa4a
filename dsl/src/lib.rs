//! What the author of a model imports: the attributes, the prelude and the elementary functions.
//!
//! A model is ordinary Rust over scalars, arrays, nalgebra's fixed matrices and its own plain data.
//! The attributes leave it as written, save that scalar methods (`x.sin()`, `x.min(y)`) go to
//! [`math`], which computes the same bits on every target.
//!
//! ```
//! use bessemer::prelude::*;
//!
//! /// A first-order low-pass filter.
//! #[component]
//! #[derive(Clone, Debug, Default, PartialEq)]
//! pub struct LowPass {
//!     /// The filtered signal.
//!     level: f64,
//! }
//!
//! #[component]
//! impl LowPass {
//!     /// One period: moves the level by `share` (0 to 1) of the way to `signal`.
//!     #[entry(infallible)]
//!     pub fn step(&mut self, share: f64, signal: f64) -> f64 {
//!         self.level += share * (signal - self.level);
//!         self.level
//!     }
//! }
//!
//! let mut filter = LowPass::default();
//! assert_eq!(filter.step(0.5, 8.0), 4.0);
//! assert_eq!(filter.step(0.5, 8.0), 6.0);
//! ```
//!
//! `no_std` all the way down: a model never sees the platform's mathematics.

#![no_std]

#[cfg(feature = "generate")]
extern crate alloc;
extern crate self as bessemer;

pub use bessemer_macros::{c, component, data, entry, external, function, interface};
pub use bounded::BoundedMatrix;
pub use element::{Element, Number};
pub use instance::EntriesInOneBlock;
pub use linear::{inverse, inverse_mut, solve, solve_into, solve_mut};
pub use list::List;
pub use nalgebra;
pub use plain::Plain;
pub use text::Text;

mod bounded;
#[doc(hidden)]
pub mod comparison;
mod element;
#[cfg(feature = "generate")]
#[doc(hidden)]
pub mod generate;
mod instance;
pub mod linear;
mod list;
#[doc(hidden)]
pub mod list_edit;
pub mod math;
mod plain;
pub mod rotation;
pub mod search;
#[doc(hidden)]
pub mod slice_edit;
pub mod sort;
mod spatial;
mod text;

/// What a model imports with one line: `use bessemer::prelude::*;`.
pub mod prelude {
    pub use crate::math::{Real, real};
    pub use crate::{
        BoundedMatrix, List, Text, c, component, data, entry, external, function, interface,
        matrix, vector,
    };
    pub use nalgebra::{
        Isometry3, Matrix2, Matrix3, Matrix4, Matrix6, Point2, Point3, Quaternion, Rotation2,
        Rotation3, SMatrix, SVector, Translation2, Translation3, Unit, UnitQuaternion, UnitVector3,
        Vector2, Vector3, Vector4, Vector5, Vector6,
    };
}

/// What the library's own containers claim of an index: a fault of its own name in the C.
#[doc(hidden)]
#[macro_export]
macro_rules! __inside {
    ($condition:expr) => {
        ::core::assert!($condition, "index out of bounds")
    };
}

/// What they claim of their room.
#[doc(hidden)]
#[macro_export]
macro_rules! __room {
    ($condition:expr) => {
        ::core::assert!($condition, "the container is full")
    };
}

/// The whole of a package's `src/bin/tree.rs`: prints the tree that the generator reads.
///
/// ```ignore
/// bessemer::print_tree!(models);
/// ```
#[cfg(feature = "generate")]
#[macro_export]
macro_rules! print_tree {
    ($models:ident) => {
        extern crate $models as _;

        fn main() {
            let (name, license) = (env!("CARGO_PKG_NAME"), env!("CARGO_PKG_LICENSE"));
            // Whose tree it is: where workspaces share a target folder, cargo may mix packages of one name.
            println!("{}", $crate::generate::folders());
            // Initial values of large components pass through the stack.
            let tree = ::std::thread::Builder::new()
                .stack_size(1 << 28)
                .spawn(move || println!("{}", $crate::generate::package(name, license)));
            if tree.map_or(true, |tree| tree.join().is_err()) {
                ::std::process::exit(1);
            }
        }
    };
}
