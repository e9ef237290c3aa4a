//! Two modules of which each needs the other's types: headers of C cannot, so that they are one.

pub mod left;
pub mod right;

use bessemer::prelude::*;

use left::Near;
use right::{Far, far_of};

/// Sum of both types.
#[function]
pub fn both(a: i16, b: i16) -> i32 {
    let far = far_of(Near { value: a }, b);
    far.near.value as i32 + left::weight(Far { near: Near { value: b }, ..far }) as i32
}
