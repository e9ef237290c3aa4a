//! Messages of the compiler to the author: a place in the source, a text and a remedy.
//!
//! Every stage that refuses a program returns these, and rustc's own errors about a model become them, too. Only
//! [`render`] knows how a terminal shows them, and only [`json`] what tools read. Both have rustc's own format.

mod extent;

use std::fmt::{self, Display, Formatter};

use annotate_snippets::{AnnotationKind, Group, Level as Title, Renderer, Snippet};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::source::Sources;

/// Remedy for an internal contradiction of the compiler.
pub const OUR_FAULT: &str = "this is a fault of Bessemer; please report it with this line";

/// Severity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Level {
    /// An error: no C is emitted.
    #[default]
    Error,
    /// A warning: the C is emitted, but may not be what its author expects.
    Warning,
}

impl Level {
    /// Returns rustc's word for the severity.
    pub fn word(self) -> &'static str {
        match self {
            Level::Error => "error",
            Level::Warning => "warning",
        }
    }
}

/// One error or warning, with its place.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Diagnostic {
    /// Severity.
    pub level: Level,
    /// The source file, relative to the workspace.
    pub file: String,
    /// Line, from 1; 0 if the diagnostic has no place.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
    /// Line and column after the last character; none: the token at the beginning is marked.
    pub end: Option<(u32, u32)>,
    /// Error code of rustc, such as `E0308`; empty for Bessemer's own errors.
    pub code: String,
    /// The mistake.
    pub message: String,
    /// Text of the label below the marked place.
    pub label: String,
    /// The remedy.
    pub help: String,
    /// A note.
    pub notes: Vec<String>,
    /// Further places that the diagnostic marks.
    pub also: Vec<Place>,
    /// The original message of rustc, if it is shown unchanged.
    pub rustc: Option<Box<Value>>,
}

/// A further place that a diagnostic marks.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Place {
    /// The source file, as of the diagnostic; empty for the same one.
    #[serde(default)]
    pub file: String,
    /// Line and column, from 1.
    pub start: (u32, u32),
    /// Line and column after the last character, in the same line; (0, 0): the token at the beginning is marked.
    pub end: (u32, u32),
    /// Text of the label below the place.
    pub label: String,
}

impl Place {
    /// Returns a diagnostic of this place alone, in a file.
    fn marked(&self, file: &str) -> Diagnostic {
        let ((line, column), end) = (self.start, Some(self.end).filter(|end| *end != (0, 0)));
        Diagnostic { file: file.to_owned(), line, column, end, ..Diagnostic::default() }
    }
}

/// All diagnostics of one run in order, rendered for a terminal and as JSON.
#[derive(Clone, Default)]
pub struct Told {
    /// The diagnostics.
    pub diagnostics: Vec<Diagnostic>,
    /// Text for a terminal.
    text: String,
    /// JSON for tools, one diagnostic per line.
    lines: String,
}

impl Told {
    /// Renders diagnostics with the source lines of `sources`.
    pub fn new(diagnostics: Vec<Diagnostic>, sources: &Sources, colour: bool) -> Told {
        let text = render(&diagnostics, sources, colour);
        let lines = diagnostics.iter().map(|it| format!("{}\n", json(it, sources))).collect();
        Told { diagnostics, text, lines }
    }

    /// Returns a message without a place, such as one from cargo.
    pub fn plain(text: String) -> Told {
        let said = Diagnostic { message: text.clone(), ..Diagnostic::default() };
        let lines = format!("{}\n", json(&said, &Sources::new("")));
        Told { diagnostics: Vec::new(), text, lines }
    }

    /// Returns one JSON object per line, in the format of `rustc --error-format=json`, which editors read.
    pub fn json_lines(&self) -> &str {
        &self.lines
    }
}

/// Prints the terminal text, since `main` prints an error that it returns by `Debug`.
impl fmt::Debug for Told {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        Display::fmt(self, f)
    }
}

