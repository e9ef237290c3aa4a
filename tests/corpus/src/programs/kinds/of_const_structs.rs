//! A constant struct that contains arrays of arrays.

use bessemer::prelude::*;

/// Coefficients of a profile at three speeds.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Airfoil {
    pub lift: [[[f64; 2]; 2]; 3],
    pub drag: [[f64; 2]; 3],
    pub name: [u8; 4],
}

/// A thin airfoil.
const THIN: Airfoil = Airfoil {
    lift: [[[0.0, 1.0], [0.5, 1.5]], [[0.0, 2.0], [0.5, 2.5]], [[-0.0, 3.0], [0.5, 3.5]]],
    drag: [[0.01, 0.02], [0.03, 0.04], [0.05, 0.06]],
    name: *b"thin",
};

/// The type of this kind.
pub type It = Airfoil;
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    let mut made = THIN;
    made.drag[2][1] = x;
    made
}

/// A first value.
#[function]
pub fn one() -> It {
    THIN
}

/// A second, different value.
#[function]
pub fn other() -> It {
    Airfoil { drag: [[0.5; 2]; 3], ..THIN }
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it.lift[2][1] = THIN.drag[0];
}

include!("six.in");
include!("floats.in");
