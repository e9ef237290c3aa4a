//! A case.
#![no_std]
use bessemer::prelude::*;

/// What the board reads; the stand-in can fault, and the board could not say so.
#[external(header = "board.h")]
pub fn board_read(table: &[f64; 4], channel: usize) -> f64 {
    table[channel]
}
