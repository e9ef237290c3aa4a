//! Iterator consumers as functions of the DSL that are inlined at each call: each is one loop.
//!
//! Must not know: the source of the items, or the adapters of the chain.

use core::cmp::Ordering;

use crate::function;

/// Number of items.
#[function(expand)]
pub fn count<T>(items: impl Iterator<Item = T>) -> usize {
    let mut count = 0_usize;
    for _ in items {
        count += 1;
    }
    count
}

/// Folds all items with `f`.
#[function(expand)]
pub fn fold<T, A>(items: impl Iterator<Item = T>, start: A, mut f: impl FnMut(A, T) -> A) -> A {
    let mut gathered = start;
    for value in items {
        gathered = f(gathered, value);
    }
    gathered
}

/// Returns true if `f` is true for an item.
#[function(expand)]
pub fn any<T>(items: impl Iterator<Item = T>, mut f: impl FnMut(T) -> bool) -> bool {
    let mut found = false;
    for item in items {
        if f(item) {
            found = true;
            break;
        }
    }
    found
}

/// Returns true if `f` is true for all items.
#[function(expand)]
pub fn all<T>(items: impl Iterator<Item = T>, mut f: impl FnMut(T) -> bool) -> bool {
    let mut every = true;
    for item in items {
        if !f(item) {
            every = false;
            break;
        }
    }
    every
}

/// Returns the first item for which `f` is true.
#[function(expand)]
pub fn find<T>(items: impl Iterator<Item = T>, mut f: impl FnMut(&T) -> bool) -> Option<T> {
    let mut find = None;
    for item in items {
        if f(&item) {
            find = Some(item);
            break;
        }
    }
    find
}

/// First result of `f` that is `Some`.
#[function(expand)]
pub fn find_map<T, U>(
    items: impl Iterator<Item = T>,
    mut f: impl FnMut(T) -> Option<U>,
) -> Option<U> {
    let mut found = None;
    for item in items {
        found = f(item);
        if found.is_some() {
            break;
        }
    }
    found
}

/// Returns the last item.
#[function(expand)]
pub fn last<T>(items: impl Iterator<Item = T>) -> Option<T> {
    let mut last = None;
    for value in items {
        last = Some(value);
    }
    last
}

/// Returns the first item.
#[function(expand)]
pub fn next<T>(items: impl Iterator<Item = T>) -> Option<T> {
    let mut next = None;
    #[allow(clippy::never_loop)]
    for value in items {
        next = Some(value);
        break;
    }
    next
}

/// Returns the last of the items that are left, and leaves those before it.
#[function(expand)]
pub fn next_back<T>(items: impl DoubleEndedIterator<Item = T>) -> Option<T> {
    let mut next_back = None;
    #[allow(clippy::never_loop)]
    for value in items.into_iter().rev() {
        next_back = Some(value);
        break;
    }
    next_back
}

/// Returns the number of items that are left. The generator computes it without the items.
#[function(expand)]
pub fn len<T>(items: impl Iterator<Item = T>) -> usize {
    let mut len = 0_usize;
    for _ in items {
        len += 1;
    }
    len
}

/// Returns the item after `n` others.
#[function(expand)]
pub fn nth<T>(items: impl Iterator<Item = T>, n: usize) -> Option<T> {
    let mut left = n;
    let mut nth = None;
    for value in items {
        if left == 0 {
            nth = Some(value);
            break;
        }
        left -= 1;
    }
    nth
}

/// Index of the first item that satisfies `f`.
#[function(expand)]
pub fn position<T>(items: impl Iterator<Item = T>, mut f: impl FnMut(T) -> bool) -> Option<usize> {
    let mut position = None;
    for (i, item) in items.into_iter().enumerate() {
        if f(item) {
            position = Some(i);
            break;
        }
    }
    position
}

/// Index of the last item that satisfies `f`.
#[function(expand)]
pub fn rposition<T>(
    items: impl DoubleEndedIterator<Item = T> + ExactSizeIterator,
    mut f: impl FnMut(T) -> bool,
) -> Option<usize> {
    let mut rposition = None;
    for (i, item) in items.into_iter().enumerate().rev() {
        if f(item) {
            rposition = Some(i);
            break;
        }
    }
    rposition
}

/// Returns the greatest; of equal ones the last.
#[function(expand)]
pub fn max<T: PartialOrd>(items: impl Iterator<Item = T>) -> Option<T> {
    let mut max = None;
    for value in items {
        if let Some(best) = &max {
            if value >= *best {
                max = Some(value);
            }
        } else {
            max = Some(value);
        }
    }
    max
}

/// Returns the least; of equal ones the first.
#[function(expand)]
pub fn min<T: PartialOrd>(items: impl Iterator<Item = T>) -> Option<T> {
    let mut min = None;
    for value in items {
        if let Some(best) = &min {
            if value < *best {
                min = Some(value);
            }
        } else {
            min = Some(value);
        }
    }
    min
}

