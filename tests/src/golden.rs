//! Files of the repository that tests write: pages, and C that should not change.
//!
//! Invariant: nothing is written without `UPDATE_DOCS`.

use std::fs;
use std::path::Path;

use crate::root;

/// Returns true if a file, named from the root, has this text. With `UPDATE_DOCS`, writes the text first.
///
/// # Panics
///
/// If the file cannot be written.
pub fn holds(path: &Path, text: &str) -> bool {
    let full = root().join(path);
    if fs::read_to_string(&full).is_ok_and(|old| old == text) {
        return true;
    }
    if std::env::var_os("UPDATE_DOCS").is_none() {
        return false;
    }
    let folder = full.parent().unwrap_or(&full);
    fs::create_dir_all(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    fs::write(&full, text).unwrap_or_else(|error| panic!("{}: {error}", full.display()));
    true
}
