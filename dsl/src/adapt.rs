//! Iterator adapters as functions of the DSL that are inlined where they are iterated: each passes its items to
//! `__each`.
//!
//! Invariant: no statement follows `__each` in its pass, since the consumer may continue with the next pass there.
//!
//! Must not know: the source of the items, or their consumer.

use crate::function;

/// Sequence whose items have the type `V`.
pub trait Of<V>: IntoIterator<Item = V> {}

impl<V, T: IntoIterator<Item = V>> Of<V> for T {}

/// Applies `f` to each item.
#[function(expand)]
pub fn map<T, U>(
    items: impl Iterator<Item = T>,
    mut f: impl FnMut(T) -> U,
    mut __each: impl FnMut(U),
) {
    for item in items {
        __each(f(item));
    }
}

/// Keeps the items for which `keep` is true.
#[function(expand)]
pub fn filter<T>(
    items: impl Iterator<Item = T>,
    mut keep: impl FnMut(&T) -> bool,
    mut __each: impl FnMut(T),
) {
    for item in items {
        if keep(&item) {
            __each(item);
        }
    }
}

/// Applies `f` to each item and keeps the results that are `Some`.
#[function(expand)]
pub fn filter_map<T, U>(
    items: impl Iterator<Item = T>,
    mut f: impl FnMut(T) -> Option<U>,
    mut __each: impl FnMut(U),
) {
    for item in items {
        if let Some(value) = f(item) {
            __each(value);
        }
    }
}

/// Applies `f` to each item up to the first result that is `None`.
#[function(expand)]
pub fn map_while<T, U>(
    items: impl Iterator<Item = T>,
    mut f: impl FnMut(T) -> Option<U>,
    mut __each: impl FnMut(U),
) {
    for item in items {
        if let Some(value) = f(item) {
            __each(value);
        } else {
            break;
        }
    }
}

/// Keeps the items before the first for which `keep` is false.
#[function(expand)]
pub fn take_while<T>(
    items: impl Iterator<Item = T>,
    mut keep: impl FnMut(&T) -> bool,
    mut __each: impl FnMut(T),
) {
    for item in items {
        if !keep(&item) {
            break;
        }
        __each(item);
    }
}

/// Drops the items before the first for which `skip` is false.
#[function(expand)]
pub fn skip_while<T>(
    items: impl Iterator<Item = T>,
    mut skip: impl FnMut(&T) -> bool,
    mut __each: impl FnMut(T),
) {
    let mut skipping = true;
    for item in items {
        if skipping {
            skipping = skip(&item);
        }
        if !skipping {
            __each(item);
        }
    }
}

/// Drops the first `n` items.
#[function(expand)]
pub fn skip<T>(items: impl Iterator<Item = T>, n: usize, mut __each: impl FnMut(T)) {
    let mut left = n;
    for item in items {
        if left > 0 {
            left -= 1;
        } else {
            __each(item);
        }
    }
}

/// Keeps the first `n` items.
#[function(expand)]
pub fn take<T>(mut items: impl Iterator<Item = T>, n: usize, mut __each: impl FnMut(T)) {
    for _ in 0..n {
        let Some(item) = items.next() else { break };
        __each(item);
    }
}

/// Pairs each item with the other iterator's item at the same position.
#[function(expand)]
pub fn zip<T, U>(
    items: impl Iterator<Item = T>,
    mut others: impl Iterator<Item = U>,
    mut __each: impl FnMut((T, U)),
) {
    for item in items {
        let Some(other) = others.next() else { break };
        __each((item, other));
    }
}

/// Keeps the first item, and every `step`th after it.
#[function(expand)]
pub fn step_by<T>(items: impl Iterator<Item = T>, step: usize, mut __each: impl FnMut(T)) {
    assert!(step != 0);
    let between = step - 1;
    let mut left = 0_usize;
    for item in items {
        if left > 0 {
            left -= 1;
        } else {
            left = between;
            __each(item);
        }
    }
}

/// Applies `f` to a state and each item up to the first result that is `None`.
#[function(expand)]
pub fn scan<T, S, U>(
    items: impl Iterator<Item = T>,
    start: S,
    mut f: impl FnMut(&mut S, T) -> Option<U>,
    mut __each: impl FnMut(U),
) {
    let mut state = start;
    for item in items {
        if let Some(value) = f(&mut state, item) {
            __each(value);
        } else {
            break;
        }
    }
}

/// Calls `f` with a reference to each item.
#[function(expand)]
pub fn inspect<T>(
    items: impl Iterator<Item = T>,
    mut f: impl FnMut(&T),
    mut __each: impl FnMut(T),
) {
    for item in items {
        f(&item);
        __each(item);
    }
}

/// Copies the values behind references.
#[function(expand)]
pub fn copied<T: Copy + 'static>(
    items: impl Iterator<Item = &'static T>,
    mut __each: impl FnMut(T),
) {
    for item in items {
        __each(*item);
    }
}

/// Pairs each item with the number of items before it.
#[function(expand)]
pub fn enumerate<T>(items: impl Iterator<Item = T>, mut __each: impl FnMut((usize, T))) {
    for (i, item) in items.into_iter().enumerate() {
        __each((i, item));
    }
}

