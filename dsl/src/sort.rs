//! Sorting, written in the DSL itself, so that simulation and C put equal elements in the same order.
//!
//! Insertion sort: stable, in place, without recursion, and fast for the few elements that controllers sort. For n
//! elements it makes at most n (n − 1) / 2 comparisons. No index needs a check: that of the inner loop is below that
//! of the outer one, which is below the length.

use crate::math::Real;
use crate::{Number, function, library};

/// Sorts `values` so that no element is `below` the one before it; equal elements keep their order.
#[function]
pub fn sort_by<T: Copy, F: Fn(&T, &T) -> bool>(values: &mut [T], below: F) {
    for i in 1..values.len() {
        for at in (0..i).rev() {
            let (one, next) = (values[at], values[at + 1]);
            if !below(&next, &one) {
                break;
            }
            values[at] = next;
            values[at + 1] = one;
        }
    }
}

#[library(SortCompanions)]
impl<T: Number + Ord> [T] {
    /// Sorts integers in ascending order.
    #[method(sort, sort_unstable)]
    pub fn ascending(values: &mut Self) {
        for i in 1..values.len() {
            for at in (0..i).rev() {
                let (one, next) = (values[at], values[at + 1]);
                if next >= one {
                    break;
                }
                values[at] = next;
                values[at + 1] = one;
            }
        }
    }
}

#[library(OrderCompanion)]
impl<T: PartialOrd> [T] {
    /// Returns true if no element is less than the one before it; false if there is a NaN.
    #[allow(clippy::neg_cmp_op_on_partial_ord)]
    pub fn is_sorted(values: &Self) -> bool {
        for at in 1..values.len() {
            // As `PartialOrd` has it: not `>`, which a NaN is not either.
            if !(values[at - 1] <= values[at]) {
                return false;
            }
        }
        true
    }
}

/// Returns true if `one` is less than `other` in the order of `total_cmp`: −0 before +0, NaN last.
#[function]
#[inline]
pub fn below<T: Real>(one: T, other: T) -> bool {
    if one == other {
        return one.is_sign_negative() && !other.is_sign_negative();
    }
    one < other || !one.is_nan() && other.is_nan()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_ones_keep_their_order() {
        let mut pairs = [(2, 'a'), (1, 'b'), (2, 'c'), (1, 'd')];
        sort_by(&mut pairs, |one, other| one.0 < other.0);
        assert_eq!(pairs, [(1, 'b'), (1, 'd'), (2, 'a'), (2, 'c')]);
    }

    #[test]
    fn floats_have_the_order_of_total_cmp() {
        let numbers = [f64::NEG_INFINITY, -1.0, -0.0, 0.0, 5e-324, f64::INFINITY, f64::NAN];
        for one in numbers {
            for other in numbers {
                assert_eq!(below(one, other), one.total_cmp(&other).is_lt(), "{one} {other}");
            }
        }
        assert!(!below(-f64::NAN, f64::MAX) && !below(-f64::NAN, f64::NAN));
    }
}
