//! Loops that end because each pass removes an element of a list, or counts on.

use bessemer::prelude::*;

#[function]
pub fn removed(l: &mut List<u32, 8>) -> u32 {
    let mut sum = 0_u32;
    let mut i = 0;
    while i < l.len() {
        if l[i] % 2 == 0 {
            sum = sum.wrapping_mul(31).wrapping_add(l.remove(i));
        } else {
            i += 1;
        }
    }
    sum
}

#[function]
pub fn removed_last(l: &mut List<u32, 8>) -> u32 {
    let mut sum = 0_u32;
    let mut i = 0;
    while i < l.len() {
        if l[i] % 2 == 0 {
            let last = l.swap_remove(i);
            sum = sum.wrapping_mul(31).wrapping_add(last);
            continue;
        }
        i += 1;
    }
    sum
}
