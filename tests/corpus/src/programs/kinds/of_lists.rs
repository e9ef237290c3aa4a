//! Lists of floats.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = List<f64, 4>;
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    let mut list = List::new();
    list.push(x);
    list
}

/// A first value.
#[function]
pub fn one() -> It {
    let mut list = List::new();
    list.push(1.5);
    list.push(-0.5);
    list
}

/// A second, different value.
#[function]
pub fn other() -> It {
    List::new()
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    if it.is_empty() {
        it.push(3.0);
    } else {
        it.pop();
    }
}

include!("six.in");
include!("floats.in");
