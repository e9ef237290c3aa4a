//! A program in plain Rust and its marks: `programs/name.rs` as it came, `marks/name` what stands beside it.
//!
//! A line of the marks is the number of a line of the program, and an attribute or an import that stands above it.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::Path;

/// The programs of the folder, by their names: those that become C, and those that are listed as not doing so yet.
pub fn programs(folder: &Path) -> io::Result<(Vec<String>, Vec<String>)> {
    let listed: BTreeSet<String> = listed(&fs::read_to_string(folder.join("README.md"))?);
    let entries = fs::read_dir(folder.join("programs"))?.collect::<io::Result<Vec<_>>>()?;
    let name = |path: &Path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let mut names: Vec<String> = entries.iter().map(|entry| name(&entry.path())).collect();
    names.sort();
    Ok(names.into_iter().partition(|name| !listed.contains(name)))
}

/// The names in the first column of the page's table.
fn listed(page: &str) -> BTreeSet<String> {
    let rows = page.lines().filter_map(|line| line.strip_prefix("| `"));
    rows.filter_map(|row| row.split('`').next()).map(str::to_owned).collect()
}

/// A program with its marks.
pub fn marked(folder: &Path, name: &str) -> io::Result<String> {
    let program = fs::read_to_string(folder.join("programs").join(format!("{name}.rs")))?;
    let marks = fs::read_to_string(folder.join("marks").join(name))?;
    let wrong = |mark: &str| io::Error::other(format!("{name}: `{mark}` is no mark"));
    let mut lines: Vec<String> = program.lines().map(str::to_owned).collect();
    for mark in marks.lines().collect::<Vec<_>>().into_iter().rev() {
        let (number, text) = mark.split_once(' ').ok_or_else(|| wrong(mark))?;
        let number: usize = number.parse().map_err(|_| wrong(mark))?;
        let allowed = text.starts_with("#[") && text.ends_with(']')
            || text.starts_with("use ") && text.ends_with(';');
        if !allowed || number == 0 || number > lines.len() {
            return Err(wrong(mark));
        }
        lines.insert(number - 1, text.to_owned());
    }
    Ok(lines.join("\n") + "\n")
}
