//! Structs that are initialised and then overwritten, wholly or partly: unread initial values may be removed, the
//! others must stay.

use bessemer::prelude::*;

/// A struct with fields of several types.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Parts {
    /// Numbers in an array.
    pub numbers: [f64; 4],
    /// Numbers in a vector.
    pub others: Vector4<f64>,
    /// A count.
    pub count: u32,
}

#[data]
impl Parts {
    /// A struct without a zero field.
    pub fn some() -> Parts {
        Parts { numbers: [1.5; 4], others: Vector4::repeat(2.5), count: 7 }
    }
}

/// Each field is overwritten before it is read.
#[function]
pub fn rewritten_whole(a: f64, count: u32) -> Parts {
    let mut parts = Parts::some();
    parts.count = count;
    for n in 0..4 {
        parts.numbers[n] = a + n as f64;
        parts.others[n] = a * n as f64;
    }
    parts
}

/// One element keeps its initial value.
#[function]
pub fn rewritten_but_for_one(a: f64, count: u32) -> Parts {
    let mut parts = Parts::some();
    parts.count = count;
    for n in 0..3 {
        parts.numbers[n] = a + n as f64;
    }
    for n in 0..4 {
        parts.others[n] = a;
    }
    parts
}

/// A field is read before it is overwritten.
#[function]
pub fn rewritten_and_read(a: f64, count: u32) -> Parts {
    let mut parts = Parts::some();
    for n in 0..4 {
        parts.numbers[n] = parts.others[n] - a;
    }
    for n in 0..4 {
        parts.others[n] = a;
    }
    parts.count = count;
    parts
}

/// A `return` comes before the last field is overwritten.
#[function]
pub fn rewritten_too_late(a: f64, count: u32) -> Parts {
    let mut parts = Parts::some();
    parts.numbers = [a; 4];
    parts.others = Vector4::repeat(a);
    if count > 9 {
        return parts;
    }
    parts.count = count;
    parts
}

/// A field that is not overwritten in each iteration.
#[function]
pub fn rewritten_at_times(a: f64, count: u32) -> Parts {
    let mut parts = Parts::some();
    parts.numbers = [a; 4];
    parts.count = count;
    for n in 0..4 {
        if count > n as u32 {
            parts.others[n] = a;
        }
    }
    parts
}
