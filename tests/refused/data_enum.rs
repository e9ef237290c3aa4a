#![no_std]
extern crate std;

use bessemer::prelude::*;

/// With a number beside a payload.
#[data]
#[repr(u8)]
pub enum Port {
    /// Its baud rate.
    Serial(u32) = 7,
}

/// Without variants.
#[data]
pub enum Nothing {}

fn main() {}
