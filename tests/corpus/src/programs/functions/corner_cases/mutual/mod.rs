//! Two modules that use each other's types. C headers cannot do that, so the two share one header.

pub mod left;
pub mod right;

use bessemer::prelude::*;

use left::Near;
use right::{Far, far_of};

/// Sum over the types of both modules.
#[function]
pub fn both(a: i16, b: i16) -> i32 {
    let far = far_of(Near { value: a }, b);
    far.near.value as i32 + left::weight(Far { near: Near { value: b }, ..far }) as i32
}
