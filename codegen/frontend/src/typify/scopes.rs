//! The names of nested scopes and their meanings.
//!
//! Invariant: later bindings shadow earlier ones of the same name, and inner scopes outer ones. A lookup costs the same
//! however many names are bound and however deep the scopes are, so that long and deep code costs no more than its length.
//!
//! Must not know: where scopes begin and end.

use std::collections::HashMap;

use super::value::Value;

/// The bindings of one scope, in order.
pub(super) type Names = Vec<(String, Value)>;

/// Scopes within each other, the innermost last.
#[derive(Clone)]
pub(super) struct Scopes {
    all: Vec<Names>,
    /// Places of the bindings of each name, a scope and a place in it, ascending.
    places: HashMap<String, Vec<(usize, usize)>>,
}

impl Default for Scopes {
    /// One scope without names.
    fn default() -> Scopes {
        Scopes { all: vec![Names::new()], places: HashMap::new() }
    }
}

impl FromIterator<(String, Value)> for Scopes {
    /// One scope with these bindings.
    fn from_iter<I: IntoIterator<Item = (String, Value)>>(bindings: I) -> Scopes {
        let mut scopes = Scopes::default();
        bindings.into_iter().for_each(|(name, meaning)| scopes.add_name(name, meaning));
        scopes
    }
}

impl Scopes {
    /// Adds an inner scope.
    pub fn push(&mut self, names: Names) {
        self.all.push(Names::new());
        names.into_iter().for_each(|(name, meaning)| self.add_name(name, meaning));
    }

    /// Removes the innermost scope.
    pub fn pop(&mut self) {
        for (name, _) in self.all.pop().into_iter().flatten() {
            if let Some(places) = self.places.get_mut(&name) {
                places.pop();
            }
        }
    }

    /// Adds a binding to the innermost scope.
    pub fn add_name(&mut self, name: String, meaning: Value) {
        let Some(last) = self.all.len().checked_sub(1) else { return };
        let scope = &mut self.all[last];
        self.places.entry(name.clone()).or_default().push((last, scope.len()));
        scope.push((name, meaning));
    }

    /// Returns the number of bindings.
    pub fn len(&self) -> usize {
        self.all.iter().map(Names::len).sum()
    }

    /// Returns all bindings, those of the outermost scope first.
    pub fn iter(&self) -> impl Iterator<Item = &(String, Value)> {
        self.all.iter().flatten()
    }

    /// Returns the meanings of all bindings, in the same order.
    pub fn meanings_mut(&mut self) -> impl Iterator<Item = &mut Value> {
        self.all.iter_mut().flatten().map(|(_, meaning)| meaning)
    }

    /// Returns the meanings of a name, the innermost first.
    pub fn meanings<'s>(&'s self, name: &str) -> impl Iterator<Item = &'s Value> + use<'s> {
        let places = self.places.get(name).into_iter().flatten().rev();
        places.map(|(scope, place)| &self.all[*scope][*place].1)
    }

    /// Returns the innermost meaning of a name.
    pub fn meaning(&self, name: &str) -> Option<&Value> {
        self.meanings(name).next()
    }
}

#[cfg(test)]
mod tests;
