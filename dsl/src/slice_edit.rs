//! Functions of the DSL that write, move and compare the elements of slices.
//!
//! Those that are loops or a few assignments are inlined at their calls.

// They are what they would be written with.
#![allow(clippy::manual_swap, clippy::manual_slice_fill, clippy::manual_contains)]

use crate::{Number, function, library};

/// Exchanges two elements. Both are read before either is written.
#[function(expand)]
pub fn swap<T: Copy>(values: &mut [T], one: usize, other: usize) {
    let before = values[one];
    values[one] = values[other];
    values[other] = before;
}

/// Assigns one value to all elements.
#[function(expand)]
pub fn fill<T: Copy>(values: &mut [T], element: T) {
    for value in values.iter_mut() {
        *value = element;
    }
}

#[library(ContainsCompanion, expand)]
impl<T: PartialEq> [T] {
    /// Returns true if one of the elements equals `element`.
    pub fn contains(values: &Self, element: &T) -> bool {
        let mut found = false;
        for value in values {
            if value == element {
                found = true;
                break;
            }
        }
        found
    }
}

#[library(SliceEditCompanions, expand)]
impl<T: Copy> [T] {
    /// Rotates the slice to the left: the first `by` elements move to the end.
    pub fn rotate_left(values: &mut Self, by: usize) {
        assert!(by <= values.len());
        if by == 1 {
            let first = values[0];
            for i in 1..values.len() {
                values[i - 1] = values[i];
            }
            values[values.len() - 1] = first;
        } else {
            values[..by].reverse();
            values[by..].reverse();
            values.reverse();
        }
    }

    /// Rotates the slice to the right: the last `by` elements move to the beginning.
    pub fn rotate_right(values: &mut Self, by: usize) {
        assert!(by <= values.len());
        if by == 1 {
            let last = values[values.len() - 1];
            for i in (1..values.len()).rev() {
                values[i] = values[i - 1];
            }
            values[0] = last;
        } else {
            values.reverse();
            values[..by].reverse();
            values[by..].reverse();
        }
    }

    /// Copies the elements from index `from` to before `to` to index `place`; the two ranges may overlap.
    #[method(slice_copy_within_part)]
    pub fn copy_within(values: &mut Self, from: usize, to: usize, place: usize) {
        crate::__inside!(from <= to && to <= values.len());
        crate::__inside!(place <= values.len() - (to - from));
        if place <= from {
            for i in from..to {
                values[place + (i - from)] = values[i];
            }
        } else {
            for i in (from..to).rev() {
                values[place + (i - from)] = values[i];
            }
        }
    }

    /// Copies the elements from index `from` to the end to index `place`.
    #[method(slice_copy_within_rest)]
    pub fn copy_behind_within(values: &mut Self, from: usize, place: usize) {
        copy_within(values, from, values.len(), place);
    }
}

#[library(LetterCompanions)]
impl [u8] {
    /// The bytes without the ASCII white space at both ends.
    pub fn trim_ascii(letters: &Self) -> &Self {
        trim_ascii_end(trim_ascii_start(letters))
    }

    /// The bytes without the ASCII white space at the beginning.
    pub fn trim_ascii_start(letters: &Self) -> &Self {
        let mut from = 0_usize;
        while from < letters.len() && letters[from].is_ascii_whitespace() {
            from += 1;
        }
        &letters[from..]
    }

    /// The bytes without the ASCII white space at the end.
    pub fn trim_ascii_end(letters: &Self) -> &Self {
        let mut to = letters.len();
        while to > 0 && letters[to - 1].is_ascii_whitespace() {
            to -= 1;
        }
        &letters[..to]
    }
}

#[library(EndCompanions)]
impl<T: Number + PartialEq> [T] {
    /// Returns true if the slice begins with the elements of `start`.
    pub fn starts_with(values: &Self, start: &Self) -> bool {
        start.len() <= values.len() && values[..start.len()] == *start
    }

    /// Returns true if the slice ends with the elements of `end`.
    pub fn ends_with(values: &Self, end: &Self) -> bool {
        end.len() <= values.len() && values[values.len() - end.len()..] == *end
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    extern crate std;
    use std::vec::Vec;

    proptest! {
        #[test]
        fn each_does_what_core_does(
            values in prop::collection::vec(0_u8..5, 0..7),
            one in 0_usize..7,
            other in 0_usize..7,
            element in 0_u8..6,
        ) {
            prop_assert_eq!(contains(&values, &element), values.contains(&element));
            let letter = |it: &u8| b" a\tb\n"[usize::from(*it)];
            let letters: Vec<u8> = values.iter().map(letter).collect();
            prop_assert_eq!(trim_ascii(&letters), letters.trim_ascii());
            prop_assert_eq!(trim_ascii_start(&letters), letters.trim_ascii_start());
            prop_assert_eq!(trim_ascii_end(&letters), letters.trim_ascii_end());
            let (mut mine, mut theirs) = (values.clone(), values.clone());
            fill(&mut mine, element);
            theirs.fill(element);
            prop_assert_eq!(&mine, &theirs);
            if one.max(other) < values.len() {
                let (mut mine, mut theirs) = (values.clone(), values);
                swap(&mut mine, one, other);
                theirs.swap(one, other);
                prop_assert_eq!(mine, theirs);
            }
        }
    }
}
