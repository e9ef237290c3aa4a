//! A computation that would be written by recursion, as a loop with a stack of bounded length.

use bessemer::prelude::*;

/// The number of ways to climb `steps` stairs in steps of one or two.
#[function]
pub fn ways(steps: u8) -> u64 {
    let (mut before, mut ways) = (0_u64, 1_u64);
    for _ in 0..steps.min(90) {
        let next = ways.wrapping_add(before);
        before = ways;
        ways = next;
    }
    ways
}
