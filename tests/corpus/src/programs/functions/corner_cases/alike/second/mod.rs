//! The second of two.

pub mod state;
