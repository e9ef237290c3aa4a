//! The type `State` with whole numbers.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inner {
    pub value: i32,
}

#[function]
pub fn positive(value: i32) -> Option<Inner> {
    if value > 0 { Some(Inner { value }) } else { None }
}
