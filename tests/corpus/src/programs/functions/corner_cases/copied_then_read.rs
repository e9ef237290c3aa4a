//! A pair that is assigned and then read, in a function with references to both pairs. gcc 12 mistakes the write for
//! a read in its analysis of side effects, and the caller reads the old pair.

use bessemer::prelude::*;

#[function]
fn twice(mut step: impl FnMut(i32) -> i32) -> i32 {
    let first = step(1);
    first.wrapping_mul(3).wrapping_add(step(2))
}

#[function]
pub fn copied_then_read(x: [[i32; 2]; 4], n: i32) -> i32 {
    let mut target = (&x[0], n);
    let mut all = [(&x[2], 1), (&x[3], 2)];
    let sum = twice(|factor| {
        let before = target.0;
        target.0 = all[1].0;
        let other = &all[0].0[1];
        all[0] = all[1];
        let now = &target.0[0];
        target = all[0];
        before[0].wrapping_mul(factor) ^ other ^ now
    });
    sum.wrapping_add(target.0[1]).wrapping_add(all[0].0[0])
}
