//! Parses rustc's messages from JSON.
//!
//! Must not know: the DSL.

use serde_json::Value;

/// A message of rustc about the author's code.
pub struct Message<'a> {
    /// Message in rustc's JSON.
    pub value: &'a Value,
    /// First line.
    pub title: &'a str,
    /// Code `E0599`, or the name of a lint; empty for a message of an attribute macro.
    pub code: &'a str,
    /// True for an error, false for a warning.
    pub is_error: bool,
    /// Marked places, the primary ones first.
    pub marks: Vec<Mark<'a>>,
    /// Text as rustc prints it.
    pub rendered: &'a str,
}

/// A place that a message marks.
#[derive(Clone)]
pub struct Mark<'a> {
    /// The file, relative to the workspace.
    pub file: &'a str,
    /// Line and column, from 1.
    pub start: (u32, u32),
    /// Line and column after the last character.
    pub end: (u32, u32),
    /// True for the primary span of the message.
    pub is_primary: bool,
    /// Label of rustc; empty if there is none.
    pub label: &'a str,
    /// Source line of its first line.
    pub line: &'a str,
}

impl<'a> Message<'a> {
    /// Parses an error or a warning in cargo's messages; none for a summary without a place.
    pub fn of(message: &'a Value) -> Option<Message<'a>> {
        let value = message.get("message").filter(|message| message.is_object())?;
        let title = value["message"].as_str()?;
        let mut marks: Vec<Mark<'a>> =
            value["spans"].as_array().into_iter().flatten().map(Mark::of).collect();
        marks.sort_by_key(|mark| !mark.is_primary);
        let level = value["level"].as_str().unwrap_or_default();
        let is_summary =
            marks.is_empty() && (title.starts_with("aborting") || title.ends_with(" emitted"));
        (matches!(level, "error" | "warning") && !is_summary).then(|| Message {
            value,
            title,
            code: value["code"]["code"].as_str().unwrap_or_default(),
            is_error: level == "error",
            marks,
            rendered: value["rendered"].as_str().unwrap_or(title),
        })
    }

    /// Returns the first primary place.
    pub fn mark(&self) -> Option<&Mark<'a>> {
        self.marks.first().filter(|mark| mark.is_primary)
    }

    /// Returns the words between backquotes in the title.
    pub fn quoted(&self) -> Vec<&'a str> {
        self.title.split('`').skip(1).step_by(2).collect()
    }

    /// Returns the texts of its notes and helps.
    pub fn below(&self) -> impl Iterator<Item = &'a str> {
        self.children().filter_map(|child| child["message"].as_str())
    }

    /// Returns the places that its notes and helps mark.
    pub fn marked_below(&self) -> impl Iterator<Item = Mark<'a>> {
        self.children()
            .flat_map(|child| child["spans"].as_array().into_iter().flatten())
            .map(Mark::of)
    }

    fn children(&self) -> impl Iterator<Item = &'a Value> {
        self.value["children"].as_array().into_iter().flatten()
    }

    /// Returns true if the message shows code that no author of a model has written: sources of libraries, and lists of
    /// their types.
    pub fn shows_internals(&self) -> bool {
        let foreign = |mark: &Mark<'_>| !mark.is_authors();
        let lists = |text: &str| {
            text.contains("other types implement") || text.contains("has been written to")
        };
        self.marks.iter().any(foreign)
            || self.marked_below().any(|mark| foreign(&mark))
            || self.below().any(lists)
    }

    /// Returns the notes of a DSL trait that a type does not implement.
    pub fn own_notes(&self) -> Vec<String> {
        const OTHERS: [&str; 5] =
            ["required ", "the full name ", "consider using ", "this error ", "the following "];
        if !self.below().any(|it| it.contains("bessemer::generate")) {
            return Vec::new();
        }
        let notes = self.children().filter(|child| child["level"] == "note");
        let notes = notes.filter_map(|child| child["message"].as_str());
        notes
            .filter(|it| !OTHERS.iter().any(|other| it.starts_with(other)))
            .map(str::to_owned)
            .collect()
    }

    /// Returns a help in the form of a sentence about the author's code, without a place or with one in it.
    pub fn own_help(&self) -> Option<String> {
        let is_own = |child: &&Value| {
            child["level"] == "help"
                && child["spans"]
                    .as_array()
                    .into_iter()
                    .flatten()
                    .all(|it| Mark::of(it).is_authors())
        };
        let suggested = |child: &Value| {
            child["spans"][0]["suggested_replacement"].as_str().map(|it| it.trim().to_owned())
        };
        let reported = |child: &Value| {
            let text = child["message"].as_str()?;
            if text.contains("trait `") || text.contains("other types") || text.contains('\n') {
                return None;
            }
            Some(match suggested(child).filter(|it| !it.is_empty()) {
                Some(code) if !text.contains(&format!("`{code}`")) => format!("{text}: `{code}`"),
                _ => text.to_owned(),
            })
        };
        self.children().filter(is_own).find_map(reported)
    }
}

impl<'a> Mark<'a> {
    fn of(span: &'a Value) -> Mark<'a> {
        let number = |key: &str| span[key].as_u64().unwrap_or_default() as u32;
        Mark {
            file: span["file_name"].as_str().unwrap_or_default(),
            start: (number("line_start"), number("column_start")),
            end: (number("line_end"), number("column_end")),
            is_primary: span["is_primary"] == true,
            label: span["label"].as_str().unwrap_or_default(),
            line: span["text"][0]["text"].as_str().unwrap_or_default(),
        }
    }

    /// Returns true if the file is in the author's workspace, by rustc's path; the DSL's sources and those of
    /// dependencies are not.
    pub fn is_authors(&self) -> bool {
        !self.file.starts_with(['/', '<']) && !self.file.starts_with("dsl/")
    }

    /// Returns true if it is within one line of `file`.
    pub fn is_short_in(&self, file: &str) -> bool {
        self.file == file && self.start.0 == self.end.0
    }

    /// Returns true if it is an attribute, which represents code that no author wrote.
    pub fn is_attribute(&self) -> bool {
        self.line.trim_start().starts_with("#[")
    }

    /// Returns the marked source text in its first line.
    pub fn text(&self) -> String {
        let start = self.start.1.saturating_sub(1) as usize;
        let all = self.line.chars().count();
        let end = if self.end.0 == self.start.0 { self.end.1 as usize - 1 } else { all };
        self.line.chars().skip(start).take(end.saturating_sub(start)).collect()
    }

    /// Returns the text before it in its line.
    pub fn before(&self) -> String {
        self.line.chars().take(self.start.1.saturating_sub(1) as usize).collect()
    }

    /// Returns the text after it in its line.
    pub fn rest(&self) -> String {
        self.line.chars().skip(self.end.1.saturating_sub(1) as usize).collect()
    }
}
