//! `Ordering` as a value: `a.cmp(&b)` and its methods.

use core::cmp::Ordering as Native;

use crate::math::Real;
use crate::{Plain, data, function, library, sort};

/// `core::cmp::Ordering` in the C.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub enum Ordering {
    /// The first comes before the second.
    #[default]
    Less = -1,
    /// Neither comes first.
    Equal = 0,
    /// The first comes behind the second.
    Greater = 1,
}

/// `core::cmp::Reverse` in the C: the greater value comes first. The front end reverses the comparison.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reverse<T>(pub T);

#[diagnostic::do_not_recommend]
impl<T: Plain> Plain for core::cmp::Reverse<T> {
    const WORDS: usize = T::WORDS;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        self.0.store(out);
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        core::cmp::Reverse(T::load(next))
    }
}

/// Order of two values. Inline, so that it is declared beside the type, which may be an author's.
#[function]
#[inline]
pub fn compare<T: Copy + Ord>(one: T, other: T) -> Native {
    if one < other {
        Native::Less
    } else if one == other {
        Native::Equal
    } else {
        Native::Greater
    }
}

/// `one.eq(&other)`.
#[function(expand)]
pub fn equal<T: Copy + PartialEq>(one: T, other: T) -> bool {
    one == other
}

/// `one.ne(&other)`.
#[function(expand)]
pub fn unequal<T: Copy + PartialEq>(one: T, other: T) -> bool {
    one != other
}

/// `one.lt(&other)`.
#[function(expand)]
pub fn below<T: Copy + PartialOrd>(one: T, other: T) -> bool {
    one < other
}

/// `one.le(&other)`.
#[function(expand)]
pub fn at_most<T: Copy + PartialOrd>(one: T, other: T) -> bool {
    one <= other
}

/// `one.gt(&other)`.
#[function(expand)]
pub fn above<T: Copy + PartialOrd>(one: T, other: T) -> bool {
    one > other
}

/// `one.ge(&other)`.
#[function(expand)]
pub fn at_least<T: Copy + PartialOrd>(one: T, other: T) -> bool {
    one >= other
}

#[library(OrderingCompanions)]
impl Native {
    /// Returns this order, or the result of `f` if it is `Equal`.
    #[function(rewrite)]
    pub fn then_with<F: FnOnce() -> Native>(order: Self, f: F) -> Self {
        match order {
            Native::Equal => f(),
            value => value,
        }
    }

    /// Returns the reversed order.
    #[method(reverse)]
    pub fn reversed(order: Self) -> Self {
        match order {
            Native::Less => Native::Greater,
            Native::Equal => Native::Equal,
            Native::Greater => Native::Less,
        }
    }

    /// Returns this order, or `next` if it is `Equal`.
    pub fn then(order: Self, next: Self) -> Self {
        if order == Native::Equal { next } else { order }
    }

    /// Returns true if the first comes before the second.
    #[inline]
    #[method(is_lt)]
    pub fn is_less(order: Self) -> bool {
        order == Native::Less
    }

    /// Returns true if the first comes behind the second.
    #[inline]
    #[method(is_gt)]
    pub fn is_greater(order: Self) -> bool {
        order == Native::Greater
    }

    /// Returns true if neither comes first.
    #[inline]
    #[method(is_eq)]
    pub fn is_equal(order: Self) -> bool {
        order == Native::Equal
    }

    /// Returns true if the first does not come behind the second.
    #[inline]
    #[method(is_le)]
    pub fn is_at_most(order: Self) -> bool {
        order != Native::Greater
    }

    /// Returns true if the first does not come before the second.
    #[inline]
    #[method(is_ge)]
    pub fn is_at_least(order: Self) -> bool {
        order != Native::Less
    }

    /// Returns true if one of the two comes first.
    #[inline]
    #[method(is_ne)]
    pub fn is_unequal(order: Self) -> bool {
        order != Native::Equal
    }
}

/// The lesser of two; of equal ones the first.
#[function]
#[inline]
pub fn lesser<T: Copy + Ord>(one: T, other: T) -> T {
    if other < one { other } else { one }
}

/// The greater of two; of equal ones the second.
#[function]
#[inline]
pub fn greater<T: Copy + Ord>(one: T, other: T) -> T {
    if other < one { one } else { other }
}

/// The nearest value from `low` to `high`.
///
/// # Panics
/// Unless `low <= high`.
#[function]
#[inline]
pub fn limited<T: Copy + Ord>(value: T, low: T, high: T) -> T {
    crate::__between!(low <= high);
    if value < low {
        return low;
    }
    if value > high { high } else { value }
}

/// Order of two numbers that may have none: NaN has no order.
#[function]
#[inline]
pub fn partial<T: Copy + PartialOrd>(one: T, other: T) -> Option<Native> {
    if one < other {
        return Some(Native::Less);
    }
    if one == other {
        return Some(Native::Equal);
    }
    if one > other { Some(Native::Greater) } else { None }
}

/// Total order of floats: −0 before +0, NaN behind all others.
#[function]
pub fn total<T: Real>(one: T, other: T) -> Native {
    if sort::below(one, other) {
        Native::Less
    } else if sort::below(other, one) {
        Native::Greater
    } else {
        Native::Equal
    }
}
