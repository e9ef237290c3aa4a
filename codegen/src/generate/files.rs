//! Files of a folder, by name.

use std::collections::BTreeMap;

/// Files by name.
#[derive(Default)]
pub struct Files(pub(super) BTreeMap<String, String>);

impl Files {
    /// Adds a file.
    pub fn add(&mut self, name: &str, text: String) {
        self.0.insert(name.to_owned(), text);
    }

    /// Returns the names, in order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }
}
