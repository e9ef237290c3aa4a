//! Compares consumers with core's on elements that are equal but distinguishable.
//!
//! All short sequences of few keys are tested, by value, by `&` and by `&mut`.

use core::cmp::Ordering;

use super::*;
extern crate std;
use std::vec::Vec;

/// An element that is compared by its key only.
#[derive(Clone, Copy, Debug)]
struct Keyed {
    key: u8,
    number: usize,
}

impl PartialEq for Keyed {
    fn eq(&self, other: &Keyed) -> bool {
        self.key == other.key
    }
}

impl Eq for Keyed {}

impl PartialOrd for Keyed {
    fn partial_cmp(&self, other: &Keyed) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Keyed {
    fn cmp(&self, other: &Keyed) -> Ordering {
        self.key.cmp(&other.key)
    }
}

/// Returns all sequences of up to `most` elements with `keys` keys.
fn sequences(most: usize, keys: u8) -> Vec<Vec<Keyed>> {
    let mut all: Vec<Vec<Keyed>> = std::vec![Vec::new()];
    let mut from = 0;
    for number in 0..most {
        let until = all.len();
        for at in from..until {
            for key in 0..keys {
                let mut longer = all[at].clone();
                longer.push(Keyed { key, number });
                all.push(longer);
            }
        }
        from = until;
    }
    all
}

/// Compares a consumer with core's: the returned element, and the calls of its closure.
macro_rules! held {
    ($all:expr; $($name:ident($($f:expr)?);)*) => {$(
        for all in $all {
            let told = |it: Option<usize>, calls: Vec<(usize, usize)>| (it, calls);
            let mut mine = Vec::new();
            let mut core = Vec::new();
            macro_rules! compared {
                ($items:expr, $core:expr) => {{
                    mine.clear();
                    core.clear();
                    let given = $name($items $(, $f(&mut mine))?).map(|it| it.number);
                    let expected = $core.$name($($f(&mut core))?).map(|it| it.number);
                    let (mine, core) = (told(given, mine.clone()), told(expected, core.clone()));
                    assert_eq!(mine, core, "{} of {all:?}", stringify!($name));
                }};
            }
            let (mut one, mut other) = (all.clone(), all.clone());
            compared!(all.iter().copied(), all.iter().copied());
            compared!(all.iter(), all.iter());
            compared!(one.iter_mut(), other.iter_mut());
            compared!(all.iter().rev(), all.iter().rev());
        }
    )*};
}

/// Returns a comparison that records its arguments.
fn by<T: core::borrow::Borrow<Keyed>>(
    calls: &mut Vec<(usize, usize)>,
) -> impl FnMut(&T, &T) -> Ordering {
    |one, other| {
        let (one, other): (&Keyed, &Keyed) = (one.borrow(), other.borrow());
        calls.push((one.number, other.number));
        one.key.cmp(&other.key)
    }
}

/// Returns a key function that records its argument.
fn key<T: core::borrow::Borrow<Keyed>>(calls: &mut Vec<(usize, usize)>) -> impl FnMut(&T) -> u8 {
    |it| {
        let it: &Keyed = it.borrow();
        calls.push((it.number, 0));
        it.key
    }
}

/// Returns a condition that records its argument.
fn above<T: core::borrow::Borrow<Keyed>>(
    calls: &mut Vec<(usize, usize)>,
) -> impl FnMut(&T) -> bool {
    |it| {
        let it: &Keyed = it.borrow();
        calls.push((it.number, 1));
        it.key > 0
    }
}

/// Returns a comparison for the greatest element that records its arguments.
fn chosen<T: core::borrow::Borrow<Keyed>>(
    calls: &mut Vec<(usize, usize)>,
) -> impl FnMut(T, T) -> T {
    |one, other| {
        calls.push((one.borrow().number, other.borrow().number));
        if other.borrow().key >= one.borrow().key { other } else { one }
    }
}

#[test]
#[allow(clippy::iter_skip_next)]
fn each_end_gives_the_one_of_equals_that_core_gives() {
    let all = sequences(5, 3);
    held! { &all;
        max();
        min();
        max_by(by);
        min_by(by);
        max_by_key(key);
        min_by_key(key);
        last();
        find(above);
        reduce(chosen);
    }
    for all in &all {
        for n in 0..=all.len() {
            let number = |it: Option<Keyed>| it.map(|it| it.number);
            let items = || all.iter().copied();
            assert_eq!(number(nth(items(), n)), number(items().nth(n)));
            assert_eq!(number(next(items().skip(n))), number(items().skip(n).next()));
            assert_eq!(position(items(), |it| it.key == 1), items().position(|it| it.key == 1));
            assert_eq!(rposition(items(), |it| it.key == 1), items().rposition(|it| it.key == 1));
        }
    }
}
