//! Functions of the DSL that write, move and compare the elements of slices.
//!
//! Those that are loops or a few assignments are put where they are called.

// They are what they would be written with.
#![allow(clippy::manual_swap, clippy::manual_slice_fill, clippy::manual_contains)]

use crate::{Number, function, library};

/// Exchanges two elements. Both are read before one is written.
#[function(expand)]
pub fn swap<T: Copy>(values: &mut [T], one: usize, other: usize) {
    let before = values[one];
    values[one] = values[other];
    values[other] = before;
}

/// Makes all elements this one.
#[function(expand)]
pub fn fill<T: Copy>(values: &mut [T], element: T) {
    for value in values.iter_mut() {
        *value = element;
    }
}

#[library(ContainsCompanion, expand)]
impl<T: PartialEq> [T] {
    /// Returns true if an element is among them.
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

#[library(SliceEditCompanions)]
impl<T: Copy> [T] {
    /// Moves the first `by` elements behind the others.
    pub fn rotate_left(values: &mut Self, by: usize) {
        assert!(by <= values.len());
        values[..by].reverse();
        values[by..].reverse();
        values.reverse();
    }

    /// Moves the last `by` elements before the others.
    pub fn rotate_right(values: &mut Self, by: usize) {
        assert!(by <= values.len());
        values.reverse();
        values[..by].reverse();
        values[by..].reverse();
    }

    /// Copies the elements from `from` to `to` to where `place` is, which may be among them.
    #[method(slice_copy_within_part)]
    pub fn copy_within(values: &mut Self, from: usize, to: usize, place: usize) {
        crate::__inside!(from <= to && to <= values.len());
        let count = to - from;
        crate::__inside!(place <= values.len() - count);
        if place <= from {
            for i in 0..count {
                values[place + i] = values[from + i];
            }
        } else {
            for i in (0..count).rev() {
                values[place + i] = values[from + i];
            }
        }
    }

    /// Copies all elements from `from` on within a slice.
    #[method(slice_copy_within_rest)]
    pub fn copy_behind_within(values: &mut Self, from: usize, place: usize) {
        copy_within(values, from, values.len(), place);
    }
}

#[library(LetterCompanions)]
impl [u8] {
    /// The letters between the white space at both ends.
    pub fn trim_ascii(letters: &Self) -> &Self {
        trim_ascii_end(trim_ascii_start(letters))
    }

    /// The letters behind the white space that they begin with.
    pub fn trim_ascii_start(letters: &Self) -> &Self {
        let mut from = 0_usize;
        while from < letters.len() && letters[from].is_ascii_whitespace() {
            from += 1;
        }
        &letters[from..]
    }

    /// The letters before the white space that they end in.
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
    /// Returns true if the first elements are these.
    pub fn starts_with(values: &Self, start: &Self) -> bool {
        start.len() <= values.len() && values[..start.len()] == *start
    }

    /// Returns true if the last elements are these.
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
