#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Fields without names.
#[data]
pub struct Pair(pub f64, pub f64);

/// No fields.
#[data]
pub struct Marker;

fn main() {}
