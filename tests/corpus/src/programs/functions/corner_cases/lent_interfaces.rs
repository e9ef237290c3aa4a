//! Traits implemented for types that borrow, with each form of a lifetime.

#![allow(missing_docs)]

use bessemer::prelude::*;

#[interface]
pub trait Zone {
    const WEIGHT: u32;

    fn contains(&self, x: u32) -> bool;

    /// A weight that each implementation defines.
    fn weight(&self, xs: [u32; 4]) -> u32 {
        let mut sum = 0;
        for x in xs {
            if self.contains(x % 8) {
                sum += Self::WEIGHT;
            }
        }
        sum
    }

    /// Passes every zone to a function.
    fn both(&self, xs: [u32; 4]) -> u32
    where
        Self: Sized,
    {
        2 * weighed(self, xs)
    }
}

#[interface]
pub trait Begins<'a> {
    fn first(&self) -> u32;
}

#[data]
#[derive(Clone, Copy, Debug)]
pub struct Among<'a> {
    values: &'a [u32],
}

#[data]
impl Zone for Among<'_> {
    const WEIGHT: u32 = 1;

    fn contains(&self, x: u32) -> bool {
        self.values.iter().any(|value| *value % 8 == x)
    }
}

#[data]
impl<'a> Begins<'a> for Among<'a> {
    fn first(&self) -> u32 {
        self.values.first().copied().unwrap_or(77)
    }
}

#[data]
impl<'z> core::ops::Not for Among<'z> {
    type Output = bool;

    fn not(self) -> bool {
        self.values.is_empty()
    }
}

#[data]
#[derive(Clone, Copy, Debug)]
pub struct Apart<'a, const N: usize> {
    from: &'a [u32; N],
}

#[data]
impl<'a, const N: usize> Zone for Apart<'a, N> {
    const WEIGHT: u32 = 10;

    fn contains(&self, x: u32) -> bool {
        self.from.iter().all(|value| *value % 8 != x)
    }
}

#[data]
#[derive(Clone, Copy, Debug)]
pub struct Either<'a, 'b> {
    one: Among<'a>,
    other: &'b [u32],
}

#[data]
impl<'a> Zone for Either<'a, '_> {
    const WEIGHT: u32 = 100;

    fn contains(&self, x: u32) -> bool {
        self.one.contains(x) || self.other.contains(&x)
    }

    fn both(&self, xs: [u32; 4]) -> u32 {
        self.one.both(xs) + self.weight(xs)
    }
}

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Below {
    pub limit: u32,
}

#[data]
impl Zone for Below {
    const WEIGHT: u32 = 1000;

    fn contains(&self, x: u32) -> bool {
        x < self.limit
    }
}

#[function]
fn weighed<Z: Zone>(zone: &Z, xs: [u32; 4]) -> u32 {
    zone.weight(xs) + u32::from(zone.contains(xs[0] % 8))
}

#[function]
pub fn zones(values: [u32; 5], count: usize, xs: [u32; 4], limit: u32) -> [u32; 6] {
    let among = Among { values: &values[..count % 6] };
    let apart = Apart { from: &[limit % 8, 3] };
    let either = Either { one: among, other: &xs[1..] };
    let below = Below { limit: limit % 8 };
    [
        among.both(xs),
        apart.both(xs),
        either.both(xs),
        below.both(xs),
        weighed(&either, xs) + weighed(&below, xs),
        if !among { 5 } else { among.first() },
    ]
}
