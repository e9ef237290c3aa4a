//! Assignments to several places.

use bessemer::prelude::*;

#[function]
pub fn pair(x: i32) -> (i32, [i32; 2]) {
    (x.wrapping_add(1), [x, 2])
}

#[function]
pub fn taken(values: &mut [i32; 4], at: usize) -> i32 {
    let a;
    let mut b;
    let mut i = at;
    (a, [b, _]) = pair(values[0]);
    (values[i], i) = (i as i32, 1);
    [values[i], b] = [b, values[i]];
    (values[2], _) = (a, b);
    _ = pair(a);
    (b, values[3]) = (b.wrapping_sub(a), values[0]);
    b
}

static TABLE: [u16; 4] = [1, 20, 300, 4000];

#[function]
pub fn looked_up(at: usize) -> u16 {
    static OFFSETS: [u16; 2] = [5, 6];
    TABLE[at % 4] + OFFSETS[at % 2] + TABLE.len() as u16
}
