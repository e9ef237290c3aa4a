//! Iterators over optional elements, of which only the present ones count.

use bessemer::prelude::*;

/// The sum of the present readings.
#[function]
pub fn total(readings: &[Option<u8>; 5]) -> u32 {
    let mut sum = 0;
    for reading in readings.iter().flatten() {
        sum += u32::from(*reading);
    }
    sum
}

/// The largest half of the even elements.
#[function]
pub fn largest_half(values: &[i32; 5]) -> Option<i32> {
    values.iter().filter_map(|&x| (x % 2 == 0).then(|| x / 2)).max()
}
