//! Place of an error about a type that the DSL does not support. rustc reports the attribute or a variable, and the
//! type's name is near there.

use super::causes::Item;
use super::rustc::Mark;
use bessemer_frontend::diagnostic::{Diagnostic, Place};
use bessemer_frontend::source::Sources;

/// Moves a diagnostic about the type `name` from `mark` to the name, and if it is not named there, to its declaration. A
/// declaration in the same file is added as a second place.
pub fn of_type(reported: Diagnostic, name: &str, mark: &Mark<'_>, sources: &Sources) -> Diagnostic {
    let lines = match mark.is_attribute() {
        true => Item::below(mark, sources).lines(),
        false => mark.start.0..=mark.start.0,
    };
    let named = lines
        .filter_map(|line| Some((line, sources.line(mark.file, line)?)))
        .find_map(|(line, text)| Some((line, column(&text, name)?, text)));
    let declared = declaration(name, mark.file, sources);
    let mut reported = reported;
    if let Some((line, column, text)) = named {
        let end = column + name.chars().count() as u32;
        reported = Diagnostic { line, column, end: Some((line, end)), ..reported };
        // The state of a component, rather than something that it holds.
        if text.trim_start().starts_with("impl") && mark.line.contains("component") {
            reported.help = reported.help.replace("`#[data]`", "`#[component]`");
        }
    } else if let Some(Place { start: (line, column), end, .. }) = declared {
        return Diagnostic { line, column, end: Some(end), ..reported };
    }
    reported.also.extend(declared.filter(|it| it.start.0 != reported.line));
    reported
}

/// Returns the declaration of a struct or an enum with this name in a file.
fn declaration(name: &str, file: &str, sources: &Sources) -> Option<Place> {
    let lines = (1..).map_while(|line| Some((line, sources.line(file, line)?)));
    let is_declaration = |text: &str| {
        let mut words = text.split(|it: char| !it.is_alphanumeric() && it != '_');
        words.any(|word| word == "struct" || word == "enum") && words.any(|word| word == name)
    };
    let (line, text) = lines.into_iter().find(|(_, text)| is_declaration(text))?;
    let start = column(&text, name)?;
    let end = (line, start + name.chars().count() as u32);
    Some(Place { start: (line, start), end, label: "declared here".to_owned(), ..Place::default() })
}

/// Returns true if a file declares a struct or an enum with this name, without an attribute of the DSL.
pub fn is_unmarked(name: &str, file: &str, sources: &Sources) -> bool {
    let Some(declared) = declaration(name, file, sources) else { return false };
    let above = (1..declared.start.0).rev().map_while(|line| sources.line(file, line));
    let mut attributes = above.take_while(|text| text.trim_start().starts_with(['#', '/']));
    !attributes.any(|text| {
        let mut words = text.split(|it: char| !it.is_alphanumeric() && it != '_');
        text.trim_start().starts_with("#[") && words.any(|it| it == "data" || it == "component")
    })
}

/// Returns the column of a whole word in a line, from 1.
fn column(text: &str, word: &str) -> Option<u32> {
    let is_part = |it: char| it.is_alphanumeric() || it == '_';
    let (at, _) = text.match_indices(word).find(|(at, _)| {
        let (before, behind) = (&text[..*at], &text[at + word.len()..]);
        !before.ends_with(is_part) && !behind.starts_with(is_part)
    })?;
    (!word.is_empty()).then(|| text[..at].chars().count() as u32 + 1)
}
