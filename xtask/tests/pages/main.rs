//! The pages for people are true: links lead somewhere, quotations are in their files, figures are those of
//! their result files.
//!
//! Nothing is built or measured here: pages are read, and the files that they name.

mod figures;
mod links;
mod mathematics;
mod quotations;
#[path = "../shared/mod.rs"]
mod shared;

use shared::File;

/// The pages for people; the book's examples are held by the test that writes them.
fn pages() -> Vec<File> {
    let mut files = shared::files();
    files.retain(|file| file.path.ends_with(".md") && !file.path.starts_with("cli/templates/"));
    files
}

/// The lines of a page that are not code, each with its number from 1.
fn prose(text: &str) -> Vec<(usize, &str)> {
    let mut lines = Vec::new();
    let mut is_code = false;
    for (index, line) in text.lines().enumerate() {
        if line.trim_start().starts_with("```") {
            is_code = !is_code;
        } else if !is_code {
            lines.push((index + 1, line));
        }
    }
    lines
}

/// A path from the root, as it is meant in a page: `..` and `.` are resolved.
fn resolved(page: &str, target: &str) -> Option<String> {
    let mut parts: Vec<&str> = page.split('/').collect();
    parts.pop();
    for part in target.split('/').filter(|part| !part.is_empty() && *part != ".") {
        match part {
            ".." => _ = parts.pop()?,
            _ => parts.push(part),
        }
    }
    Some(parts.join("/"))
}

/// The first pages that somebody reads are short.
#[test]
fn the_first_pages_are_short() {
    let longest = [("README.md", 150), ("ARCHITECTURE.md", 250)];
    let mut offences = Vec::new();
    for page in pages() {
        let lines = page.text.lines().count();
        let bound = longest.iter().find(|(path, _)| *path == page.path);
        offences.extend(
            bound
                .filter(|(_, most)| lines > *most)
                .map(|(path, most)| format!("{path}: {lines} lines of {most}")),
        );
    }
    shared::none("the first pages are short", &offences);
}
