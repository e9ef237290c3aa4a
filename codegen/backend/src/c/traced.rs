//! Comments that name the line of Rust behind each line of the C, as its map has it.
//!
//! Invariants: a comment ends a line, so no line moves and the map holds; lines within a comment, and lines that the next
//! one continues, have none.

use super::file::CFile;

/// Adds the comments to a file.
pub fn written(file: &mut CFile) {
    let mut rows = file.map.iter().peekable();
    let mut text = String::with_capacity(2 * file.text.len());
    let mut in_comment = false;
    for (line, number) in file.text.split_inclusive('\n').zip(1..) {
        let mut own = None;
        while let Some(row) = rows.next_if(|row| row.c_line <= number) {
            own = (row.c_line == number).then_some(row).or(own);
        }
        in_comment = ends_in_comment(line, in_comment);
        let code = line.trim_end();
        match own.filter(|_| !in_comment && !code.is_empty() && !code.ends_with('\\')) {
            Some(row) => {
                // A path cannot end the comment.
                let place = row.rust_file.replace("*/", "* /");
                text.push_str(&format!("{code} /* {place}:{} */\n", row.rust_line));
            }
            None => text.push_str(line),
        }
    }
    file.text = text;
}

/// Returns true if a line ends within a comment.
fn ends_in_comment(line: &str, mut inside: bool) -> bool {
    let (mut rest, mut quote) = (line, None);
    while let Some(letter) = rest.chars().next() {
        let mut length = letter.len_utf8();
        match (inside, quote) {
            (true, _) if rest.starts_with("*/") => (inside, length) = (false, 2),
            (true, _) => {}
            (false, Some(_)) if letter == '\\' => {
                length = rest.chars().take(2).map(char::len_utf8).sum()
            }
            (false, Some(end)) if letter == end => quote = None,
            (false, Some(_)) => {}
            (false, None) if rest.starts_with("/*") => (inside, length) = (true, 2),
            (false, None) if matches!(letter, '"' | '\'') => quote = Some(letter),
            (false, None) => {}
        }
        rest = &rest[length..];
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::c::file::MapLine;

    #[test]
    fn each_line_of_the_map_has_its_comment_and_no_line_moves() {
        let text = "/** Doubles.\n * More. */\n#define F(x) \\\n    ((x) + 1)\nchar c = '\"';\nchar *s = \"/*\";\n\nint a;\n";
        let row = |c_line: u32| MapLine {
            c_line,
            rust_file: "src/a*/b.rs".to_owned(),
            rust_line: 10 + c_line,
            function: String::new(),
        };
        let map: Vec<MapLine> = (1..=8).map(row).collect();
        let mut file = CFile { name: "a.c".to_owned(), text: text.to_owned(), map };
        written(&mut file);
        let wanted = "/** Doubles.\n * More. */ /* src/a* /b.rs:12 */\n#define F(x) \\\n    ((x) + 1) /* src/a* /b.rs:14 */\n\
char c = '\"'; /* src/a* /b.rs:15 */\nchar *s = \"/*\"; /* src/a* /b.rs:16 */\n\nint a; /* src/a* /b.rs:18 */\n";
        assert_eq!(file.text, wanted);
    }
}
