//! Functions that return iterators: a loop over the result becomes the function's own loop, with the author's body
//! inside.

use bessemer::prelude::*;

/// A set of inputs, one bit for each.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    pub bits: u16,
}

#[data]
impl Inputs {
    /// Returns true if an input is in the set.
    pub fn contains(self, n: u16) -> bool {
        n < 16 && self.bits >> n & 1 == 1
    }

    /// The numbers of the inputs, ascending.
    pub fn iter(self) -> impl DoubleEndedIterator<Item = u16> {
        (0..u16::BITS as u16).filter(move |&n| self.contains(n))
    }
}

/// Readings of a sensor, of which the first `count` are valid.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Readings {
    pub values: [f64; 6],
    pub valid: usize,
    pub most: f64,
}

#[data]
impl Readings {
    /// The valid readings; all if `count` exceeds the capacity.
    pub fn given(&self) -> impl Iterator<Item = &f64> {
        let most = if self.valid > 6 { 0 } else { self.valid };
        self.values[..most].iter().filter(|value| **value < self.most)
    }

    /// The values scaled by another function.
    pub fn scaled(&self, by: f64) -> impl Iterator<Item = f64> + '_ {
        self.given().map(move |value| value * by)
    }

    /// Each reading with the one after it.
    fn pairs<'a>(&'a self) -> impl Iterator<Item = (&'a f64, &'a f64)> + 'a {
        self.values.iter().zip(self.values.iter().skip(1))
    }

    /// Each reading with the one after it, and the last with the first.
    fn edges(&self) -> impl Iterator<Item = (&f64, &f64)> {
        let next = self.values.iter().cycle().skip(1);
        self.values.iter().zip(next)
    }

    /// Summarises the readings.
    pub fn summary(&self) -> (usize, f64, Option<f64>, Option<f64>) {
        let steps = self.pairs().map(|(one, next)| (next - one).abs()).fold(0.0, f64::max);
        let rising = self.pairs().filter(|(one, next)| one < next).count();
        let area: f64 = self.edges().map(|(one, next)| one * next).sum();
        (rising, steps + area, self.scaled(2.0).last(), self.scaled(0.5).next())
    }

    /// The largest reading.
    pub fn largest(&self) -> Option<f64> {
        self.given().max_by(|one, other| one.total_cmp(other)).copied()
    }

    /// Number of readings before the first above a limit.
    pub fn before(&self, limit: f64) -> Option<usize> {
        for (at, value) in self.scaled(1.5).enumerate() {
            if value > limit {
                return Some(at);
            }
        }
        None
    }
}

/// `continue` and `break` in loops over such iterators.
#[function]
pub fn weighed(inputs: Inputs, more: Inputs) -> u32 {
    let mut sum = 0_u32;
    for n in inputs.iter() {
        if n == 3 {
            continue;
        }
        if n == 12 {
            break;
        }
        sum += u32::from(n);
    }
    'outer: for one in Inputs::iter(inputs) {
        for other in more.iter() {
            if other > one {
                continue 'outer;
            }
            if other == 11 {
                break 'outer;
            }
            sum += u32::from(one - other);
        }
    }
    sum + more.iter().count() as u32 + u32::from(inputs.iter().sum::<u16>())
}

/// Quotients, of which a division by zero is a fault.
#[function]
fn shares(of: u32, by: [u32; 3]) -> impl Iterator<Item = u32> {
    by.into_iter().map(move |part| of / part)
}

/// A fault occurs where Rust panics: not after the item that ends the loop.
#[function]
pub fn first_share(of: u32, by: [u32; 3]) -> u32 {
    let mut most = 0;
    for share in shares(of, by) {
        if share > 100 {
            return share;
        }
        most = share.max(most);
    }
    most
}

/// A range as a variable.
#[function]
pub fn fences(low: f64, high: f64, value: f64) -> bool {
    let reach = 1.5 * (high - low);
    around(low, high, reach).contains(&value)
}

/// A range as a return value.
#[function]
pub fn around(low: f64, high: f64, reach: f64) -> core::ops::RangeInclusive<f64> {
    low - reach..=high + reach
}
