//! The names of a scope and their meanings.
//!
//! Invariant: later bindings shadow earlier ones of the same name. A lookup costs the same however many names are bound,
//! so that a long block costs no more than its length.
//!
//! Must not know: where scopes begin and end.

use std::collections::HashMap;

use super::value::Value;

/// The bindings of one scope, in order.
#[derive(Clone, Default)]
pub(super) struct Names {
    all: Vec<(String, Value)>,
    /// Places of the bindings of each name, ascending.
    places: HashMap<String, Vec<usize>>,
}

impl Names {
    /// Adds a binding.
    pub fn add_name(&mut self, name: String, meaning: Value) {
        self.places.entry(name.clone()).or_default().extend([self.all.len()]);
        self.all.push((name, meaning));
    }

    /// Returns the number of bindings.
    pub fn len(&self) -> usize {
        self.all.len()
    }

    /// Returns all bindings, in order.
    pub fn iter(&self) -> impl Iterator<Item = &(String, Value)> {
        self.all.iter()
    }

    /// Returns the meanings of all bindings, in order.
    pub fn meanings_mut(&mut self) -> impl Iterator<Item = &mut Value> {
        self.all.iter_mut().map(|(_, meaning)| meaning)
    }
}

impl FromIterator<(String, Value)> for Names {
    fn from_iter<I: IntoIterator<Item = (String, Value)>>(bindings: I) -> Names {
        let mut names = Names::default();
        bindings.into_iter().for_each(|(name, meaning)| names.add_name(name, meaning));
        names
    }
}

/// Returns the meanings of a name, the innermost first; the innermost scope is last.
pub(super) fn meanings_in<'s>(scopes: &'s [Names], name: &str) -> impl Iterator<Item = &'s Value> {
    scopes.iter().rev().flat_map(move |scope| {
        let places = scope.places.get(name).into_iter().flatten().rev();
        places.map(|place| &scope.all[*place].1)
    })
}

/// Returns the innermost meaning of a name.
pub(super) fn meaning_in<'s>(scopes: &'s [Names], name: &str) -> Option<&'s Value> {
    meanings_in(scopes, name).next()
}

#[cfg(test)]
mod tests;
