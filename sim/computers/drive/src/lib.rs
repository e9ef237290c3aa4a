//! The controller of the drive example as a package of models, for the tests of computers.
//!
//! It has no code of its own: the example must not have another controller than the tests.

#[path = "../../../kit/examples/drive/control.rs"]
pub mod control;
