//! Tokens of C, with their places.
//!
//! Comments and lines of the preprocessor are no tokens. Must not know: what a statement is.

/// A token: its bytes in the text, and its line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    /// First byte.
    pub start: usize,
    /// Byte after the last one.
    pub end: usize,
    /// Line of the first byte, from 1.
    pub line: u32,
    /// Line of the last byte.
    pub last_line: u32,
}

impl Token {
    /// Text of the token.
    pub fn text(self, of: &str) -> &str {
        of.get(self.start..self.end).unwrap_or_default()
    }
}

/// Operators of more than one character, longest first.
const LONG: [&str; 22] = [
    "<<=", ">>=", "...", "&&", "||", "==", "!=", "<=", ">=", "->", "++", "--", "<<", ">>", "+=",
    "-=", "*=", "/=", "%=", "&=", "|=", "^=",
];

/// Splits a text into tokens.
pub fn tokens(text: &str) -> Vec<Token> {
    let bytes = text.as_bytes();
    let (mut at, mut line, mut fresh) = (0, 1, true);
    let mut tokens = Vec::new();
    while let Some(&byte) = bytes.get(at) {
        let rest = &text[at..];
        match byte {
            b'\n' => {
                (at, line, fresh) = (at + 1, line + 1, true);
                continue;
            }
            b' ' | b'\t' | b'\r' | b'\\' => {
                at += 1;
                continue;
            }
            _ => {}
        }
        let skipped = match byte {
            b'/' if rest.starts_with("/*") => rest[2..].find("*/").map_or(rest.len(), |to| to + 4),
            b'/' if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            b'#' if fresh => directive(rest),
            _ => 0,
        };
        if skipped > 0 {
            line += rest[..skipped].matches('\n').count() as u32;
            at += skipped;
            continue;
        }
        fresh = false;
        let length = match byte {
            b'"' | b'\'' => quoted(rest.as_bytes()),
            b'0'..=b'9' => number(rest.as_bytes()),
            b'_' | b'a'..=b'z' | b'A'..=b'Z' => word(rest.as_bytes()),
            _ => LONG
                .iter()
                .find(|it| rest.starts_with(**it))
                .map_or_else(|| rest.chars().next().map_or(1, char::len_utf8), |it| it.len()),
        };
        let lines = rest[..length].matches('\n').count() as u32;
        tokens.push(Token { start: at, end: at + length, line, last_line: line + lines });
        line += lines;
        at += length;
    }
    tokens
}

/// Length of a preprocessor directive, with its continued lines.
fn directive(rest: &str) -> usize {
    let mut length = 0;
    for line in rest.split_inclusive('\n') {
        length += line.len();
        if !line.trim_end().ends_with('\\') {
            break;
        }
    }
    length - usize::from(rest[..length].ends_with('\n'))
}

fn quoted(bytes: &[u8]) -> usize {
    let mut at = 1;
    while let Some(&byte) = bytes.get(at) {
        at += 1;
        match byte {
            b'\\' => at += 1,
            _ if byte == bytes[0] => break,
            _ => {}
        }
    }
    at.min(bytes.len())
}

fn word(bytes: &[u8]) -> usize {
    bytes.iter().take_while(|byte| byte.is_ascii_alphanumeric() || **byte == b'_').count()
}

fn number(bytes: &[u8]) -> usize {
    let mut at = 0;
    while let Some(&byte) = bytes.get(at) {
        let signed = at > 0 && matches!(bytes[at - 1], b'e' | b'E' | b'p' | b'P');
        let hexadecimal = bytes.starts_with(b"0x") || bytes.starts_with(b"0X");
        let exponent = signed && (!hexadecimal || matches!(bytes[at - 1], b'p' | b'P'));
        let part =
            byte.is_ascii_alphanumeric() || byte == b'.' || matches!(byte, b'+' | b'-') && exponent;
        if !part {
            break;
        }
        at += 1;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(of: &str) -> Vec<(u32, &str)> {
        tokens(of).into_iter().map(|it| (it.line, it.text(of))).collect()
    }

    #[test]
    fn comments_and_directives_are_no_tokens() {
        let text = "#define A \\\n  B\n/* a\n b */ x // y\n= \"a;\\\"b\";";
        assert_eq!(texts(text), [(4, "x"), (5, "="), (5, "\"a;\\\"b\""), (5, ";")]);
    }

    #[test]
    fn numbers_and_operators_are_whole() {
        let text = "a<<=1.5e-3-0x1p-2+0xEU->b";
        let found: Vec<&str> = texts(text).into_iter().map(|(_, text)| text).collect();
        assert_eq!(found, ["a", "<<=", "1.5e-3", "-", "0x1p-2", "+", "0xEU", "->", "b"]);
    }

    #[test]
    fn no_text_makes_it_fail() {
        for text in ["\"", "'\\", "/*", "0x", "#", "é", "\\"] {
            tokens(text);
        }
    }
}
