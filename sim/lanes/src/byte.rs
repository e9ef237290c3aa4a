//! Bytes in memory. Packets consist of them, and as whole numbers of 64 bits they would fill the cache.

use crate::{LANES, Lanes, Mask, Whole};

/// A `u8` in each lane, in memory: computations take it as a [`Whole`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Byte(u64);

/// The bits of the bytes whose lanes are in a set.
const SPREAD: [u64; 1 << LANES] = {
    let mut all = [0; 1 << LANES];
    let mut set = 0;
    while set < all.len() {
        let mut lane = 0;
        while lane < LANES {
            if set >> lane & 1 == 1 {
                all[set] |= 0xff << (8 * lane);
            }
            lane += 1;
        }
        set += 1;
    }
    all
};

impl Byte {
    /// Returns the lowest bytes of whole numbers.
    #[inline(always)]
    pub fn of(value: Whole) -> Byte {
        Byte(u64::from_le_bytes(value.to_array().map(|value| value as u8)))
    }

    /// Returns the bytes as whole numbers.
    #[inline(always)]
    pub fn whole(self) -> Whole {
        Whole::new(self.0.to_le_bytes().map(i64::from))
    }

    /// Replaces the byte of a lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, value: u8) {
        let shift = 8 * (lane % LANES);
        self.0 = self.0 & !(0xff << shift) | u64::from(value) << shift;
    }
}

impl Lanes for Byte {
    #[inline(always)]
    fn assign(&mut self, mask: Mask, value: &Self) {
        let bits = SPREAD[mask.set() % SPREAD.len()];
        self.0 = self.0 & !bits | value.0 & bits;
    }

    #[inline(always)]
    fn take(&mut self, lane: usize, value: &Self) {
        self.set(lane, value.0.to_le_bytes()[lane % LANES]);
    }

    #[inline(always)]
    fn splat(words: &mut impl Iterator<Item = u64>) -> Self {
        Byte(u64::from_le_bytes([words.next().unwrap_or_default() as u8; LANES]))
    }

    #[inline(always)]
    fn put(&mut self, lane: usize, words: &mut impl Iterator<Item = u64>) {
        self.set(lane, words.next().unwrap_or_default() as u8);
    }

    #[inline(always)]
    fn words(&self, lane: usize, words: &mut Vec<u64>) {
        words.push(self.0.to_le_bytes()[lane % LANES].into());
    }
}
