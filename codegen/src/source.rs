//! The author's source files: for diagnostics, and for the `//` comments that no macro can see.

use std::cell::RefCell;
use std::collections::HashMap;
use std::path::PathBuf;
use std::rc::Rc;

/// Source files below a root, each read once.
pub struct Sources {
    root: PathBuf,
    files: RefCell<HashMap<String, Rc<[String]>>>,
}

impl Sources {
    /// Files named relative to `root`.
    pub fn new(root: impl Into<PathBuf>) -> Sources {
        Sources { root: root.into(), files: RefCell::default() }
    }

    /// The lines of `file`; none if it cannot be read.
    fn lines(&self, file: &str) -> Rc<[String]> {
        let mut files = self.files.borrow_mut();
        files
            .entry(file.to_owned())
            .or_insert_with(|| {
                let text = std::fs::read_to_string(self.root.join(file)).unwrap_or_default();
                text.lines().map(str::to_owned).collect()
            })
            .clone()
    }

    /// A line, counted from 1.
    pub fn line(&self, file: &str, line: u32) -> Option<String> {
        self.lines(file).get((line as usize).checked_sub(1)?).cloned()
    }

    /// The `//` lines right above `line`, without the slashes.
    pub fn comments_above(&self, file: &str, line: u32) -> Vec<String> {
        let lines = self.lines(file);
        let above = lines.get(..(line as usize).saturating_sub(1)).unwrap_or_default();
        let mut comments: Vec<String> =
            above.iter().rev().map_while(|line| comment(line)).map(str::to_owned).collect();
        comments.reverse();
        comments
    }
}

/// The text of a line that is an ordinary comment and nothing else.
fn comment(line: &str) -> Option<&str> {
    let text = line.trim_start().strip_prefix("//")?;
    if text.starts_with(['/', '!']) {
        return None;
    }
    Some(text.strip_prefix(' ').unwrap_or(text).trim_end())
}
