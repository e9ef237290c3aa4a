//! A trait of an author's own that is named as nalgebra's is, in the path of a method that the DSL owns.
#![no_std]
use bessemer::prelude::*;

pub trait RealField {
    fn sin(self) -> Self;
}

impl RealField for f64 {
    fn sin(self) -> f64 {
        self * 0.5
    }
}

/// The author's sine, which is none.
#[function]
pub fn half(x: f64) -> f64 {
    RealField::sin(x)
}
