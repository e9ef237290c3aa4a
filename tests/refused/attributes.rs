#![no_std]
extern crate std;

use bessemer::prelude::*;

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Valve {
    pub open: bool,
}

#[component]
impl Valve {
    #[entry(atomic, infallible)]
    pub fn both(&mut self) {
        self.open = true;
    }

    #[entry(rollback)]
    pub fn unknown(&mut self) {
        self.open = true;
    }

    #[entry]
    #[inline(always)]
    pub fn inlined(&mut self) {
        self.open = true;
    }

    #[c(name = "2fast")]
    fn named(&self) -> bool {
        self.open
    }

    #[c(align = "8")]
    fn aligned(&self) -> bool {
        self.open
    }
}

#[function]
#[inline]
#[c(section = ".fast")]
pub fn placed(x: f64) -> f64 {
    x
}

#[function]
#[c(section = "a b")]
pub fn misplaced(x: f64) -> f64 {
    x
}

#[function]
#[c(name = "twice")]
pub fn generic<T: Real>(x: T) -> T {
    x + x
}

#[external]
pub fn headless(x: f64) -> f64 {
    x
}

#[external(header = "no header")]
pub fn misnamed(x: f64) -> f64 {
    x
}

#[c(name = "alone")]
pub fn alone(x: f64) -> f64 {
    x
}

#[function]
pub fn loops(values: &[f64; 4]) -> f64 {
    let mut sum = 0.0;
    #[unroll(1000)]
    for value in values {
        sum += value;
    }
    #[keep(2)]
    for value in values {
        sum += value;
    }
    sum
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Speed {
    #[unit]
    pub value: f64,
}

#[data]
#[c(name = "speed_t")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scaled<T> {
    pub value: T,
}

#[data]
#[unit("m")]
#[c(section = ".data")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Placed {
    #[c(name = "2fast")]
    #[c(section = ".data")]
    pub value: f64,
}

#[data]
#[c(section = "a b")]
const TABLE: [f64; 2] = [1.0, 2.0];

#[data]
static mut CHANGED: u32 = 0;

#[function]
pub fn named(#[c(name = "a b")] x: f64, #[unit("")] y: f64) -> f64 {
    x + y + TABLE[0]
}

#[data]
#[range(0.0..=1.0)]
#[axes(low)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Share {
    #[range(1.0..=0.0)]
    pub backwards: f64,
    #[range(0.0..1.0)]
    pub open: f64,
    #[range(-LIMIT..=LIMIT)]
    pub named: f64,
}

fn main() {}

#[data]
#[derive(Clone, Copy, Debug)]
pub enum Chosen {
    #[c(fallback)]
    First,
    #[c(fallback)]
    Second,
    #[c(fallback)]
    Third(f64),
}

#[data]
#[derive(Clone, Copy, Debug)]
pub struct Unchosen {
    #[c(fallback)]
    pub value: f64,
}
