//! Constants of a type named as variants of another.
#![no_std]
#![allow(non_upper_case_globals)]
use bessemer::prelude::*;

/// What it does.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Nothing.
    #[default]
    Idle,
    /// Stays.
    Hover,
}

/// What it is set to.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Preset {
    /// A gain.
    pub gain: f64,
}

impl Preset {
    /// Named as another variant is.
    pub const Idle: Mode = Mode::Hover;
}

/// Which it is.
#[function]
pub fn is_preset(mode: Mode) -> bool {
    match mode {
        Preset::Idle => true,
        _ => false,
    }
}
