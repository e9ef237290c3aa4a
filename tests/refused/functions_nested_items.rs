#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Items inside.
#[function]
pub fn nested_items(x: f64) -> f64 {
    fn helper(x: f64) -> f64 {
        x
    }
    struct Local {
        x: f64,
    }
    if x > 0.0 {
        const HALF: f64 = 0.5;
        return HALF;
    }
    helper(Local { x }.x)
}

fn main() {}
