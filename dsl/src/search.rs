//! Binary search in sorted slices, written in the DSL itself, because core does not define which of several equal
//! elements it finds.
//!
//! Of n elements at most log₂ n + 1 are compared.

use core::cmp::Ordering;

use crate::{function, library};

#[library(SearchCompanions)]
impl<T: Copy> [T] {
    /// The index of an element for which the function returns `Equal`.
    ///
    /// # Errors
    ///
    /// The index at which such an element could be inserted, if there is none.
    pub fn binary_search_by<F: Fn(&T) -> Ordering>(
        values: &Self,
        order: F,
    ) -> Result<usize, usize> {
        let mut from = 0_usize;
        let mut left = values.len();
        // No more can be halved than there are bits.
        for _ in 0..64 {
            let middle = from.wrapping_add(left / 2);
            if left == 0 || middle >= values.len() {
                break;
            }
            let value = values[middle];
            match order(&value) {
                Ordering::Equal => return Ok(middle),
                Ordering::Less => {
                    from = middle.wrapping_add(1);
                    left = left.wrapping_sub(left / 2).wrapping_sub(1);
                }
                Ordering::Greater => left /= 2,
            }
        }
        Err(from)
    }

    /// The index of the first element for which `is_first` does not hold; it must hold for all elements before.
    pub fn partition_point<F: Fn(&T) -> bool>(values: &Self, is_first: F) -> usize {
        let mut from = 0_usize;
        let mut left = values.len();
        for _ in 0..64 {
            let middle = from.wrapping_add(left / 2);
            if left == 0 || middle >= values.len() {
                break;
            }
            let value = values[middle];
            if is_first(&value) {
                from = middle.wrapping_add(1);
                left = left.wrapping_sub(left / 2).wrapping_sub(1);
            } else {
                left /= 2;
            }
        }
        from
    }
}

/// The index of an element equal to `wanted`. The function is inlined, since the type of the elements may be an
/// author's.
///
/// # Errors
///
/// The index at which `wanted` could be inserted, if no element is equal.
#[function]
#[inline]
pub fn binary_search<T: Copy + Ord>(values: &[T], wanted: T) -> Result<usize, usize> {
    let from = partition_point(values, |value| *value < wanted);
    if from < values.len() && values[from] == wanted { Ok(from) } else { Err(from) }
}

/// The index of an element whose key is `wanted`.
///
/// # Errors
///
/// The index at which such an element could be inserted, if there is none.
#[function]
pub fn binary_search_by_key<T: Copy, B: Copy + Ord, F: Fn(&T) -> B>(
    values: &[T],
    wanted: B,
    key: F,
) -> Result<usize, usize> {
    let mut from = 0_usize;
    let mut left = values.len();
    for _ in 0..64 {
        let middle = from.wrapping_add(left / 2);
        if left == 0 || middle >= values.len() {
            break;
        }
        let value = values[middle];
        let found = key(&value);
        if found == wanted {
            return Ok(middle);
        }
        if found < wanted {
            from = middle.wrapping_add(1);
            left = left.wrapping_sub(left / 2).wrapping_sub(1);
        } else {
            left /= 2;
        }
    }
    Err(from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_core_finds_is_found() {
        let values = [1, 4, 5, 9, 12, 20, 31];
        for length in 0..=values.len() {
            for wanted in 0..40 {
                let part = &values[..length];
                let found = part.binary_search(&wanted);
                assert_eq!(binary_search(part, wanted), found, "{length} {wanted}");
                assert_eq!(binary_search_by(part, |value| value.cmp(&wanted)), found);
                assert_eq!(binary_search_by_key(part, wanted, |value| *value), found);
                let point = part.partition_point(|value| *value < wanted);
                assert_eq!(partition_point(part, |value| *value < wanted), point);
            }
        }
    }

    #[test]
    fn of_equal_elements_the_first_is_found() {
        assert_eq!(binary_search(&[1, 2, 2, 2, 3], 2), Ok(1));
    }
}
