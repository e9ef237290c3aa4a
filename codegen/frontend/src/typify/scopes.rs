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
    pub fn bind(&mut self, name: String, meaning: Value) {
        self.places.entry(name.clone()).or_default().push(self.all.len());
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
        bindings.into_iter().for_each(|(name, meaning)| names.bind(name, meaning));
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
mod tests {
    use super::*;

    #[test]
    fn later_and_inner_bindings_come_first() {
        let scope = |bindings: &[(&str, usize)]| -> Names {
            bindings.iter().map(|(name, at)| (name.to_string(), Value::Closure(*at))).collect()
        };
        let mut scopes = [scope(&[("a", 0), ("b", 1), ("a", 2)]), scope(&[]), scope(&[("a", 3)])];
        let closures = |scopes: &[Names], name: &str| -> Vec<usize> {
            let index = |meaning: &Value| match meaning {
                Value::Closure(at) => *at,
                _ => usize::MAX,
            };
            meanings_in(scopes, name).map(index).collect()
        };
        assert_eq!(closures(&scopes, "a"), [3, 2, 0]);
        assert_eq!(closures(&scopes, "b"), [1]);
        assert!(closures(&scopes, "c").is_empty());
        scopes[2].bind("b".to_owned(), Value::Closure(4));
        scopes[0].meanings_mut().for_each(|meaning| *meaning = Value::Closure(5));
        assert_eq!(closures(&scopes, "b"), [4, 5]);
        assert_eq!(scopes.iter().map(Names::len).collect::<Vec<_>>(), [3, 0, 2]);
    }
}
