//! Counterparts of lines: from a line of C to the Rust that it comes from, and from a line of Rust to its C.
//!
//! It reads the folder of the C with the map beside each file, and builds nothing.
//!
//! Invariant: each statement of a file with a map has a counterpart: its own, or the one before it in the
//! function. Must not know: how the maps are made.

mod error;
mod folder;
mod names;

pub use error::Error;
pub use folder::{File, Folder, Row};
pub use names::{Explained, explained};

use std::fmt::Write as _;
use std::path::Path;

/// A line of C or Rust that a user names: `generated/mixer.c:71`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// The file, as the user wrote it.
    pub file: String,
    /// The line, from 1.
    pub line: u32,
}

impl Line {
    /// Reads `file:line`; a column behind it, as compilers print one, is dropped.
    ///
    /// # Errors
    /// [`Error::NoLine`] without a line number.
    pub fn of(text: &str) -> Result<Line, Error> {
        let missing = || Error::NoLine { said: text.to_owned() };
        let (before, last) = text.rsplit_once(':').ok_or_else(missing)?;
        let last: u32 = last.parse().map_err(|_| missing())?;
        let (file, line) = match before.rsplit_once(':') {
            Some((file, line)) if line.parse::<u32>().is_ok() => (file, line.parse().unwrap_or(0)),
            _ => (before, last),
        };
        match line {
            0 => Err(missing()),
            line => Ok(Line { file: file.to_owned(), line }),
        }
    }
}

/// Rust sources, by the names that the maps have.
pub trait Sources {
    /// Text of a source; none if it is not on this machine.
    fn text(&self, name: &str) -> Option<String>;
}

/// Sources of a workspace.
pub struct Workspace<'a>(pub &'a Path);

impl Sources for Workspace<'_> {
    fn text(&self, name: &str) -> Option<String> {
        std::fs::read_to_string(self.0.join(name)).ok()
    }
}

/// Describes the counterpart of a line, for a terminal.
///
/// # Errors
/// See [`Error`].
pub fn described(folder: &Folder, sources: &dyn Sources, line: &Line) -> Result<String, Error> {
    match line.file.ends_with(".rs") {
        true => of_rust(folder, sources, line),
        false => of_c(folder, sources, line),
    }
}

fn of_c(folder: &Folder, sources: &dyn Sources, wanted: &Line) -> Result<String, Error> {
    let file = folder.file(&wanted.file)?;
    let count = file.text.lines().count() as u32;
    if wanted.line > count {
        return Err(Error::Beyond { file: file.name.clone(), line: wanted.line, last: count });
    }
    let mut text = String::new();
    let Some((first, last, row)) = file.counterpart(wanted.line) else {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}:{}", file.name, wanted.line);
        text += &numbered(&file.text, wanted.line, wanted.line);
        let _ = writeln!(text, "{}", file.why_none(wanted.line));
        return Ok(text);
    };
    let function = file.functions.iter().find(|it| it.line <= first && last <= it.last_line);
    let within = function.map(|it| format!("  in {}", it.name)).unwrap_or_default();
    let _ = writeln!(text, "{}:{first}{within}", file.name);
    text += &numbered(&file.text, first, last);
    let _ = writeln!(text, "{}:{}  {}", row.rust_file, row.rust_line, row.function);
    let rust = sources.text(&row.rust_file);
    match &rust {
        Some(rust) => {
            text += &numbered(rust, row.rust_line, row.rust_line);
            if let Some(function) = function
                && is_moved(file, function.line, rust)
            {
                text += "  the Rust was changed since: run `cargo bessemer gen`\n";
            }
        }
        None => text += "  (the source is not in this workspace)\n",
    }
    if let (Some(function), Some(rust)) = (function, &rust) {
        for it in explained(file, function, (first, last), rust) {
            let _ = writeln!(text, "  `{}`: {}", it.name, it.why);
        }
    }
    Ok(text)
}

/// Returns true if the line of Rust that a function comes from declares no function any more.
fn is_moved(file: &File, line: u32, rust: &str) -> bool {
    let Some(row) = file.rows.iter().rev().find(|row| row.c_line <= line) else { return false };
    let name = row.function.rsplit("::").next().unwrap_or_default();
    let is_type = name.starts_with(|c: char| c.is_ascii_uppercase());
    // A method that an attribute made and a routine have a line without their name.
    let has_it = rust.lines().any(|it| it.contains(&format!("fn {name}")));
    let there = rust.lines().nth(row.rust_line.saturating_sub(1) as usize);
    has_it && !is_type && !there.is_some_and(|it| it.contains(name) || it.contains('#'))
}

fn of_rust(folder: &Folder, sources: &dyn Sources, wanted: &Line) -> Result<String, Error> {
    let name = folder.rust_file(&wanted.file)?;
    let rust = sources.text(&name);
    if let Some(rust) = &rust {
        let count = rust.lines().count() as u32;
        if wanted.line > count {
            return Err(Error::Beyond { file: name, line: wanted.line, last: count });
        }
    }
    let mut places = folder.of_rust(&name, wanted.line);
    let mut text = String::new();
    let _ = writeln!(text, "{name}:{}", wanted.line);
    text += &numbered(rust.as_deref().unwrap_or_default(), wanted.line, wanted.line);
    if places.is_empty() {
        let nearest = folder.nearest(&name, wanted.line);
        let Some(nearest) = nearest else {
            return Err(Error::NoCounterpart { file: name, line: wanted.line });
        };
        let _ = writeln!(text, "  no C by itself; the nearest line that has some is {nearest}:");
        text += &numbered(rust.as_deref().unwrap_or_default(), nearest, nearest);
        places = folder.of_rust(&name, nearest);
    }
    for (file, first, last, row) in places {
        let function = file.functions.iter().find(|it| it.line <= first && last <= it.last_line);
        let within = function.map(|it| format!("  in {}", it.name)).unwrap_or_default();
        let _ = writeln!(text, "{}:{first}{within}  {}", file.name, row.function);
        text += &numbered(&file.text, first, last);
    }
    Ok(text)
}

/// Lines of a text with their numbers.
fn numbered(text: &str, first: u32, last: u32) -> String {
    let lines = text.lines().zip(1..).filter(|(_, number)| (first..=last).contains(number));
    lines.map(|(line, number): (&str, u32)| format!("  {number:>5} | {line}\n")).collect()
}

#[cfg(test)]
mod tests;
