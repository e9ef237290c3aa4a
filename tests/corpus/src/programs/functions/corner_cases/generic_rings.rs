//! Generic types with their own index, `==`, `iter` and iterators; the instances have no names.

use core::ops::{Index, IndexMut};

use bessemer::prelude::*;

/// A ring buffer of the last values.
#[data]
#[derive(Clone, Debug)]
pub struct Ring<T, const N: usize> {
    items: [T; N],
    head: usize,
    len: usize,
}

#[data]
impl<T: Copy + Default, const N: usize> Ring<T, N> {
    /// An empty ring.
    pub fn new() -> Self {
        Ring { items: [T::default(); N], head: 0, len: 0 }
    }

    /// Adds a value, which replaces the oldest if the ring is full.
    pub fn push(&mut self, item: T) {
        self.items[self.head] = item;
        self.head = (self.head + 1) % N;
        self.len = (self.len + 1).min(N);
    }

    /// Iterates from the oldest value on.
    pub fn iter(&self) -> impl Iterator<Item = T> + '_ {
        let start = self.head + N - self.len;
        (0..self.len).map(move |i| self.items[(start + i) % N])
    }

    /// The values as an iterator with a name.
    pub fn values(&self) -> Values<'_, T, N> {
        Values { ring: self, at: 0 }
    }

    /// Returns true if another ring has the same values.
    pub fn is_same(&self, other: &Self) -> bool
    where
        T: PartialEq,
    {
        self.len == other.len && self.iter().zip(other.iter()).all(|(one, other)| one == other)
    }

    fn place(&self, i: usize) -> usize {
        (self.head + N - self.len + i) % N
    }
}

#[data]
impl<T: Copy + Default, const N: usize> Index<usize> for Ring<T, N> {
    type Output = T;

    fn index(&self, i: usize) -> &T {
        let at = self.place(i);
        &self.items[at]
    }
}

#[data]
impl<T: Copy + Default, const N: usize> IndexMut<usize> for Ring<T, N> {
    fn index_mut(&mut self, i: usize) -> &mut T {
        let at = self.place(i);
        &mut self.items[at]
    }
}

/// Iterator over the values of a ring.
#[data]
#[derive(Clone, Debug)]
pub struct Values<'a, T, const N: usize> {
    ring: &'a Ring<T, N>,
    at: usize,
}

#[data]
impl<T: Copy + Default, const N: usize> Iterator for Values<'_, T, N> {
    type Item = T;

    fn next(&mut self) -> Option<T> {
        if self.at >= self.ring.len {
            return None;
        }
        let item = self.ring[self.at];
        self.at += 1;
        Some(item)
    }
}

/// Counts down by steps of any size.
#[data]
#[derive(Clone, Debug)]
pub struct Down<T> {
    left: u8,
    step: T,
}

#[data]
impl<T: Copy + Into<u8>> Iterator for Down<T> {
    type Item = u8;

    fn next(&mut self) -> Option<u8> {
        let step: u8 = self.step.into();
        self.left = self.left.checked_sub(step.max(1))?;
        Some(self.left)
    }
}

/// The median of some values.
#[function]
fn median<const N: usize>(values: impl Iterator<Item = i16>) -> Option<i16> {
    let mut sorted = [0_i16; N];
    let mut count = 0;
    for (slot, value) in sorted.iter_mut().zip(values) {
        *slot = value;
        count += 1;
    }
    let sorted = &mut sorted[..count];
    sorted.sort_unstable();
    sorted.get(count / 2).copied()
}

/// Rings read and written by index, and compared.
#[function]
pub fn indexed(values: [i16; 7], k: usize) -> (i16, i32, bool, bool) {
    let mut ring = Ring::<i16, 4>::new();
    for value in values {
        ring.push(value);
    }
    ring[0] = ring[1].wrapping_add(3);
    let mut other = ring.clone();
    ring[k & 3] = 7;
    let mut sum = 0_i32;
    for i in 0..4 {
        sum += i32::from(ring[i]);
    }
    let equal = ring.is_same(&other);
    other[k & 3] = 7;
    (ring[2], sum, equal, ring.is_same(&other))
}

/// Rings iterated over by their own `iter`, in loops, chains, zips and functions.
#[function]
pub fn gone_through(values: [i16; 6], count: usize) -> (i32, Option<i16>, Option<i16>, i32, usize) {
    let mut ring = Ring::<i16, 5>::new();
    for value in values.iter().take(count & 7) {
        ring.push(*value);
    }
    let mut sum = 0_i32;
    for value in ring.iter() {
        sum = sum.wrapping_mul(3).wrapping_add(i32::from(value));
    }
    let middle = median::<5>(ring.iter());
    let spread = median::<5>(ring.iter().map(|value| value.wrapping_sub(7) & 0xff));
    let mut both = 0_i32;
    for (value, other) in values.iter().zip(ring.iter().filter(|value| value & 1 == 0)) {
        both = both.wrapping_mul(5).wrapping_add(i32::from(*value) ^ i32::from(other));
    }
    (sum, middle, spread, both, ring.iter().filter(|value| *value > 0).count())
}

/// Rings iterated over by their own iterator type.
#[function]
pub fn by_values(values: [u16; 4], from: u8) -> (u32, u32, u32) {
    let mut ring = Ring::<u16, 3>::new();
    for value in values {
        ring.push(value);
    }
    let mut sum = 0_u32;
    #[bound(3)]
    for value in ring.values() {
        sum = sum.wrapping_mul(7).wrapping_add(u32::from(value));
    }
    let first = ring.values().take(2).map(u32::from).sum::<u32>();
    let mut steps = 0_u32;
    for left in (Down { left: from, step: 60_u8 }).take(9) {
        steps = steps.wrapping_mul(31).wrapping_add(u32::from(left));
    }
    (sum, first, steps)
}
