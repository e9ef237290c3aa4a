//! A mutable borrow ends in one place; `[…]` denotes one place, whichever trait provides it.
#![no_std]
use bessemer::prelude::*;
use core::ops::{Index, IndexMut};

/// Two sides.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sides {
    /// One.
    pub left: f64,
    /// The other.
    pub right: f64,
    /// Both again.
    pub both: [f64; 2],
}

#[data]
impl Sides {
    /// Either.
    pub fn side_mut(&mut self, left: bool) -> &mut f64 {
        if left { &mut self.left } else { &mut self.right }
    }
}

#[data]
impl Index<usize> for Sides {
    type Output = f64;

    fn index(&self, i: usize) -> &f64 {
        &self.both[i]
    }
}

#[data]
impl IndexMut<usize> for Sides {
    fn index_mut(&mut self, i: usize) -> &mut f64 {
        &mut self.both[1 - i]
    }
}

/// Reads by an ambiguous index.
#[function]
pub fn read(sides: &Sides, i: usize) -> f64 {
    sides[i]
}

/// Zero-sized types.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mark;

/// In an array.
#[function]
pub fn marked(x: f64) -> f64 {
    let marks = [Mark; 3];
    let _ = marks;
    x
}

/// Compared.
#[function]
pub fn compared(x: f64) -> f64 {
    if Mark == Mark { x } else { 0.0 }
}

/// In a variant beside something else.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Beside.
    Marked(Mark, f64),
    /// Nothing.
    Plain,
}
