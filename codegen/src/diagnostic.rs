//! What the compiler tells the author: a message at a place in the source, and a remedy.
//!
//! Every stage that refuses something gives these; only [`render`] knows how they look.

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

use crate::source::Sources;

/// The remedy where the tool contradicts itself.
pub const OUR_FAULT: &str = "this is a fault of Bessemer; please report it with this line";

/// One thing that is wrong, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The source file, relative to the workspace.
    pub file: String,
    /// Line, from 1; 0: nowhere in particular.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
    /// What is wrong.
    pub message: String,
    /// What to write instead.
    pub help: String,
}

/// The diagnostics as rustc would print them, the source line under each.
pub fn render(diagnostics: &[Diagnostic], sources: &Sources, colour: bool) -> String {
    let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
    let mut text = String::new();
    for diagnostic in diagnostics {
        text.push_str(&render_one(diagnostic, sources, &renderer));
        text.push_str("\n\n");
    }
    text
}

fn render_one(diagnostic: &Diagnostic, sources: &Sources, renderer: &Renderer) -> String {
    let title = Level::ERROR.primary_title(diagnostic.message.as_str());
    let mut group = Group::with_title(title);
    if let Some(line) = sources.line(&diagnostic.file, diagnostic.line) {
        let start = line
            .char_indices()
            .nth(diagnostic.column.saturating_sub(1) as usize)
            .map_or(line.len(), |(index, _)| index);
        let length = token_length(&line[start..]);
        let mark = AnnotationKind::Primary.span(start..start + length);
        group = group.element(
            Snippet::source(line)
                .path(diagnostic.file.as_str())
                .line_start(diagnostic.line as usize)
                .annotation(mark),
        );
    }
    if !diagnostic.help.is_empty() {
        group = group.element(Level::HELP.message(diagnostic.help.as_str()));
    }
    renderer.render(&[group])
}

/// The bytes of the token that `text` begins with.
fn token_length(text: &str) -> usize {
    let word = |c: char| c.is_alphanumeric() || c == '_' || c == '.' || c == ':';
    let length = text.find(|c: char| !word(c)).unwrap_or(text.len());
    if length == 0 { text.chars().next().map_or(0, char::len_utf8) } else { length }
}