/// Returns the greatest item by `compare`; of equal ones the last.
#[function(expand)]
pub fn max_by<T>(
    items: impl Iterator<Item = T>,
    mut compare: impl FnMut(&T, &T) -> Ordering,
) -> Option<T> {
    let mut found = None;
    for value in items {
        if let Some(best) = &found {
            if compare(best, &value).is_le() {
                found = Some(value);
            }
        } else {
            found = Some(value);
        }
    }
    found
}

/// Returns the least item by `compare`; of equal ones the first.
#[function(expand)]
pub fn min_by<T>(
    items: impl Iterator<Item = T>,
    mut compare: impl FnMut(&T, &T) -> Ordering,
) -> Option<T> {
    let mut found = None;
    for value in items {
        if let Some(best) = &found {
            if compare(best, &value).is_gt() {
                found = Some(value);
            }
        } else {
            found = Some(value);
        }
    }
    found
}

/// Returns the item with the greatest key; of equal ones the last.
#[function(expand)]
pub fn max_by_key<T, K: PartialOrd>(
    items: impl Iterator<Item = T>,
    mut f: impl FnMut(&T) -> K,
) -> Option<T> {
    let mut found = None;
    let mut largest = None;
    for value in items {
        let key = f(&value);
        if let Some(best) = &largest {
            if key >= *best {
                largest = Some(key);
                found = Some(value);
            }
        } else {
            largest = Some(key);
            found = Some(value);
        }
    }
    found
}

/// Returns the item with the least key; of equal ones the first.
#[function(expand)]
pub fn min_by_key<T, K: PartialOrd>(
    items: impl Iterator<Item = T>,
    mut f: impl FnMut(&T) -> K,
) -> Option<T> {
    let mut found = None;
    let mut least = None;
    for value in items {
        let key = f(&value);
        if let Some(best) = &least {
            if key < *best {
                least = Some(key);
                found = Some(value);
            }
        } else {
            least = Some(key);
            found = Some(value);
        }
    }
    found
}

/// Calls `f` with each item.
#[function(expand)]
pub fn for_each<T>(items: impl Iterator<Item = T>, mut f: impl FnMut(T)) {
    for item in items {
        f(item);
    }
}

/// Calls `f` with each item, up to the first result that is `None`.
#[function(expand)]
pub fn try_for_each_some<T>(
    items: impl Iterator<Item = T>,
    mut f: impl FnMut(T) -> Option<()>,
) -> Option<()> {
    let mut done = Some(());
    for item in items {
        done = f(item);
        if done.is_none() {
            break;
        }
    }
    done
}

/// Calls `f` with each item, up to the first error.
///
/// # Errors
///
/// The first error of `f`.
#[function(expand)]
pub fn try_for_each_ok<T, E>(
    items: impl Iterator<Item = T>,
    mut f: impl FnMut(T) -> Result<(), E>,
) -> Result<(), E> {
    let mut done = Ok(());
    for item in items {
        done = f(item);
        if done.is_err() {
            break;
        }
    }
    done
}

/// Folds the items with `f`, beginning with the first.
#[function(expand)]
pub fn reduce<T>(items: impl Iterator<Item = T>, mut f: impl FnMut(T, T) -> T) -> Option<T> {
    let mut reduced = None;
    for item in items {
        reduced = Some(match reduced {
            Some(before) => f(before, item),
            None => item,
        });
    }
    reduced
}

/// Returns true if both sequences have the same length and equal items.
#[function(expand)]
pub fn eq<T: PartialEq<U>, U>(
    items: impl Iterator<Item = T>,
    others: impl Iterator<Item = U>,
) -> bool {
    equal_items(items, others)
}

/// Returns true if each item equals the other one in its place, and their numbers are equal. Where Rust knows both numbers,
/// it compares these first.
#[function(expand)]
pub fn equal_items<T: PartialEq<U>, U>(
    items: impl Iterator<Item = T>,
    mut others: impl Iterator<Item = U>,
) -> bool {
    let mut same = true;
    for item in items {
        same = others.next().is_some_and(|other| item == other);
        if !same {
            break;
        }
    }
    same && others.next().is_none()
}

/// Returns true if the sequences differ in length or in an item.
#[function(expand)]
pub fn ne<T: PartialEq<U>, U>(
    items: impl Iterator<Item = T>,
    others: impl Iterator<Item = U>,
) -> bool {
    !eq(items, others)
}

/// Lexicographic order of two sequences: the first difference decides, or else the length.
#[function(expand)]
pub fn cmp<T: PartialOrd>(
    items: impl Iterator<Item = T>,
    mut others: impl Iterator<Item = T>,
) -> Ordering {
    let mut order = Ordering::Equal;
    for item in items {
        order = Ordering::Greater;
        if let Some(other) = others.next() {
            if item < other {
                order = Ordering::Less;
            } else if item == other {
                order = Ordering::Equal;
            }
        }
        if order != Ordering::Equal {
            break;
        }
    }
    if order == Ordering::Equal && others.next().is_some() {
        order = Ordering::Less;
    }
    order
}

