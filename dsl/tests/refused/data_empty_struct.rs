#![no_std]
extern crate std;

use bessemer::prelude::*;

/// No fields.
#[data]
pub struct Marker;

fn main() {}
