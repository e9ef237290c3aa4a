//! `panic!`, `unreachable!` and `todo!` are faults, as a failed assertion is; their messages are not in the C.

use bessemer::prelude::*;

/// The period of a timer for its prescaler setting, in clocks.
#[function]
pub fn period(prescaler: u8) -> u32 {
    match prescaler {
        0 => 1,
        1 => 8,
        2 => 64,
        3 => panic!("prescaler {prescaler} is reserved"),
        _ => unreachable!(),
    }
}

/// The larger of two numbers that must differ.
#[function]
pub fn larger(a: i32, b: i32) -> i32 {
    if a == b {
        panic!("equal: {}", a);
    }
    let larger = if a > b { a } else { b };
    larger
}

/// The content, or a panic.
#[function]
pub fn required(value: Option<f64>) -> f64 {
    let Some(value) = value else { unreachable!("checked before") };
    match value > 0.0 {
        true => value,
        false => todo!(),
    }
}
