//! A list of facts that is copied in constant time, and searched by the symbols that a fact is about.
//!
//! Invariant: each fact is listed under each of its symbols, at its number; later facts have higher numbers, also where paths
//! are joined. Facts before a branch have one number on both paths.

use super::linear::{Linear, Symbol};
use super::persistent::Map;

/// A fact about symbols.
pub(super) trait About: Clone + PartialEq {
    /// Calls `each` with each symbol.
    fn symbols(&self, each: &mut dyn FnMut(Symbol));
}

impl About for Linear {
    fn symbols(&self, each: &mut dyn FnMut(Symbol)) {
        self.parts.iter().for_each(|(symbol, _)| each(*symbol));
    }
}

/// Facts in the order in which they became known.
#[derive(Clone)]
pub(super) struct Facts<T> {
    all: Map<T>,
    /// The numbers of the facts of each symbol, ascending.
    of: Map<Vec<u32>>,
    next: u32,
}

impl<T> Default for Facts<T> {
    fn default() -> Facts<T> {
        Facts { all: Map::default(), of: Map::default(), next: 0 }
    }
}

/// The keys under which a fact is listed; one that no symbol has, if it has none.
fn keys(fact: &impl About) -> Vec<u32> {
    let mut keys = Vec::new();
    fact.symbols(&mut |symbol| keys.push(symbol.0 + 1));
    keys.sort_unstable();
    keys.dedup();
    if keys.is_empty() {
        keys.push(0);
    }
    keys
}

impl<T: About> Facts<T> {
    pub(super) fn push(&mut self, fact: T) {
        for key in keys(&fact) {
            self.of.change(key).push(self.next);
        }
        self.all.insert(self.next, fact);
        self.next += 1;
    }

    pub(super) fn remove(&mut self, number: u32) {
        let Some(fact) = self.all.get(number) else { return };
        for key in keys(fact) {
            self.of.change(key).retain(|it| *it != number);
        }
        self.all.set(number, None);
    }

    pub(super) fn contains(&self, fact: &T) -> bool {
        let listed = keys(fact).first().and_then(|key| self.of.get(*key));
        listed.into_iter().flatten().any(|number| self.all.get(*number) == Some(fact))
    }

    /// The facts that have a symbol with `other`, the latest first, with their numbers.
    pub(super) fn about<'a>(&'a self, other: &impl About) -> impl Iterator<Item = (u32, &'a T)> {
        let mut lists: Vec<&[u32]> =
            keys(other).iter().filter_map(|key| self.of.get(*key)).map(Vec::as_slice).collect();
        std::iter::from_fn(move || {
            let latest = *lists.iter().filter_map(|list| list.last()).max()?;
            for list in &mut lists {
                if let Some((_, rest)) = list.split_last().filter(|(last, _)| **last == latest) {
                    *list = rest;
                }
            }
            Some(latest)
        })
        .filter_map(|number| Some((number, self.all.get(number)?)))
    }

    /// Keeps the facts that hold on both paths. A fact of one path alone stays if `shown` says that it follows on the other path,
    /// which is `other`'s if the truth is true.
    pub(super) fn join(&mut self, other: &Facts<T>, shown: impl Fn(&T, bool) -> bool) {
        let differences = self.all.differences(&other.all);
        let new: Vec<T> = differences
            .iter()
            .filter_map(|(_, _, theirs)| theirs.as_deref())
            .filter(|theirs| !self.contains(theirs) && shown(theirs, false))
            .cloned()
            .collect();
        for (number, mine, _) in &differences {
            if mine.as_ref().is_some_and(|mine| !other.contains(mine) && !shown(mine, true)) {
                self.remove(*number);
            }
        }
        self.next = self.next.max(other.next);
        new.into_iter().for_each(|fact| self.push(fact));
    }
}
