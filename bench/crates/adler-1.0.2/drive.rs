//! Calls of `adler` over plain numbers.

use crate::*;

pub fn of_slice(data: [u8; 9]) -> u32 {
    adler32_slice(&data)
}

pub fn of_long(byte: u8, step: u8) -> u32 {
    let mut data = [0_u8; 1024];
    let mut next = byte;
    for it in data.iter_mut() {
        *it = next;
        next = next.wrapping_add(step);
    }
    adler32_slice(&data)
}

pub fn resumed(from: u32, first: [u8; 5], second: [u8; 10]) -> u32 {
    let mut sum = Adler32::from_checksum(from);
    sum.write_slice(&first);
    sum.write_slice(&second);
    sum.checksum()
}
