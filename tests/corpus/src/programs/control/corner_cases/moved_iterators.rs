//! Authors' own iterators by value: a loop iterates over its own copy and leaves the original unchanged. Also the
//! evaluation order of zipped iterators.

use bessemer::prelude::*;

/// Counts up to an end.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct Count {
    at: u32,
    end: u32,
}

#[data]
impl Iterator for Count {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        if self.at >= self.end {
            return None;
        }
        self.at += 1;
        Some(self.at)
    }
}

/// Owns an iterator.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct Keep {
    it: Count,
    other: Option<Count>,
    changes: u32,
}

#[data]
impl Keep {
    /// The values of its iterator; reading them changes it.
    pub fn values(&mut self) -> [u32; 3] {
        self.changes = self.changes.wrapping_mul(3).wrapping_add(1);
        [self.changes, self.it.at, 7]
    }

    /// An iterator that begins with a changed value.
    pub fn made(&mut self) -> Count {
        self.changes = self.changes.wrapping_mul(5) ^ 2;
        Count { at: self.changes & 7, end: 20 }
    }

    /// Iterates over clones, since `self` is immutable.
    pub fn looked(&self) -> u32 {
        let first = match self.other.clone() {
            Some(it) => it.take(2).fold(0, |a, b| a ^ b),
            None => 3,
        };
        let Some(it) = self.other.clone() else { return first };
        let second = it.take(3).fold(1_u32, u32::wrapping_mul);
        let third = if let Some(it) = self.other.clone() { it.take(1).count() } else { 0 };
        let (it, n) = (self.it.clone(), self.changes);
        let fourth = it.take(2).fold(n, u32::wrapping_add);
        let by = self.other.clone().map_or(5, |it| it.take(2).fold(0, u32::wrapping_add));
        first ^ second ^ third as u32 ^ fourth ^ by
    }
}

/// Returns a `Keep` for the other functions.
#[function]
fn kept(n: u32) -> Keep {
    Keep { it: Count { at: n & 3, end: 9 }, other: (n & 4 > 0).then_some(Count { at: n & 7, end: 12 }), changes: n }
}

/// Closures that take iterators by value.
#[function]
pub fn closures(a: u32) -> [u32; 4] {
    let it = Count { at: 0, end: a & 15 };
    let total = |it: Count| it.take(3).fold(0, |sum, x| sum + x);
    let first = total(it.clone());
    let mut keep = Keep { it: it.clone(), other: None, changes: a };
    let through = |k: Keep| k.it.take(2).fold(k.changes, u32::wrapping_add);
    let second = through(keep.clone());
    keep.it.next();
    let third = through(keep.clone());
    [first, total(it), second ^ third, keep.it.at]
}

/// A closure that advances an iterator by reference.
#[function]
pub fn moved_on(p: &mut Count) -> u32 {
    let f = |it: Count| it.take(2).fold(0_u32, u32::wrapping_add);
    let before = f(p.clone());
    p.next();
    before.wrapping_mul(31).wrapping_add(f(p.clone()))
}

/// The first operand of `zip` is evaluated first.
#[function]
pub fn side_by_side(n: u32, mut v: [u32; 3]) -> [u32; 3] {
    let mut k = Keep { it: Count { at: n & 3, end: 9 }, other: None, changes: n };
    let mut first = 0_u32;
    for (x, y) in k.values().into_iter().zip(k.made()) {
        first = first.wrapping_mul(3).wrapping_add(x ^ y);
    }
    let change = |v: &mut [u32; 3]| {
        v[0] = v[0].wrapping_add(9);
        Count { at: v[0] & 3, end: 6 }
    };
    let mut second = 0_u32;
    for (x, y) in v.into_iter().zip(change(&mut v)) {
        second = second.wrapping_mul(7).wrapping_add(x ^ y);
    }
    let mut m = n & 3;
    let mut third = 0_u32;
    for (x, y) in (0..m).zip({
        m = 9;
        Count { at: m, end: 14 }
    }) {
        third = third.wrapping_mul(5).wrapping_add(x ^ y);
    }
    [first, second ^ v[0], third ^ m]
}

/// An iterator with inherent methods that have priority over those of `Iterator`.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct Cursor {
    n: u32,
}

#[data]
impl Iterator for Cursor {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        self.n = self.n.wrapping_add(1);
        Some(self.n)
    }
}

#[data]
impl Cursor {
    /// Returns the number and advances by seven.
    pub fn next(&mut self) -> Option<u32> {
        self.n = self.n.wrapping_add(7);
        Some(self.n)
    }

    /// The current position.
    pub fn position(&self) -> usize {
        self.n as usize
    }
}

/// Calls of inherent methods and of the iterator's.
#[function]
pub fn cursors(n: u32) -> (Option<u32>, usize, u32, Option<u32>) {
    let mut cursor = Cursor { n };
    let own = cursor.next();
    let at = cursor.position();
    let sum = cursor.by_ref().take(2).fold(0, |a, b| a ^ b);
    (own, at, sum, cursor.nth(1))
}

/// Iterators inside the closures of other iterators.
#[function]
pub fn within(values: &[u32; 4], n: u32) -> (u32, [u32; 2]) {
    let mut it = Count { at: n & 7, end: 9 };
    let sum = values.iter().map(|x| x ^ it.next().unwrap_or(4)).fold(0, |a, b| a ^ b);
    (sum, core::array::from_fn(|_| it.next().unwrap_or(1)))
}

/// An iterator that is a function's last expression.
#[function]
pub fn items(n: u32) -> impl Iterator<Item = u32> {
    Count { at: 0, end: n }.take(4)
}

/// Iterates over that, with an owned iterator.
#[function]
pub fn given(n: u32) -> (u32, u32) {
    let mut sum = 0_u32;
    for x in items(n & 15) {
        sum += x;
    }
    (sum, kept(n).looked())
}

/// An iterator parameter by value, and a named clone of it.
#[function]
pub fn again(it: Count) -> (u32, u32) {
    let first = match it.clone() {
        other => other.take(2).fold(0_u32, u32::wrapping_add),
    };
    let Keep { it: inner, .. } = (Keep { it: it.clone(), other: None, changes: 0 });
    (first ^ inner.take(1).fold(0, |a, b| a ^ b), it.take(2).fold(1_u32, u32::wrapping_mul))
}
