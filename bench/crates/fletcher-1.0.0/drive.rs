//! Calls of `fletcher` over plain numbers.

use crate::*;

pub fn of_bytes(data: [u8; 8]) -> u16 {
    calc_fletcher16(&data)
}

pub fn of_words(data: [u16; 6]) -> u32 {
    calc_fletcher32(&data)
}

pub fn of_double_words(data: [u32; 6]) -> u64 {
    calc_fletcher64(&data)
}

pub fn continued(a: u8, b: u8, data: [u8; 48]) -> u16 {
    let mut sum = Fletcher16::with_initial_values(a, b);
    sum.update(&data);
    sum.value()
}

pub fn in_parts(first: [u16; 5], second: [u16; 7]) -> u32 {
    let mut sum = Fletcher32::new();
    sum.update(&first);
    sum.update(&second);
    sum.value()
}
