//! A module with the same names as `left`.

use bessemer::prelude::*;

pub const LIMIT: i32 = 9;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading {
    pub value: i32,
}

#[data]
impl Reading {
    pub fn value(&self) -> i32 {
        -self.value
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
    a.wrapping_mul(5)
}

#[function]
pub fn reading_value(a: i32) -> i32 {
    a & 7
}
