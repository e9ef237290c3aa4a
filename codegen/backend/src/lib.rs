//! From the typed IR to explicit IR, and from that to C99.
//!
//! [`validate`] runs before and after the [`passes`]; [`c`] emits their result, and [`kernels`] are its routines of
//! linear algebra. None of them imports another, except that the C queries the passes: which sizes fit into 32 bits
//! (`passes::sizes`), and which functions a call reaches (`passes::reached`).
//!
//! Must not know: the author's Rust, and the purpose of the C.

// The order of a hash table differs from run to run: the C must not depend on it.
#![warn(clippy::iter_over_hash_type)]

mod built;
pub mod c;
mod filled;
mod joined;
pub mod kernels;
mod late;
pub mod passes;
mod routines;
mod uncopied;
pub mod validate;
