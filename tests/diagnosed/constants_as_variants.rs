//! Constants of a type named as variants of another.
#![no_std]
#![allow(non_upper_case_globals)]
use bessemer::prelude::*;

/// Mode.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Nothing.
    #[default]
    Idle,
    /// Stays.
    Hover,
}

/// A preset mode.
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

/// Tests the mode against a constant.
#[function]
pub fn is_preset(mode: Mode) -> bool {
    match mode {
        Preset::Idle => true,
        _ => false,
    }
}
