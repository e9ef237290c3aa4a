//! The first of two.

pub mod state;
