//! The page of the options and the schema say what the table of keys says.

use std::fs;
use std::path::{Path, PathBuf};

use bessemer_project::schema;

fn docs(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs").join(name)
}

/// Holds a file to what it should say, or with `UPDATE_DOCS=1` writes it.
#[track_caller]
fn hold(path: &Path, should: &str) {
    if std::env::var_os("UPDATE_DOCS").is_some() {
        fs::write(path, should).expect("the page can be written");
    }
    let is = fs::read_to_string(path).unwrap_or_default();
    assert!(is == should, "{}: run UPDATE_DOCS=1 cargo test -p bessemer-project", path.display());
}

#[test]
fn the_page_lists_each_key() {
    let path = docs("options.md");
    let text = fs::read_to_string(&path).expect("the page");
    let mark = "`UPDATE_DOCS=1 cargo test -p bessemer-project`. -->\n";
    let (before, _) = text.split_once(mark).expect("where the table begins");
    hold(&path, &format!("{before}{mark}\n{}", schema::table()));
}

#[test]
fn the_schema_is_that_of_the_keys() {
    hold(&docs("bessemer.schema.json"), &schema::schema());
}
