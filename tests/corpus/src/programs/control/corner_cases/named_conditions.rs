//! A `match` on a `bool` whose arms bind a name: the expression is evaluated once.

use bessemer::prelude::*;

#[function]
pub fn named(flag: bool, x: i32) -> i32 {
    let mut sum = 0;
    #[allow(clippy::match_single_binding)]
    match flag {
        seen => {
            let part = if seen { x } else { 7 };
            sum += part / 2;
        }
    }
    sum
}

#[function]
pub fn looked_up(flags: &[bool; 3], index: usize, x: i32) -> i32 {
    match flags[index] {
        mut seen => {
            let other = seen;
            seen = !seen & (x > 3);
            if other == seen { x } else { -1 }
        }
    }
}
