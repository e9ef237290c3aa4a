//! Chooses what a run takes of a list that is dear to go through whole.
//!
//! `cargo xtask test --full` goes through everything. A run without it takes turns: the commit gives a number, by
//! which some of the list is chosen, so that a few commits go through all of it and one commit is always tested
//! alike. Plain `cargo test` is turn 0.

use crate::toolchain::{self, Toolchain};

/// Returns true if nothing may be left out.
pub fn is_full() -> bool {
    std::env::var_os("BESSEMER_FULL").is_some()
}

/// `count` elements of the list, in their order, other ones at each turn; all of them in a full run.
pub fn some_of<T>(list: Vec<T>, count: usize) -> Vec<T> {
    some_of_shifted(list, count, 0)
}

/// Returns a rotating subset, shifted: for lists of which each is to lack other elements.
pub fn some_of_shifted<T>(list: Vec<T>, count: usize, by: usize) -> Vec<T> {
    if is_full() { list } else { chosen(list, count, turn() + by) }
}

/// One element of the list; all of them in a full run.
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

/// Machines beside the target, in a full run.
pub fn others() -> Vec<Toolchain> {
    if is_full() { toolchain::others() } else { Vec::new() }
}

/// The number that the commit gives.
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