impl Display for Told {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Renders diagnostics as rustc prints them, each with its source line.
pub fn render(diagnostics: &[Diagnostic], sources: &Sources, colour: bool) -> String {
    let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
    let mut text = String::new();
    for diagnostic in diagnostics {
        match &diagnostic.rustc {
            Some(said) => {
                let rendered = said["rendered"].as_str().unwrap_or_default();
                let rendered = if colour { rendered.to_owned() } else { uncoloured(rendered) };
                text.push_str(rendered.trim_end());
            }
            None => text.push_str(&render_one(diagnostic, sources, &renderer)),
        }
        text.push_str("\n\n");
    }
    text
}

fn render_one(diagnostic: &Diagnostic, sources: &Sources, renderer: &Renderer) -> String {
    let title = match diagnostic.level {
        Level::Error => Title::ERROR,
        Level::Warning => Title::WARNING,
    };
    let mut title = title.primary_title(diagnostic.message.as_str());
    if !diagnostic.code.is_empty() {
        title = title.id(diagnostic.code.as_str());
    }
    let mut group = Group::with_title(title);
    let text = sources.text(&diagnostic.file);
    if let Some(extent) = Extent::of(diagnostic, sources) {
        let mark = AnnotationKind::Primary.span(extent.start..extent.end);
        let label = Some(diagnostic.label.as_str()).filter(|label| !label.is_empty());
        let mut snippet =
            Snippet::source(text).path(diagnostic.file.as_str()).annotation(mark.label(label));
        let mut elsewhere = Vec::new();
        for place in &diagnostic.also {
            let is_here = place.file.is_empty() || place.file == diagnostic.file;
            let file = if is_here { &diagnostic.file } else { &place.file };
            let Some(marked) = Extent::of(&place.marked(file), sources) else { continue };
            let mark = AnnotationKind::Context.span(marked.start..marked.end);
            let mark = mark.label(place.label.as_str());
            match is_here {
                true => snippet = snippet.annotation(mark),
                false => elsewhere.push((file, mark)),
            }
        }
        group = group.element(snippet);
        for (file, mark) in elsewhere {
            let snippet = Snippet::source(sources.text(file)).path(file.as_str());
            group = group.element(snippet.annotation(mark));
        }
    }
    if !diagnostic.help.is_empty() {
        group = group.element(Title::HELP.message(diagnostic.help.as_str()));
    }
    for note in &diagnostic.notes {
        group = group.element(Title::NOTE.message(note.as_str()));
    }
    renderer.render(&[group])
}

/// Returns the diagnostic in rustc's JSON format; its field `rendered` has the terminal text.
pub fn json(diagnostic: &Diagnostic, sources: &Sources) -> Value {
    if let Some(said) = &diagnostic.rustc {
        let mut said = (**said).clone();
        said["rendered"] = uncoloured(said["rendered"].as_str().unwrap_or_default()).into();
        return said;
    }
    let child = |level: &str, message: &String| {
        json!({
            "message": message, "level": level, "code": null, "spans": [], "children": [], "rendered": null,
        })
    };
    let help = Some(&diagnostic.help).filter(|help| !help.is_empty());
    let children: Vec<Value> = help
        .map(|help| child("help", help))
        .into_iter()
        .chain(diagnostic.notes.iter().map(|note| child("note", note)))
        .collect();
    json!({
        "$message_type": "diagnostic",
        "message": diagnostic.message,
        "code": Some(&diagnostic.code)
            .filter(|code| !code.is_empty())
            .map(|code| json!({ "code": code, "explanation": null })),
        "level": diagnostic.level.word(),
        "spans": spans(diagnostic, sources),
        "children": children,
        "rendered": render(std::slice::from_ref(diagnostic), sources, false),
    })
}

/// Returns the marked places: the diagnostic's own, then further ones.
fn spans(diagnostic: &Diagnostic, sources: &Sources) -> Vec<Value> {
    let own = Extent::of(diagnostic, sources).map(|extent| extent.json(diagnostic, sources, true));
    let further = diagnostic.also.iter().filter_map(|place| {
        let file = if place.file.is_empty() { &diagnostic.file } else { &place.file };
        let marked = Diagnostic { label: place.label.clone(), ..place.marked(file) };
        Some(Extent::of(&marked, sources)?.json(&marked, sources, false))
    });
    own.into_iter().chain(further).collect()
}

/// Byte range that a diagnostic marks in its file.
struct Extent {
    start: usize,
    end: usize,
    /// Line and column after the mark.
    behind: (u32, u32),
}

impl Extent {
    fn of(diagnostic: &Diagnostic, sources: &Sources) -> Option<Extent> {
        let (file, line, column) = (&diagnostic.file, diagnostic.line, diagnostic.column);
        let start = Extent::byte(sources, file, line, column)?;
        let behind = match diagnostic.end {
            Some(end) if end > (line, column) => end,
            _ => {
                let text = sources.line(file, line)?;
                let text = &text[byte(&text, column)..];
                let marked = &text[..extent::length(text)];
                (line, column + marked.chars().count() as u32)
            }
        };
        let end = Extent::byte(sources, file, behind.0, behind.1)?;
        Some(Extent { start, end: end.max(start), behind })
    }

