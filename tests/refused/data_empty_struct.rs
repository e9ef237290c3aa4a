#![no_std]
extern crate std;

use bessemer::prelude::*;

/// No state.
#[component]
#[derive(Default)]
pub struct Monitor;

/// No type in the C.
#[data]
#[c(name = "Marker_t")]
pub struct Marker;

/// No values.
#[data]
pub enum Never {}

fn main() {}
