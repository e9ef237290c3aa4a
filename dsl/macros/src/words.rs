//! Splits the text of a Rust file into names and single characters, each with its line, without comments and literals in
//! quotes. A macro cannot parse a file with places: its tokens would all have the place of the call.

/// A name or a sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Word<'t> {
    /// As it is written.
    pub text: &'t str,
    /// Its line, from 1.
    pub line: usize,
}

/// Reads the words of a text.
pub fn of(text: &str) -> Vec<Word<'_>> {
    let mut words = Vec::new();
    let (mut rest, mut line) = (text, 1);
    while let Some(first) = rest.chars().next() {
        let length = match first {
            _ if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            _ if rest.starts_with("/*") => comment(rest),
            '"' => quoted(rest, '"'),
            '\'' => character(rest),
            'r' | 'b' | 'c' => match raw(rest) {
                0 => name(rest),
                length => length,
            },
            _ => name(rest),
        };
        let (before, behind) = rest.split_at(length.max(first.len_utf8()).min(rest.len()));
        let is_word = before.chars().count() == 1 || name(before) == before.len();
        if is_word && !first.is_whitespace() {
            words.push(Word { text: before, line });
        }
        line += before.matches('\n').count();
        rest = behind;
    }
    words
}

/// Returns the length of the name with which a text begins.
fn name(text: &str) -> usize {
    text.find(|it: char| !it.is_alphanumeric() && it != '_').unwrap_or(text.len())
}

/// Returns the length of a comment between marks, which may hold others.
fn comment(text: &str) -> usize {
    let (mut depth, mut at) = (0_usize, 0);
    while at < text.len() {
        let rest = &text[at..];
        depth = match () {
            () if rest.starts_with("/*") => depth + 1,
            () if rest.starts_with("*/") => depth - 1,
            () => {
                at += rest.chars().next().map_or(1, char::len_utf8);
                continue;
            }
        };
        at += 2;
        if depth == 0 {
            break;
        }
    }
    at
}

/// Returns the length of a literal in quotes, with its escapes.
fn quoted(text: &str, quote: char) -> usize {
    let mut chars = text.char_indices().skip(1);
    while let Some((at, it)) = chars.next() {
        if it == '\\' {
            chars.next();
        } else if it == quote {
            return at + 1;
        }
    }
    text.len()
}

/// Returns the length of a character in quotes, or of the quote alone before the name of a lifetime.
fn character(text: &str) -> usize {
    let mut inside = text.chars().skip(1);
    match (inside.next(), inside.next()) {
        (Some('\\'), _) | (Some(_), Some('\'')) => quoted(text, '\''),
        _ => 1,
    }
}

/// Returns the length of a raw string, or of bytes in quotes; 0 for something else.
fn raw(text: &str) -> usize {
    let rest = text.trim_start_matches(['b', 'c']);
    let (prefix, is_raw) = match rest.strip_prefix('r') {
        Some(rest) => (rest, true),
        None => (rest, false),
    };
    let marks = prefix.len() - prefix.trim_start_matches('#').len();
    let body = &prefix[marks..];
    let before = text.len() - body.len();
    match (body.starts_with('"'), is_raw) {
        (true, true) => {
            let end = format!("\"{}", "#".repeat(marks));
            body[1..].find(&end).map_or(text.len(), |at| before + 1 + at + end.len())
        }
        (true, false) if marks == 0 => before + quoted(body, '"'),
        _ if text.starts_with("b\'") => 1 + character(&text[1..]),
        _ => 0,
    }
}
