//! `count` of elements or numbers that nothing else uses.

use bessemer::prelude::*;

/// Counts of elements, pairs, indices, windows and ranges.
#[function]
pub fn all(values: &[i32; 3], list: &List<u8, 4>, last: u8) -> usize {
    values.iter().count()
        + 10 * list.iter().count()
        + 100 * values.iter().zip(list).enumerate().count()
        + 1000 * values.windows(2).count()
        + 10000 * values.iter().copied().skip(1).count()
        + (0..last).count()
        + (1..=last % 100).rev().count()
}

/// Counts with closures: they are evaluated, and `None` is not counted.
#[function]
pub fn computed(values: &[i8; 4], last: u8) -> usize {
    let odd = values.iter().filter_map(|x| (x % 2 != 0).then_some(*x)).count();
    let leading = (0..last).map_while(|x| (x < 3).then_some(x)).count();
    let there = [Some(last), None, Some(1)].iter().flatten().count();
    let raised = values.iter().map(|x| x + 1).count();
    odd + 10 * leading + 1000 * there + 10000 * raised
}

/// A loop over an empty array.
#[function]
pub fn none(values: &[i32; 3]) -> usize {
    values.iter().take(0).count() + (0..0_u8).map(|x| x + 1).count()
}
