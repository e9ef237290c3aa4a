//! Shared references that an `if` or a `match` chooses.

use bessemer::prelude::*;

#[function]
pub fn chosen(a: [u32; 3], b: [u32; 3], x: u32, k: u8) -> u32 {
    let row = if k % 2 == 0 { &a } else { &b };
    let one = if k % 3 == 0 { &a[1] } else { &x };
    let other = match k % 4 {
        0 => &b[2],
        1 => one,
        _ => &row[0],
    };
    let mut sum = row[0] ^ *one;
    for y in row {
        sum = sum.wrapping_mul(31).wrapping_add(*y ^ *other);
    }
    sum
}
