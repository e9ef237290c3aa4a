//! Integers that are not zero.

pub use core::num::{NonZero, NonZeroI16, NonZeroU32};

use bessemer::prelude::*;

/// A percentage; `None` if the whole is zero.
#[function]
pub fn share(counts: u32, of: u32) -> Option<u32> {
    let of = NonZeroU32::new(of)?;
    Some(counts * 100 / of.get())
}

/// The periods of two tasks.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Periods {
    /// The periods, in ticks.
    pub ticks: [NonZero<u16>; 2],
    /// The delay in ticks; `None` without a delay.
    pub delay: Option<NonZeroI16>,
}

#[data]
impl Periods {
    /// The least common multiple of the periods.
    pub fn both(&self) -> u32 {
        let [a, b] = self.ticks;
        let (mut low, mut high) = (u32::from(a.get()), u32::from(u16::from(b)));
        let product = low * high;
        for _ in 0..32 {
            if low == 0 {
                break;
            }
            (low, high) = (high % low, low);
        }
        product / high
    }

    /// Extends the delay by a number of ticks; returns false if there is none afterwards.
    pub fn later(&mut self, by: i16) -> bool {
        let delay = self.delay.map_or(by, |delay| delay.get().wrapping_add(by));
        self.delay = NonZeroI16::new(delay);
        self.delay.is_some()
    }
}

/// Returns true if two numbers are equal.
#[function]
pub fn same(one: NonZeroU32, other: &NonZeroU32) -> bool {
    one == *other && one != NonZeroU32::MIN
}
