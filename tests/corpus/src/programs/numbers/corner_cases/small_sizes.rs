//! Sizes that are known to fit into 32 bits, used in 64-bit sums, products, shifts, comparisons and calls.

use bessemer::prelude::*;

/// Capacity of a ring buffer.
#[data]
const PLACES: usize = 12;

/// A ring buffer of numbers.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SmallSizes {
    numbers: [u64; 12],
    next: usize,
}

#[component]
impl SmallSizes {
    /// Adds a number; returns a sum over several sizes.
    #[entry]
    pub fn take(&mut self, number: u64, small: u8, wide: u16) -> u64 {
        let next = self.next % PLACES;
        let count = small as usize;
        let width = wide as usize;
        let most = width.min(2_000_000_000);
        let product = width * 65_535;
        self.numbers[next] = number;
        self.next = (next + 1) % PLACES;
        let room = PLACES - 1 - next;
        let marked = 1u64 << (count % 64);
        let far = product * most;
        let beyond = (next + most) as u64 + number % 1_000;
        if count > width && room as u64 != number {
            return marked ^ far as u64;
        }
        marked
            .wrapping_add(beyond)
            .wrapping_add(distance(product, count))
            .wrapping_add((self.numbers[room] >> (next * 5)) & 0xFF)
            .wrapping_add((width - most.min(count)) as u64)
    }
}

/// Distance of two sizes.
#[function]
fn distance(a: usize, b: usize) -> u64 {
    if a > b { (a - b) as u64 } else { (b - a) as u64 }
}
