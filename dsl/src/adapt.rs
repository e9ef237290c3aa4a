//! Iterator adapters as functions of the DSL that are expanded where they are iterated: each passes its items to
//! `__each`.
//!
//! Invariants: nothing stands behind `__each` in its pass, since what goes through the items may go on with the next there.
//!
//! Must not know: where the items come from, or what becomes of them.

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

/// Those that are as `keep` asks.
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

/// Those before the first that is not as `keep` asks.
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

/// Those from the first on that is not as `skip` asks.
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

/// All but the first `n`.
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

/// The first `n`.
#[function(expand)]
pub fn take<T>(mut items: impl Iterator<Item = T>, n: usize, mut __each: impl FnMut(T)) {
    for _ in 0..n {
        let Some(item) = items.next() else { break };
        __each(item);
    }
}

/// Each with that of the others in its place.
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

/// The first, and each that comes `step` behind one of them.
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

/// Shows each to `f`.
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

/// The values behind references.
#[function(expand)]
pub fn copied<T: Copy + 'static>(
    items: impl Iterator<Item = &'static T>,
    mut __each: impl FnMut(T),
) {
    for item in items {
        __each(*item);
    }
}

/// Each with how many came before it.
#[function(expand)]
pub fn enumerate<T>(items: impl Iterator<Item = T>, mut __each: impl FnMut((usize, T))) {
    for (i, item) in items.into_iter().enumerate() {
        __each((i, item));
    }
}

/// From the last on.
#[function(expand)]
pub fn rev<T>(items: impl DoubleEndedIterator<Item = T>, mut __each: impl FnMut(T)) {
    for item in items.into_iter().rev() {
        __each(item);
    }
}

/// All that `f` makes of each.
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

/// All that is in each.
#[function(expand)]
pub fn flatten<T: Of<V>, V>(items: impl Iterator<Item = T>, mut __each: impl FnMut(V)) {
    for item in items {
        for part in item {
            __each(part);
        }
    }
}

/// All of one, then all of the other.
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
    }
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