    fn byte(sources: &Sources, file: &str, line: u32, column: u32) -> Option<usize> {
        Some(sources.offset(file, line) + byte(&sources.line(file, line)?, column))
    }

    fn json(&self, diagnostic: &Diagnostic, sources: &Sources, is_primary: bool) -> Value {
        let (line, column) = self.behind;
        let text: Vec<Value> = (diagnostic.line..=line)
            .filter_map(|number| {
                let text = sources.line(&diagnostic.file, number)?;
                let all = text.chars().count() as u32 + 1;
                let start = if number == diagnostic.line { diagnostic.column } else { 1 };
                let end = if number == line { column } else { all };
                Some(json!({ "text": text, "highlight_start": start, "highlight_end": end }))
            })
            .collect();
        json!({
            "file_name": diagnostic.file,
            "byte_start": self.start,
            "byte_end": self.end,
            "line_start": diagnostic.line,
            "line_end": line,
            "column_start": diagnostic.column,
            "column_end": column,
            "is_primary": is_primary,
            "text": text,
            "label": Some(&diagnostic.label).filter(|label| !label.is_empty()),
            "suggested_replacement": null,
            "suggestion_applicability": null,
            "expansion": null,
        })
    }
}

/// Returns the byte offset of a column, counted in characters from 1.
fn byte(line: &str, column: u32) -> usize {
    let mut starts = line.char_indices();
    starts.nth(column.saturating_sub(1) as usize).map_or(line.len(), |(index, _)| index)
}

/// Returns a text without colour sequences (`ESC [ … m`).
fn uncoloured(coloured: &str) -> String {
    let mut text = String::new();
    let mut rest = coloured;
    while let Some((before, after)) = rest.split_once('\u{1b}') {
        text.push_str(before);
        rest = after.split_once('m').map_or("", |(_, rest)| rest);
    }
    text + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tools show each place that the terminal shows, in whichever file it is.
    #[test]
    fn json_has_each_marked_place() {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("one.rs"), "fn unit() {}\n").expect("a file");
        std::fs::write(folder.path().join("two.rs"), "\nfn unit() {}\nfn other() {}\n")
            .expect("a file");
        let place = |file: &str, start, end, label: &str| Place {
            file: file.to_owned(),
            start,
            end,
            label: label.to_owned(),
        };
        let diagnostic = Diagnostic {
            file: "one.rs".to_owned(),
            line: 1,
            column: 4,
            also: vec![
                place("two.rs", (2, 4), (0, 0), "also here"),
                place("", (1, 1), (1, 3), "in this file"),
            ],
            ..Diagnostic::default()
        };
        let json = json(&diagnostic, &Sources::new(folder.path()));
        let spans = json["spans"].as_array().expect("spans");
        let shown = |span: &Value| {
            let number = |key: &str| span[key].as_u64().expect("a number");
            let file = span["file_name"].as_str().expect("a file").to_owned();
            let label = span["label"].as_str().unwrap_or_default().to_owned();
            let bytes = (number("byte_start"), number("byte_end"));
            (file, number("line_start"), bytes, span["is_primary"] == true, label)
        };
        let shown: Vec<_> = spans.iter().map(shown).collect();
        let expected = [
            ("one.rs", 1, (3, 9), true, ""),
            ("two.rs", 2, (4, 10), false, "also here"),
            ("one.rs", 1, (0, 2), false, "in this file"),
        ];
        let expected = expected.map(|(file, line, bytes, primary, label)| {
            (file.to_owned(), line, bytes, primary, label.to_owned())
        });
        assert_eq!(shown, expected);
    }
}
