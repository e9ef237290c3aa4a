//! A module with the same names as `right`.

use bessemer::prelude::*;

pub const LIMIT: i32 = 5;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading {
    pub value: i32,
}

#[data]
impl Reading {
    pub fn value(&self) -> i32 {
        self.value
    }
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Mode {
    #[default]
    Low,
    High,
}

#[function]
pub fn scale(a: i32) -> i32 {
    a.wrapping_mul(3)
}

#[function]
pub fn clash_step(a: i32) -> i32 {
    a & 3
}
