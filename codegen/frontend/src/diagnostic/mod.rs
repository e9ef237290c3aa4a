//! A message of the compiler to the author: a place in the source, a text, and a remedy.
//!
//! Every stage that refuses something gives these, and what rustc says of a model becomes one, too; only [`render`]
//! knows how they look, and [`json`] what tools read. Both are rustc's own forms.

mod extent;

use std::fmt::{self, Display, Formatter};

use annotate_snippets::{AnnotationKind, Group, Level as Title, Renderer, Snippet};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::source::Sources;

/// The remedy where the tool contradicts itself.
pub const OUR_FAULT: &str = "this is a fault of Bessemer; please report it with this line";

/// Severity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Level {
    /// No C is made.
    #[default]
    Error,
    /// The C is made, and may not be what its author expects.
    Warning,
}

impl Level {
    /// rustc's word for it.
    pub fn word(self) -> &'static str {
        match self {
            Level::Error => "error",
            Level::Warning => "warning",
        }
    }
}

/// One thing that is wrong, and where.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Diagnostic {
    /// Severity.
    pub level: Level,
    /// The source file, relative to the workspace.
    pub file: String,
    /// Line, from 1; 0: nowhere in particular.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
    /// Line and column behind it; none: the token that stands there.
    pub end: Option<(u32, u32)>,
    /// rustc's number of the error, where it is one of rustc's.
    pub code: String,
    /// The mistake.
    pub message: String,
    /// The label below the place that is marked.
    pub label: String,
    /// The remedy.
    pub help: String,
    /// A note.
    pub notes: Vec<String>,
    /// Other places of the same file that have to do with it.
    pub also: Vec<Place>,
    /// rustc's own message, where nothing of it is reworded.
    pub rustc: Option<Box<Value>>,
}

/// A place beside the one that a diagnostic is about.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Place {
    /// Line and column, from 1.
    pub start: (u32, u32),
    /// Those behind it, in the same line.
    pub end: (u32, u32),
    /// The label below it.
    pub label: String,
}

/// The diagnostics for an author, in order, and their look.
#[derive(Clone, Default)]
pub struct Told {
    /// One by one.
    pub diagnostics: Vec<Diagnostic>,
    /// As a terminal shows them.
    text: String,
    /// As tools read them, one a line.
    lines: String,
}

impl Told {
    /// These, with the lines of `sources` under each.
    pub fn new(diagnostics: Vec<Diagnostic>, sources: &Sources, colour: bool) -> Told {
        let text = render(&diagnostics, sources, colour);
        let lines = diagnostics.iter().map(|it| format!("{}\n", json(it, sources))).collect();
        Told { diagnostics, text, lines }
    }

    /// A message without a place: from cargo or from a program.
    pub fn plain(text: String) -> Told {
        let said = Diagnostic { message: text.clone(), ..Diagnostic::default() };
        let lines = format!("{}\n", json(&said, &Sources::new("")));
        Told { diagnostics: Vec::new(), text, lines }
    }

    /// As `rustc --error-format=json` has them, one a line: what editors read.
    pub fn json_lines(&self) -> &str {
        &self.lines
    }
}

/// As a terminal shows it: what `main` prints of an error that it gives.
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

/// The diagnostics as rustc would print them, the source line under each.
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
        for place in &diagnostic.also {
            let at = |(line, column)| Extent::byte(sources, &diagnostic.file, line, column);
            if let (Some(start), Some(end)) = (at(place.start), at(place.end)) {
                let mark = AnnotationKind::Context.span(start..end.max(start));
                snippet = snippet.annotation(mark.label(place.label.as_str()));
            }
        }
        group = group.element(snippet);
    }
    if !diagnostic.help.is_empty() {
        group = group.element(Title::HELP.message(diagnostic.help.as_str()));
    }
    for note in &diagnostic.notes {
        group = group.element(Title::NOTE.message(note.as_str()));
    }
    renderer.render(&[group])
}

/// The diagnostic as rustc writes one in JSON; `rendered` is how a terminal shows it.
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
        "spans": Extent::of(diagnostic, sources).map(|extent| extent.json(diagnostic, sources)).into_iter().collect::<Vec<_>>(),
        "children": children,
        "rendered": render(std::slice::from_ref(diagnostic), sources, false),
    })
}

/// The range that a diagnostic marks, in bytes of its file.
struct Extent {
    start: usize,
    end: usize,
    /// Line and column behind the mark.
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

    fn json(&self, diagnostic: &Diagnostic, sources: &Sources) -> Value {
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
            "is_primary": true,
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

/// Text without the sequences that colour it, ESC [ … m.
fn uncoloured(coloured: &str) -> String {
    let mut text = String::new();
    let mut rest = coloured;
    while let Some((before, after)) = rest.split_once('\u{1b}') {
        text.push_str(before);
        rest = after.split_once('m').map_or("", |(_, rest)| rest);
    }
    text + rest
}
