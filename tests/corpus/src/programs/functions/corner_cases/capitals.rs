//! Names of constants and variants that would collide in the C.

use bessemer::prelude::*;

/// An enum whose variant `D` is `A_D` in the C.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum A {
    #[default]
    B,
    D,
}

const A_D: i32 = 3;

mod factors {
    pub const X: f64 = 0.5;
}

/// A constant, and a variant.
#[function]
pub fn number(a: A) -> i32 {
    match a {
        A::B => A_D,
        A::D => 7,
    }
}

/// A constant in one function and a parameter of another.
#[function]
pub fn half(x: f64) -> f64 {
    x * factors::X
}

#[function]
pub fn squared(X: f64) -> f64 {
    X * X
}
