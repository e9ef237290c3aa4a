//! A module of two with the same submodule name.

pub mod state;
