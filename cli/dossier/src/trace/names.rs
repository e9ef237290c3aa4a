//! Explanations of names in the C that the Rust does not have.

use std::collections::BTreeSet;

use super::folder::{File, Row};
use crate::scan::Function;
use crate::scan::tokens::{Token, tokens};

/// A name of the C and the reason why it is there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Explained {
    /// Name in the C.
    pub name: String,
    /// Explanation.
    pub why: String,
}

/// Returns the local names in these lines of a function that the Rust file does not have, each explained.
pub fn explained(
    file: &File,
    function: &Function,
    (first, last): (u32, u32),
    rust: &str,
) -> Vec<Explained> {
    let in_rust = words(file, function, rust);
    let all = tokens(&file.text);
    let mut seen: Vec<&str> = Vec::new();
    let mut found = Vec::new();
    for (at, token) in all.iter().enumerate() {
        let name = token.text(&file.text);
        let member = at > 0 && matches!(all[at - 1].text(&file.text), "." | "->");
        let called = all.get(at + 1).is_some_and(|next| next.text(&file.text) == "(");
        let inside = (first..=last).contains(&token.line);
        let is_name = name.starts_with(|c: char| c.is_ascii_lowercase());
        if !inside || !is_name || member || called || in_rust.contains(name) || seen.contains(&name)
        {
            continue;
        }
        let Some(declared) = declaration(file, function, name, &all) else { continue };
        seen.push(name);
        found.push(Explained {
            name: name.to_owned(),
            why: why(file, function, name, declared, &in_rust),
        });
    }
    found
}

/// Returns the words of the Rust that a function comes from: those between its first and its last line.
fn words(file: &File, function: &Function, rust: &str) -> BTreeSet<String> {
    let of = file.counterpart(function.line).map(|(_, _, row)| &row.rust_file);
    let own = |row: &&Row| {
        Some(&row.rust_file) == of && (function.line..=function.last_line).contains(&row.c_line)
    };
    let lines = || file.rows.iter().filter(own).map(|row| row.rust_line as usize);
    let (first, last) = (lines().min().unwrap_or(1), lines().max().unwrap_or(usize::MAX));
    let text = rust.lines().skip(first.saturating_sub(1)).take(last - first + 1);
    let words = text.flat_map(|it| it.split(|c: char| !c.is_ascii_alphanumeric() && c != '_'));
    words.filter(|it| !it.is_empty()).map(str::to_owned).collect()
}

/// Returns the line in which a function declares a local.
fn declaration(file: &File, function: &Function, name: &str, all: &[Token]) -> Option<u32> {
    let word = |at: usize| all.get(at).map_or("", |it| it.text(&file.text));
    let is_type = |word: &str| {
        word.starts_with(|c: char| c.is_ascii_alphabetic())
            && !matches!(word, "return" | "case" | "else" | "goto")
    };
    let inside = |it: &Token| (function.line..=function.last_line).contains(&it.line);
    let declares = |at: &usize| {
        let typed = match at.checked_sub(1).map(word) {
            Some("*") => at.checked_sub(2).is_some_and(|at| word(at).ends_with("_t")),
            before => before.is_some_and(is_type),
        };
        word(*at) == name && typed && matches!(word(at + 1), "=" | ";" | "[") && inside(&all[*at])
    };
    (0..all.len()).find(declares).map(|at| all[at].line)
}

fn why(
    file: &File,
    function: &Function,
    name: &str,
    declared: u32,
    in_rust: &BTreeSet<String>,
) -> String {
    let line = file.text.lines().nth(declared as usize - 1).unwrap_or_default().trim().to_owned();
    let at = file
        .counterpart(declared)
        .map_or_else(String::new, |(_, _, row)| format!(" of {}:{}", row.rust_file, row.rust_line));
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('_');
    if line.starts_with("for (") {
        return format!("counts the passes of a loop that the Rust writes as one operation{at}");
    }
    if stem != name && in_rust.contains(stem) {
        return format!(
            "the Rust's `{stem}`, one of several in `{}`: C needs a name for each",
            function.name
        );
    }
    if line.starts_with("static const") {
        return format!("a constant value{at}, kept in read-only memory");
    }
    let parts: Vec<&str> = name.split('_').filter(|it| in_rust.contains(*it)).collect();
    let from = match parts[..] {
        [] => String::new(),
        _ => format!(
            ", named after {}",
            parts.iter().map(|it| format!("`{it}`")).collect::<Vec<_>>().join(" and ")
        ),
    };
    format!("a temporary: a value{at} that the Rust computes within an expression{from}")
}
