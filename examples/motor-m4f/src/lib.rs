//! A three-phase drive: the loops of speed and current, all of it in single precision.
#![no_std]

pub mod average;
pub mod drive;
pub mod modulation;
pub mod pi;
pub mod ramp;
pub mod table;

pub use drive::{Drive, Inputs, Mode, Outputs, Settings};
pub use pi::Gains;
