//! The type `State` with floats.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inner {
    pub value: f64,
}

#[function]
pub fn positive(value: f64) -> Option<Inner> {
    if value > 0.0 { Some(Inner { value }) } else { None }
}
