//! From the typed IR to checked IR, and from that to C99.
//!
//! [`validate`] precedes and behind the [`passes`]; [`c`] prints what they leave, and [`kernels`] are its routines of linear
//! algebra. None of them imports another, save that the C asks the passes which sizes fit into 32 bits (`passes::sizes`), and
//! what a call reaches (`passes::reached`).
//!
//! Must not know: the author's Rust, and who requests C.

// The order of a hash table differs from run to run: the C must not depend on it.
#![warn(clippy::iter_over_hash_type)]

mod built;
pub mod c;
pub mod kernels;
pub mod passes;
mod uncopied;
pub mod validate;
