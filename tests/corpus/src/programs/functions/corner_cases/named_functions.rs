//! Named functions that are called and passed on; and slices whose split can fault.

use bessemer::prelude::*;

/// Half of a number.
#[function]
pub fn half(x: f64) -> f64 {
    x / 2.0
}

/// `f` applied twice.
#[function]
pub fn twice(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    f(f(x))
}

/// `f` applied through another function.
#[function]
pub fn thrice(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    twice(&f, f(x))
}

/// Variables that name functions of the author and of numbers.
#[function]
pub fn named(x: f64, y: f64) -> f64 {
    let smaller = half;
    let size = f64::abs;
    let larger = f64::max;
    let first = smaller(size(x));
    let both = thrice(|z| smaller(z) + 1.0, first);
    larger(both, twice(smaller, y)) + [x, y].iter().copied().map(size).fold(0.0, larger)
}

/// A newtype with a constructor.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Level(pub u8);

#[data]
impl Level {
    /// Level of a number.
    pub fn of(x: u32) -> Level {
        Level((x & 0xFF) as u8)
    }

    /// The next level.
    pub fn next(self) -> Level {
        Level(self.0.wrapping_add(1))
    }
}

/// Levels of numbers.
#[function]
pub fn levels(values: &[u32; 3]) -> [Level; 3] {
    let of = Level::of;
    let up = Level::next;
    let mut levels = values.map(of);
    levels[0] = up(levels[0]);
    levels
}

/// The head of a frame and the rest of it.
#[function]
pub fn head(frame: &[u8; 6], n: usize) -> Option<(u8, usize)> {
    let (head, rest) = frame.split_at_checked(n)?;
    Some((*head.last()?, rest.len()))
}

/// The lengths of both parts, after writing them.
#[function]
pub fn parts(frame: &mut [u8; 6], n: usize, m: usize) -> usize {
    if let Some((left, right)) = frame[1..].split_at_mut_checked(n & 7) {
        for x in left.iter_mut() {
            *x = x.wrapping_add(1);
        }
        right.reverse();
    }
    let whole: &[u8] = frame;
    let (a, b) = whole.split_at_checked(m).unwrap_or((&[], &[]));
    let (c, d) = frame.split_at(2);
    a.len() * 100 + b.len() + c.len() * 1000 + d.len()
}
