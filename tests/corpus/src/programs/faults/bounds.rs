//! A loop that does not end within its bound is a fault.

use bessemer::prelude::*;

/// Number of steps of the Collatz sequence down to 1.
#[function]
pub fn steps(n: u16) -> u32 {
    let mut value = u64::from(n);
    let mut steps = 0;
    #[bound(20)]
    while value > 1 {
        value = if value % 2 == 0 { value / 2 } else { 3 * value + 1 };
        steps += 1;
    }
    steps
}
