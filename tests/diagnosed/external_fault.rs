//! A case.
#![no_std]
use bessemer::prelude::*;

/// Reads the board; the stand-in can fault, and the board could not report it.
#[external(header = "board.h")]
pub fn board_read(table: &[f64; 4], channel: usize) -> f64 {
    table[channel]
}
