//! Rewords an error about a type that the DSL does not support.
//!
//! The type at fault is the innermost one. If the author declares it, the remedy is to mark it.
//!
//! Must not know: where the type is named ([`place`]).

use super::place;
use super::rustc::{Mark, Message};
use super::types;
use super::wording::{Once, Words, words};
use bessemer_frontend::source::Sources;

/// Returns the rewording of an error about an unsupported type; none for other messages.
pub fn of(message: &Message<'_>, sources: &Sources) -> Option<Words> {
    let is_constant = message.title.starts_with("a constant of the type `");
    let is_ours = is_constant
        || message.title.ends_with("is not a type of the DSL")
        || message.title.ends_with("is not a type that a model can hold");
    if !message.is_error || !is_ours {
        return None;
    }
    let full = *message.quoted().first()?;
    let marked = message.marked_below().find(|it| it.is_authors());
    let within = unmarked_within(full, message, sources).filter(|_| marked.is_none());
    let is_declared = marked.is_some() || within.is_some();
    let inner = within.as_deref().unwrap_or_else(|| types::innermost(full));
    let name = types::name(inner);
    let iterator = types::iterator(inner).filter(|_| !is_declared);
    let help = match (types::instead(inner).or(iterator), &marked) {
        (Some(help), _) => help.to_owned(),
        (None, Some(mark)) if mark.line.contains('!') && !is_declaration(mark) => format!(
            "`{}` declares it, and an item of a macro cannot be marked: declare `#[data] struct {name}(u16);` with methods that shift and mask, or a struct of the fields",
            made_by(mark)
        ),
        _ if is_declared => format!("mark `{name}` `#[data]`"),
        // rustc's message about a constant has the remedy.
        _ if is_constant => return None,
        _ if full.starts_with("{closure") || full.contains(" {") || full.starts_with("fn(") => {
            "call it, or pass it to a function that takes `impl Fn(f64) -> f64`".to_owned()
        }
        _ => "the DSL has scalars, arrays, nalgebra's `SMatrix` and `SVector`, and types marked `#[data]` or `#[component]`".to_owned(),
    };
    let written = types::written(inner);
    let shown = if is_declared { name } else { types::within_modules(&written) };
    let mut reported = words(format!("`{shown}` is not a type of the DSL"), help)?;
    reported.of_type = Some(name.to_owned());
    // To mark it once mends each use.
    reported.once = if is_declared { Once::File } else { Once::Item };
    Some(reported)
}

/// Returns the type in `full`, such as `Sample` in `List<Sample, 4>`, that the author declares in the file of the error and
/// has not marked.
fn unmarked_within(full: &str, message: &Message<'_>, sources: &Sources) -> Option<String> {
    let file = message.mark()?.file;
    let mut names = full.split(|it: char| !it.is_alphanumeric() && it != '_');
    let is_unmarked = |name: &&str| place::is_unmarked(name, file, sources);
    names.find(is_unmarked).map(str::to_owned)
}

/// Returns true if a marked line begins a struct or an enum of the author's, not a macro that makes one.
fn is_declaration(mark: &Mark<'_>) -> bool {
    let mut words = mark.line.split(|it: char| !it.is_alphanumeric() && it != '_');
    words.any(|it| ["struct", "enum", "union"].contains(&it)) && !mark.line.contains('!')
}

/// Returns the macro in a marked line.
fn made_by<'a>(mark: &'a Mark<'_>) -> &'a str {
    let end = mark.line.find('!').map_or(mark.line.len(), |at| at + 1);
    mark.line[..end].trim()
}

#[cfg(test)]
mod tests {
    use bessemer_frontend::source::Sources;
    use serde_json::json;

    use super::super::reported;

    #[test]
    fn a_type_that_a_macro_of_a_crate_declares_is_not_to_be_marked() {
        let at = |line: u32, text: &str, is_primary: bool| {
            json!([{
                "file_name": "lib.rs", "line_start": line, "line_end": line, "column_start": 1,
                "column_end": 9, "is_primary": is_primary, "label": "", "text": [{ "text": text }],
            }])
        };
        let declared = json!([{
            "level": "help", "message": "the trait is not implemented for `Status`",
            "spans": at(1, "bitfield! {", true),
        }]);
        let error = json!({ "reason": "compiler-message", "message": {
            "message": "`Status` is not a type of the DSL", "level": "error",
            "code": { "code": "E0277" }, "spans": at(9, "    pub status: Status,", true),
            "children": declared, "rendered": "",
        }});
        let folder = tempfile::tempdir().expect("a folder");
        let reported = reported(&[error], &Sources::new(folder.path()));
        assert_eq!(reported.len(), 1);
        assert_eq!(reported[0].message, "`Status` is not a type of the DSL");
        assert!(reported[0].help.contains("declare `#[data] struct Status(u16);`"));
        assert!(!reported[0].help.contains("mark `Status`"));
    }
}
