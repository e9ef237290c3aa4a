//! Selects a part of a list that takes long to test completely.
//!
//! `cargo xtask test --full` tests all of it. Other runs alternate: the commit determines a number, which selects a
//! part of the list, so that a few commits together test everything.

use crate::toolchain::{self, Toolchain};

/// Returns true if a run must be complete.
pub fn is_full() -> bool {
    std::env::var_os("BESSEMER_FULL").is_some()
}

/// Returns `count` elements of the list in order, others in each turn; all in a full run.
pub fn some_of<T>(list: Vec<T>, count: usize) -> Vec<T> {
    some_of_shifted(list, count, 0)
}

/// Returns a rotating subset, shifted by `by`, so that several lists omit different elements.
pub fn some_of_shifted<T>(list: Vec<T>, count: usize, by: usize) -> Vec<T> {
    if is_full() { list } else { chosen(list, count, turn() + by) }
}

/// Returns one element of the list; all in a full run.
pub fn one_of<T>(list: Vec<T>) -> Vec<T> {
    some_of(list, 1)
}

/// Returns one level of optimisation of each compiler, rotating; all levels in a full run.
///
/// Tests that compile the same C choose by this, so that they share the objects.
pub fn levels(toolchains: Vec<Toolchain>) -> Vec<Toolchain> {
    if is_full() {
        return toolchains;
    }
    let mut compilers: Vec<&str> = toolchains.iter().map(|it| it.compiler).collect();
    compilers.dedup();
    let of_compiler = |(index, compiler): (usize, &str)| {
        let own = toolchains.iter().filter(|it| it.compiler == compiler).cloned().collect();
        // Another level of each, so that a run has the least and the most optimised.
        chosen(own, 1, turn() + index)
    };
    compilers.into_iter().enumerate().flat_map(of_compiler).collect()
}

/// Returns the other machines besides the target, in a full run.
pub fn others() -> Vec<Toolchain> {
    if is_full() { toolchain::others() } else { Vec::new() }
}

/// Returns the number derived from the commit.
pub fn turn() -> usize {
    std::env::var("BESSEMER_TURN").ok().and_then(|turn| turn.parse().ok()).unwrap_or_default()
}

fn chosen<T>(list: Vec<T>, count: usize, turn: usize) -> Vec<T> {
    let all = list.len();
    let first = (turn % all.max(1)) * count;
    let is_chosen = |index: usize| (index + all - first % all) % all < count;
    list.into_iter()
        .enumerate()
        .filter(|(index, _)| is_chosen(*index))
        .map(|(_, element)| element)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn a_turn_takes_as_many_as_asked_and_all_turns_take_all() {
        for length in 1..9 {
            for count in 1..=length {
                let mut seen = BTreeSet::new();
                for turn in 0..length {
                    let list = chosen((0..length).collect(), count, turn);
                    assert_eq!(list.len(), count, "{count} of {length}, turn {turn}");
                    assert!(list.is_sorted());
                    seen.extend(list);
                }
                // Steps of `count` around the list reach every element.
                assert_eq!(seen.len(), length, "{count} of {length}");
            }
        }
        assert!(chosen(Vec::<u8>::new(), 2, 3).is_empty());
        assert_eq!(chosen(vec!['a', 'b', 'c', 'd'], 2, 1), ['c', 'd']);
    }
}