/// Yields the items from the last to the first.
#[function(expand)]
pub fn rev<T>(items: impl DoubleEndedIterator<Item = T>, mut __each: impl FnMut(T)) {
    for item in items.into_iter().rev() {
        __each(item);
    }
}

/// Yields all items of each result of `f`.
#[function(expand)]
pub fn flat_map<T, U: Of<V>, V>(
    items: impl Iterator<Item = T>,
    mut f: impl FnMut(T) -> U,
    mut __each: impl FnMut(V),
) {
    for item in items {
        for part in f(item) {
            __each(part);
        }
    }
}

/// Yields all items of each item.
#[function(expand)]
pub fn flatten<T: Of<V>, V>(items: impl Iterator<Item = T>, mut __each: impl FnMut(V)) {
    for item in items {
        for part in item {
            __each(part);
        }
    }
}

/// Yields each result of `f` up to the first that is `None`.
#[function(expand)]
pub fn from_fn<T>(mut f: impl FnMut() -> Option<T>, mut __each: impl FnMut(T)) {
    for _ in 0_u64..18_446_744_073_709_551_615 {
        if let Some(item) = f() {
            __each(item);
        } else {
            break;
        }
    }
}

/// Yields the first value, and then each result of `f` for the value before, up to the first that is `None`.
#[function(expand)]
pub fn successors<T>(
    first: Option<T>,
    mut f: impl FnMut(&T) -> Option<T>,
    mut __each: impl FnMut(T),
) {
    let mut next = first;
    for _ in 0_u64..18_446_744_073_709_551_615 {
        if let Some(item) = next {
            next = f(&item);
            __each(item);
        } else {
            break;
        }
    }
}

/// Yields all items of one iterator, then of the other.
#[function(expand)]
pub fn chain<T>(
    items: impl Iterator<Item = T>,
    others: impl Iterator<Item = T>,
    mut __each: impl FnMut(T),
) {
    #[allow(unused_labels)]
    'chain: {
        for item in items {
            __each(item);
        }
        for item in others {
            __each(item);
        }
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    extern crate std;
    use std::vec::Vec;

    /// Returns the items passed on.
    fn handed<T>(through: impl FnOnce(&mut dyn FnMut(T))) -> Vec<T> {
        let mut all = Vec::new();
        through(&mut |item| all.push(item));
        all
    }

    #[test]
    fn each_gives_what_core_gives() {
        static VALUES: [u8; 7] = [3, 9, 4, 9, 1, 4, 7];
        for length in 0..=VALUES.len() {
            let part = &VALUES[..length];
            let items = || part.iter().copied();
            let twice = |x: u8| [x; 2];
            let rows = || items().map(twice);
            let core: Vec<_> = items().map(|x| x ^ 5).collect();
            assert_eq!(handed(|each| map(items(), |x| x ^ 5, each)), core);
            assert_eq!(handed(|each| copied(part.iter(), each)), items().collect::<Vec<_>>());
            assert_eq!(handed(|each| rev(items(), each)), items().rev().collect::<Vec<_>>());
            let core: Vec<_> = items().enumerate().collect();
            assert_eq!(handed(|each| enumerate(items(), each)), core);
            let core: Vec<_> = items().flat_map(twice).collect();
            assert_eq!(handed(|each| flat_map(items(), twice, each)), core);
            assert_eq!(handed(|each| flatten(rows(), each)), core);
            let core: Vec<_> = items().chain(items().rev()).collect();
            assert_eq!(handed(|each| chain(items(), items().rev(), each)), core);
            for limit in 0..10 {
                let above = |x: &u8| *x > limit;
                let some = |x: u8| (x > limit).then_some(x ^ 1);
                let core: Vec<_> = items().filter(above).collect();
                assert_eq!(handed(|each| filter(items(), above, each)), core);
                let core: Vec<_> = items().take_while(above).collect();
                assert_eq!(handed(|each| take_while(items(), above, each)), core);
                let n = usize::from(limit);
                let core: Vec<_> = items().skip(n).collect();
                assert_eq!(handed(|each| skip(items(), n, each)), core);
                let core: Vec<_> = items().take(n).collect();
                assert_eq!(handed(|each| take(items(), n, each)), core);
                let core: Vec<_> = items().zip(items().skip(n)).collect();
                assert_eq!(handed(|each| zip(items(), items().skip(n), each)), core);
                let core: Vec<_> = items().step_by(n + 1).collect();
                assert_eq!(handed(|each| step_by(items(), n + 1, each)), core);
                let core: Vec<_> = items().skip_while(above).collect();
                assert_eq!(handed(|each| skip_while(items(), above, each)), core);
                let core: Vec<_> = items().filter_map(some).collect();
                assert_eq!(handed(|each| filter_map(items(), some, each)), core);
                let core: Vec<_> = items().map_while(some).collect();
                assert_eq!(handed(|each| map_while(items(), some, each)), core);
                let state = |so_far: &mut u8, x: u8| {
                    *so_far ^= x;
                    (x > limit).then_some(*so_far)
                };
                let core: Vec<_> = items().scan(limit, state).collect();
                assert_eq!(handed(|each| scan(items(), limit, state, each)), core);
                let mut seen = Vec::new();
                assert_eq!(handed(|each| inspect(items(), |x| seen.push(*x), each)), seen);
            }
        }
    }
}