/// Returns true if the first sequence is less than the second.
#[function(expand)]
pub fn lt<T: PartialOrd<U>, U>(
    items: impl Iterator<Item = T>,
    mut others: impl Iterator<Item = U>,
) -> bool {
    let (mut less, mut same) = (false, true);
    for item in items {
        same = false;
        if let Some(other) = others.next() {
            less = item < other;
            same = item == other;
        }
        if !same {
            break;
        }
    }
    less || same && others.next().is_some()
}

/// Returns true if the first sequence is less than the second, or equal.
#[function(expand)]
pub fn le<T: PartialOrd<U>, U>(
    items: impl Iterator<Item = T>,
    mut others: impl Iterator<Item = U>,
) -> bool {
    let (mut less, mut same) = (false, true);
    for item in items {
        same = false;
        if let Some(other) = others.next() {
            less = item < other;
            same = item == other;
        }
        if !same {
            break;
        }
    }
    // Rust asks for one more of the others.
    let more = same && others.next().is_some();
    less || more || same
}

/// Returns true if the first sequence is greater than the second.
#[function(expand)]
pub fn gt<T: PartialOrd<U>, U>(
    items: impl Iterator<Item = T>,
    mut others: impl Iterator<Item = U>,
) -> bool {
    let (mut greater, mut same) = (false, true);
    for item in items {
        greater = true;
        same = false;
        if let Some(other) = others.next() {
            greater = item > other;
            same = item == other;
        }
        if !same {
            break;
        }
    }
    // Rust asks for one more of the others.
    let more = same && others.next().is_some();
    greater && !more
}

/// Returns true if the first sequence is greater than the second, or equal.
#[function(expand)]
pub fn ge<T: PartialOrd<U>, U>(
    items: impl Iterator<Item = T>,
    mut others: impl Iterator<Item = U>,
) -> bool {
    let (mut greater, mut same) = (false, true);
    for item in items {
        greater = true;
        same = false;
        if let Some(other) = others.next() {
            greater = item > other;
            same = item == other;
        }
        if !same {
            break;
        }
    }
    greater || same && others.next().is_none()
}

#[cfg(test)]
mod equal;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_gives_what_core_gives() {
        let values = [3_u8, 9, 4, 9, 1, 4, 7];
        for length in 0..=values.len() {
            let part = &values[..length];
            let items = || part.iter().copied();
            assert_eq!(count(items()), items().count());
            assert_eq!(last(items()), items().last());
            assert_eq!(next(items()), items().next());
            assert_eq!(max(items()), items().max());
            assert_eq!(min(items()), items().min());
            let places = || items().enumerate();
            let by = |a: &(usize, u8), b: &(usize, u8)| a.1.cmp(&b.1);
            assert_eq!(max_by(places(), by), places().max_by(by));
            assert_eq!(min_by(places(), by), places().min_by(by));
            let key = |it: &(usize, u8)| it.1 % 4;
            assert_eq!(max_by_key(places(), key), places().max_by_key(key));
            assert_eq!(min_by_key(places(), key), places().min_by_key(key));
            let joined = |so_far: u8, x: u8| so_far.wrapping_mul(5).wrapping_add(x);
            assert_eq!(fold(items(), 2, joined), items().fold(2, joined));
            assert_eq!(reduce(items(), joined), items().reduce(joined));
            let (mut seen, mut expected) = (0, 0);
            for_each(items(), |x| seen = joined(seen, x));
            items().for_each(|x| expected = joined(expected, x));
            assert_eq!(seen, expected);
            for other in 0..=values.len() {
                let others = || values[..other].iter().map(|x| x & 11);
                assert_eq!(eq(items(), others()), items().eq(others()));
                assert_eq!(ne(items(), others()), items().ne(others()));
                assert_eq!(cmp(items(), others()), items().cmp(others()));
                let halves = [2.0, f64::NAN, 4.5, -0.0, 1.5, 2.0, f64::NAN];
                let halves = || items().zip(halves).map(|(x, half)| half * f64::from(x % 3));
                let whole = || others().map(f64::from);
                assert_eq!(lt(halves(), whole()), halves().lt(whole()));
                assert_eq!(le(halves(), whole()), halves().le(whole()));
                assert_eq!(gt(halves(), whole()), halves().gt(whole()));
                assert_eq!(ge(halves(), whole()), halves().ge(whole()));
                assert_eq!(lt(items(), others()), items().lt(others()));
                assert_eq!(le(items(), others()), items().le(others()));
                assert_eq!(gt(items(), others()), items().gt(others()));
                assert_eq!(ge(items(), others()), items().ge(others()));
            }
            for limit in 0..10 {
                let above = |x: u8| x > limit;
                assert_eq!(any(items(), above), items().any(above));
                assert_eq!(all(items(), above), items().all(above));
                assert_eq!(find(items(), |x| above(*x)), items().find(|x| above(*x)));
                let half = |x: u8| above(x).then_some(x / 2);
                assert_eq!(find_map(items(), half), items().find_map(half));
                assert_eq!(position(items(), above), items().position(above));
                assert_eq!(rposition(items(), above), items().rposition(above));
                let n = usize::from(limit);
                assert_eq!(nth(items(), n), items().nth(n));
            }
        }
    }
}
