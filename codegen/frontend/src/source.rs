//! Author's source files. Diagnostics quote their lines, and they contain what no macro sees: `//` comments, and the
//! expressions of a `Default`.

mod defaults;

use std::collections::{BTreeSet, HashMap};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Source files below a root; each is read once.
pub struct Sources {
    root: PathBuf,
    files: Mutex<HashMap<String, Arc<File>>>,
}

/// A file, and the names that its imports define.
struct File {
    lines: Vec<String>,
    /// Names that a `use … as` of the file defines.
    renamed: OnceLock<BTreeSet<String>>,
}

impl Sources {
    /// Creates a reader of files that are named relative to `root`.
    pub fn new(root: impl Into<PathBuf>) -> Sources {
        Sources { root: root.into(), files: Mutex::default() }
    }

    /// Returns a file; without lines if it cannot be read.
    fn file(&self, file: &str) -> Arc<File> {
        let mut files = self.files.lock().unwrap_or_else(PoisonError::into_inner);
        files
            .entry(file.to_owned())
            .or_insert_with(|| {
                let text = std::fs::read_to_string(self.root.join(file)).unwrap_or_default();
                let lines = text.lines().map(str::to_owned).collect();
                Arc::new(File { lines, renamed: OnceLock::new() })
            })
            .clone()
    }

    /// Returns a line, counted from 1.
    pub fn line(&self, file: &str, line: u32) -> Option<String> {
        self.file(file).lines.get((line as usize).checked_sub(1)?).cloned()
    }

    /// Returns line and column of a field, by its name in the struct that begins in a line.
    pub fn field(&self, file: &str, item: u32, name: &str) -> Option<(u32, u32)> {
        let file = self.file(file);
        let lines = (item..).zip(file.lines.get((item as usize).checked_sub(1)?..)?);
        let own = lines.take_while(|(line, text)| *line == item || !text.starts_with('}'));
        let begins = |text: &str| {
            let at = text.find(&format!("{name}:")).filter(|at| {
                !text[..*at].contains("//")
                    && !text[..*at].ends_with(|it: char| it.is_alphanumeric() || it == '_')
            });
            at.map(|at| text[..at].chars().count() as u32 + 1)
        };
        let mut places = own.filter_map(|(line, text)| Some((line, begins(text)?)));
        places.next()
    }

    /// Returns the text of a file; empty if it cannot be read.
    pub fn text(&self, file: &str) -> String {
        std::fs::read_to_string(self.root.join(file)).unwrap_or_default()
    }

    /// Returns the number of bytes before a line, counted from 1.
    pub fn offset(&self, file: &str, line: u32) -> usize {
        let text = self.text(file);
        let lines = text.split_inclusive('\n').take((line as usize).saturating_sub(1));
        lines.map(str::len).sum()
    }

    /// Returns the `//` lines directly above `line`, without the slashes.
    pub fn comments_above(&self, file: &str, line: u32) -> Vec<String> {
        let file = self.file(file);
        let above = file.lines.get(..(line as usize).saturating_sub(1)).unwrap_or_default();
        let mut comments: Vec<String> =
            above.iter().rev().map_while(|line| comment(line)).map(str::to_owned).collect();
        comments.reverse();
        comments
    }

    /// Returns the `//!` comment at the head of a file, up to a heading or an example. As in comments of items, the
    /// space after the mark is kept.
    pub fn about(&self, file: &str) -> Vec<String> {
        let file = self.file(file);
        // A licence may stand above.
        let above = |line: &&String| line.is_empty() || comment(line).is_some();
        let said = file.lines.iter().skip_while(above).map_while(|line| line.strip_prefix("//!"));
        let text = |line: &&str| !line.starts_with(" #") && !line.starts_with(" ```");
        let mut about: Vec<String> =
            said.map(str::trim_end).take_while(text).map(str::to_owned).collect();
        while about.last().is_some_and(String::is_empty) {
            about.pop();
        }
        about
    }

    /// Returns the fields that the `impl Default` of a struct in `file` computes, each with the author's expression.
    pub fn computed_defaults(&self, file: &str, name: &str) -> Vec<(String, String)> {
        defaults::computed(&self.file(file).lines.join("\n"), name)
    }

    /// Returns true if a `use` in `file` renames an item to `name`.
    pub fn renames(&self, file: &str, name: &str) -> bool {
        let file = self.file(file);
        file.renamed.get_or_init(|| renamed(&file.lines)).contains(name)
    }
}

/// Returns the names that `use … as` defines: the word after each `as` between `use` and `;`.
fn renamed(lines: &[String]) -> BTreeSet<String> {
    let code = |line: &String| line.split("//").next().unwrap_or_default().to_owned();
    let text = lines.iter().map(code).collect::<Vec<_>>().join(" ");
    let mut names = BTreeSet::new();
    for statement in text.split(';') {
        let words = statement.split(|it: char| !it.is_alphanumeric() && it != '_');
        let words: Vec<&str> =
            words.filter(|word| !word.is_empty()).skip_while(|word| *word != "use").collect();
        let given = words.windows(2).filter(|pair| pair[0] == "as").map(|pair| pair[1].to_owned());
        names.extend(given);
    }
    names
}

/// Returns the text of a line that contains only an ordinary comment.
fn comment(line: &str) -> Option<&str> {
    let text = line.trim_start().strip_prefix("//")?;
    if text.starts_with(['/', '!']) {
        return None;
    }
    Some(text.strip_prefix(' ').unwrap_or(text).trim_end())
}

#[cfg(test)]
mod tests {
    use super::Sources;

    /// The description of a file ends at a heading or an example.
    #[test]
    fn a_file_says_what_it_is_about() -> std::io::Result<()> {
        let folder = tempfile::tempdir()?;
        let sources = |text: &str| -> std::io::Result<Vec<String>> {
            std::fs::write(folder.path().join("lib.rs"), text)?;
            Ok(Sources::new(folder.path()).about("lib.rs"))
        };
        assert_eq!(
            sources("// A licence.\n\n//! One.\n//!\n//! Two.\nfn f() {}\n//! No.")?,
            [" One.", "", " Two."]
        );
        assert_eq!(sources("//! One.\n//!\n//! # Two\n//! Three.")?, [" One."]);
        assert_eq!(sources("//! One.\n//! ```\n//! two();\n//! ```")?, [" One."]);
        assert!(sources("/// One.\nfn f() {}")?.is_empty());
        Ok(())
    }

    /// A `use` renames; a cast by `as` does not.
    #[test]
    fn a_use_renames() -> std::io::Result<()> {
        let folder = tempfile::tempdir()?;
        let text = "use a::{B as C, D as\n    E}; // as F\nfn f(x: u8) { g(x as H); use i as J; }";
        std::fs::write(folder.path().join("lib.rs"), text)?;
        let sources = Sources::new(folder.path());
        let renamed = |name| sources.renames("lib.rs", name);
        assert_eq!(["C", "E", "J"].map(renamed), [true; 3]);
        assert_eq!(["B", "D", "F", "H", "i"].map(renamed), [false; 5]);
        Ok(())
    }
}
