//! The author of a model imports this crate: the attributes, the prelude and the elementary functions.
//!
//! A model is ordinary Rust over scalars, arrays, nalgebra's fixed matrices and its own plain data.
//! The attributes leave it as written, save that scalar methods (`x.sin()`, `x.min(y)`) go to
//! [`math`], which computes the same bits on every target.
//!
//! **Where to go on.** The book, `docs/book/README.md` of the repository, goes from nothing to firmware
//! (`tutorial.md`), has recipes (`cookbook/`) and a reference of types, statements, methods, faults and
//! messages (`reference/`). Here each attribute has a page with an example that runs:
//!
//! | mark | a |
//! |---|---|
//! | [`#[component]`](macro@component) | state with its methods; [`#[entry]`](macro@entry) those that firmware calls |
//! | [`#[data]`](macro@data) | struct or enum of plain data, its methods, a table |
//! | [`#[function]`](macro@function) | free function |
//! | [`#[interface]`](macro@interface) | trait that several components implement |
//! | [`#[external]`](macro@external) | function that firmware brings |
//! | [`#[c]`](macro@c) | name or a section in the C |
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

#[cfg(any(feature = "generate", feature = "names"))]
extern crate alloc;
extern crate self as bessemer;

#[cfg(not(feature = "generate"))]
#[doc(hidden)]
pub use bessemer_macros::library;
#[doc(hidden)]
pub use bessemer_macros::{__Configured, __removed};
#[cfg(not(feature = "generate"))]
#[doc(inline)]
pub use bessemer_macros::{State, component, data, external, function, interface};
#[cfg(feature = "generate")]
pub use bessemer_macros::{
    StateInGeneration as State, component_in_generation as component, data_in_generation as data,
    external_in_generation as external, function_in_generation as function,
    interface_in_generation as interface, library_in_generation as library,
};
#[doc(inline)]
pub use bessemer_macros::{c, entry, requirement};
pub use bounded::BoundedMatrix;
pub use element::{Element, Number};
pub use linear::{inverse, inverse_mut, solve, solve_into, solve_mut};
pub use list::List;
pub use nalgebra;
pub use plain::Plain;
pub use text::Text;

#[doc(hidden)]
pub mod adapt;
mod bounded;
mod bounded_arithmetic;
#[doc(hidden)]
pub mod comparison;
pub mod complex;
#[doc(hidden)]
pub mod cut;
mod element;
#[doc(hidden)]
pub mod exchange;
pub mod fast;
#[cfg(feature = "generate")]
#[doc(hidden)]
pub mod generate;
#[doc(hidden)]
pub mod iterate;
pub mod linear;
mod list;
#[doc(hidden)]
pub mod list_edit;
pub mod math;
#[doc(hidden)]
pub mod name;
pub mod non_zero;
#[doc(hidden)]
pub mod optional;
#[doc(hidden)]
pub mod outcome;
mod plain;
pub mod range;
pub mod rotation;
pub mod search;
#[doc(hidden)]
pub mod slice_edit;
pub mod sort;
mod spatial;
mod text;
pub mod wide;
pub mod wrapping;

/// A model imports all of this with one line: `use bessemer::prelude::*;`.
pub mod prelude {
    #[cfg(feature = "generate")]
    #[doc(hidden)]
    pub use crate::generate::mem::drop;
    pub use crate::math::{Integer, Real, real};
    pub use crate::{
        BoundedMatrix, List, State, Text, c, component, data, entry, external, function, interface,
        matrix, requirement, vector,
    };
    pub use nalgebra::{
        Isometry3, Matrix1, Matrix1x2, Matrix1x3, Matrix1x4, Matrix1x5, Matrix1x6, Matrix2,
        Matrix2x1, Matrix2x3, Matrix2x4, Matrix2x5, Matrix2x6, Matrix3, Matrix3x1, Matrix3x2,
        Matrix3x4, Matrix3x5, Matrix3x6, Matrix4, Matrix4x1, Matrix4x2, Matrix4x3, Matrix4x5,
        Matrix4x6, Matrix5, Matrix5x1, Matrix5x2, Matrix5x3, Matrix5x4, Matrix5x6, Matrix6,
        Matrix6x1, Matrix6x2, Matrix6x3, Matrix6x4, Matrix6x5, Point2, Point3, Quaternion,
        Rotation2, Rotation3, RowVector1, RowVector2, RowVector3, RowVector4, RowVector5,
        RowVector6, SMatrix, SVector, Translation2, Translation3, Unit, UnitQuaternion,
        UnitVector2, UnitVector3, Vector1, Vector2, Vector3, Vector4, Vector5, Vector6,
    };
}

/// Checks an index of the library's containers, as a fault of its own in the C.
#[doc(hidden)]
#[macro_export]
macro_rules! __inside {
    ($condition:expr) => {
        ::core::assert!($condition, "index out of bounds")
    };
}

/// Checks the capacity of the library's containers.
#[doc(hidden)]
#[macro_export]
macro_rules! __room {
    ($condition:expr) => {
        ::core::assert!($condition, "the container is full")
    };
}

/// Checks the bounds of `clamp`.
#[doc(hidden)]
#[macro_export]
macro_rules! __between {
    ($condition:expr) => {
        ::core::assert!($condition, "min > max: the bounds are the wrong way round")
    };
}

/// Checks that the result of the library's arithmetic fits into its type.
#[doc(hidden)]
#[macro_export]
macro_rules! __fits {
    ($condition:expr) => {
        ::core::assert!($condition, "attempt to compute with overflow")
    };
}

/// Checks the divisor of the library's arithmetic.
#[doc(hidden)]
#[macro_export]
macro_rules! __divides {
    ($condition:expr) => {
        ::core::assert!($condition, "attempt to divide by zero")
    };
}

/// Checks the number of bits by which the library's arithmetic shifts.
#[doc(hidden)]
#[macro_export]
macro_rules! __shifts {
    ($condition:expr) => {
        ::core::assert!($condition, "attempt to shift with overflow")
    };
}

/// Expands to code that calls functions natively, such as tables of tests; a generation build omits it.
#[doc(hidden)]
#[cfg(not(feature = "generate"))]
#[macro_export]
macro_rules! __natively {
    ($($item:item)*) => { $($item)* };
}

/// Expands to nothing in a generation build.
#[doc(hidden)]
#[cfg(feature = "generate")]
#[macro_export]
macro_rules! __natively {
    ($($left_out:tt)*) => {};
}

/// Expands to the program that the generator links with a package, which prints the package's tree
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
            // Initial values of large components pass through the stack, and trees nest deep.
            let tree = ::std::thread::Builder::new().stack_size(1 << 30).spawn(move || {
                println!("{}", $crate::generate::package(name, stringify!($models), license))
            });
            if tree.map_or(true, |tree| tree.join().is_err()) {
                ::std::process::exit(1);
            }
        }
    };
}
