//! Implicit operations of Rust on a value, implemented explicitly: its copy, its order, its drop, its borrows.

use core::cmp::Ordering;
use core::ops::Deref;

use bessemer::prelude::*;

/// A counter whose copy is another.
#[data]
#[derive(Copy)]
pub struct Counter {
    /// Number of occurrences.
    pub count: i32,
}

impl Clone for Counter {
    fn clone(&self) -> Counter {
        Counter { count: self.count + 1 }
    }
}

/// A rank whose greatest comes first.
#[data]
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd)]
pub struct Rank {
    /// The number.
    pub number: i32,
}

impl Ord for Rank {
    fn cmp(&self, other: &Rank) -> Ordering {
        other.number.cmp(&self.number)
    }
}

/// A value that notes its drop.
#[data]
pub struct Noted<'a> {
    /// The notes.
    pub notes: &'a mut [i32],
}

impl Drop for Noted<'_> {
    fn drop(&mut self) {
        self.notes[0] += 1;
    }
}

/// A wrapper that dereferences to its content.
#[data]
#[derive(Clone, Copy)]
pub struct Wrapper {
    /// The number.
    pub inner: f64,
}

impl Deref for Wrapper {
    type Target = f64;

    fn deref(&self) -> &f64 {
        &self.inner
    }
}

/// One more.
#[function]
pub fn one_more(wrapper: &Wrapper) -> f64 {
    **wrapper + 1.0
}

/// The next.
#[function]
pub fn next(counter: Counter) -> Counter {
    counter.clone()
}

/// Order of two ranks.
#[function]
pub fn before(one: Rank, other: Rank) -> bool {
    one.cmp(&other) == Ordering::Less
}

/// The first note.
#[function]
pub fn first(notes: &mut [i32; 3]) -> i32 {
    let noted = Noted { notes };
    noted.notes[0]
}
