//! Remedies that need the declaration of a name: a loop's variable, the order of `enumerate`, the variants of an enum.
//!
//! Must not know: the DSL's items; a remedy here is plain Rust.

use bessemer_frontend::diagnostic::Place;
use bessemer_frontend::source::Sources;

use super::causes::Item;
use super::rustc::{Mark, Message};

/// The remedy, and the place of the declaration.
pub struct Declared {
    /// Text of the remedy.
    pub help: String,
    /// Place of the declaration, with a label.
    pub at: Option<Place>,
}

/// Returns the remedy for an error about a name that is declared above; none if the error is of another kind.
pub fn of(message: &Message<'_>, sources: &Sources) -> Option<Declared> {
    let mark = message.mark()?;
    match message.code {
        "E0425" if message.title.starts_with("cannot find value") => ended(mark, sources),
        "E0599" if message.title.starts_with("no variant ") => variants(message, sources),
        "E0277" | "E0308" | "E0606" => numbered(message, mark, sources),
        _ => None,
    }
}

/// Returns the remedy for a variable that ended with its loop.
fn ended(mark: &Mark<'_>, sources: &Sources) -> Option<Declared> {
    let name = mark.text();
    let is_bound = |names: &str| words(names).any(|it| it == name);
    let (line, text) =
        loops(mark, sources).find(|(_, text)| names_of_loop(text).is_some_and(is_bound))?;
    let help = format!(
        "a variable of a loop ends with the loop: declare another before it, `let mut last = 0;`, and assign it inside, `last = {name};`"
    );
    Some(Declared { help, at: place(line, &text, &name, "ends with this loop") })
}

/// Returns the remedy for the index of `enumerate` in place of the element, or the reverse.
fn numbered(message: &Message<'_>, mark: &Mark<'_>, sources: &Sources) -> Option<Declared> {
    let is_about_index = message.title.contains("`usize`") || mark.label.contains("`usize`");
    let is_about_element = message.title.contains("`&") || mark.label.contains("`&");
    let used: Vec<String> =
        words(&mark.line.chars().take(mark.end.1 as usize - 1).collect::<String>())
            .map(str::to_owned)
            .collect();
    let (line, text) = loops(mark, sources).find(|(_, text)| text.contains(".enumerate()"))?;
    let names = names_of_loop(&text)?;
    let (first, second) = names.trim().strip_prefix('(')?.strip_suffix(')')?.split_once(',')?;
    let (first, second) = (first.trim(), second.trim());
    let is_used = |name: &str| used.iter().any(|it| it == name);
    // By their names, and by their uses.
    let is_swapped = !is_index(first) && is_index(second);
    let is_seen = is_about_index && is_used(first) || is_about_element && is_used(second);
    let help = format!("`enumerate` gives the index first: write `for ({second}, {first}) in …`");
    (is_swapped && is_seen)
        .then(|| Declared { help, at: place(line, &text, first, "this is the index") })
}

/// Returns true for a usual name of an index.
fn is_index(name: &str) -> bool {
    matches!(name, "i" | "j" | "k" | "n" | "at" | "index" | "idx")
}

/// Returns the variants of an enum without the one that is named.
fn variants(message: &Message<'_>, sources: &Sources) -> Option<Declared> {
    let of = message.marks.iter().find(|it| it.label.ends_with("not found for this enum"))?;
    let below = (of.start.0 + 1..).map_while(|line| sources.line(of.file, line));
    let below = below.take_while(|text| !text.trim_start().starts_with('}'));
    let variants = below.filter_map(|text| {
        let text = text.trim_start();
        let name = words(text).next()?;
        text.starts_with(char::is_uppercase).then(|| format!("`{name}`"))
    });
    let variants: Vec<String> = variants.collect();
    (!variants.is_empty())
        .then(|| Declared { help: format!("its variants are {}", variants.join(", ")), at: None })
}

/// Returns the lines with a loop above a mark in its function, the nearest first.
fn loops(mark: &Mark<'_>, sources: &Sources) -> impl Iterator<Item = (u32, String)> {
    let (file, first) = (mark.file.to_owned(), *Item::around(mark, sources).lines().start());
    let lines = (first..=mark.start.0).rev();
    let lines = lines.filter_map(move |line| Some((line, sources.line(&file, line)?)));
    lines.filter(|(_, text)| text.trim_start().starts_with("for "))
}

/// Returns the pattern of a `for`.
fn names_of_loop(text: &str) -> Option<&str> {
    text.trim_start().strip_prefix("for ")?.split(" in ").next()
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|it: char| !it.is_alphanumeric() && it != '_').filter(|it| !it.is_empty())
}

fn place(line: u32, text: &str, name: &str, label: &str) -> Option<Place> {
    let start = text[..text.find(name)?].chars().count() as u32 + 1;
    let end = (line, start + name.chars().count() as u32);
    Some(Place { start: (line, start), end, label: label.to_owned(), ..Place::default() })
}
