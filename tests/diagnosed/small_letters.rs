//! Constants and variants of small letters, which a pattern binds to the eye and compares to rustc.
#![allow(non_upper_case_globals, non_camel_case_types)]
use bessemer::prelude::*;

const limit: i32 = 5;

#[function]
pub fn at_limit(x: i32) -> bool {
    match x {
        limit => true,
        _ => false,
    }
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Mode {
    #[default]
    idle,
    hover,
}
use Mode::{hover, idle};

#[function]
pub fn motors(mode: Mode) -> u8 {
    match mode {
        hover => 4,
        idle => 0,
    }
}
