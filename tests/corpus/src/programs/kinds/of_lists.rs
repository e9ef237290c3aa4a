//! Lists of words.

use bessemer::prelude::*;

/// The kind.
pub type It = List<f64, 4>;
/// Its numbers.
pub type Number = f64;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    let mut list = List::new();
    list.push(x);
    list
}

/// One of them.
#[function]
pub fn one() -> It {
    let mut list = List::new();
    list.push(1.5);
    list.push(-0.5);
    list
}

/// Another.
#[function]
pub fn other() -> It {
    List::new()
}

/// Makes it a third.
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
