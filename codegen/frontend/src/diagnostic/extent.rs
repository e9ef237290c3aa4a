//! Computes the extent of a syntax node in the source text. The tree records only where a node begins; a diagnostic
//! underlines the whole node.

/// Returns the length, in bytes and within its line, of the node at the beginning of `text`. It is a keyword with its
/// syntax, or an operand with the calls and fields after it, and the operand after an operator.
pub fn length(text: &str) -> usize {
    let first = word(text);
    let end = match &text[..first] {
        "let" => text.find(';').map_or(text.len(), |at| at + 1),
        "while" | "for" | "if" | "match" | "loop" | "unsafe" | "fn" | "impl" | "struct"
        | "enum" => text.find('{').unwrap_or(text.len()),
        _ => {
            let end = operand(text);
            end.max(behind_operator(text, end))
        }
    };
    let end = text[..end].trim_end().len();
    if end == 0 { text.chars().next().map_or(0, char::len_utf8) } else { end }
}

/// Returns the end of the operand after a binary operator at `end`, or `end` if there is no operator.
fn behind_operator(text: &str, end: usize) -> usize {
    const OPERATORS: [&str; 10] = ["<<=", ">>=", "<<", ">>", "==", "+", "-", "*", "/", "%"];
    let rest = &text[end..];
    let space = rest.len() - rest.trim_start().len();
    let rest = &rest[space..];
    let Some(operator) = OPERATORS.iter().find(|it| rest.starts_with(**it)) else { return end };
    if space == 0 {
        return end;
    }
    let mut at = end + space + operator.len();
    at += usize::from(text[at..].starts_with('='));
    at += text[at..].len() - text[at..].trim_start().len();
    at + operand(&text[at..])
}

/// Returns the end of an operand: signs and references, then a name, a number or a bracketed expression, then its
/// calls and fields.
fn operand(text: &str) -> usize {
    let mut at = 0;
    loop {
        let rest = &text[at..];
        match rest.chars().next() {
            Some('-' | '!' | '*' | '&') => at += 1,
            _ if rest.starts_with("mut ") => at += "mut ".len(),
            _ => break,
        }
    }
    loop {
        let rest = &text[at..];
        at += match rest.chars().next() {
            Some('(' | '[') => bracket(rest),
            Some('?') => 1,
            Some('!') if rest[1..].starts_with(['(', '[']) => 1,
            Some('.') if !rest.starts_with("..") => 1,
            Some(':') if rest.starts_with("::") => 2,
            Some('<') if text[..at].ends_with("::") => {
                rest.find('>').map_or(rest.len(), |it| it + 1)
            }
            Some(it) if it.is_alphanumeric() || it == '_' => word(rest),
            _ => return at,
        };
    }
}

/// Returns the length in bytes of the word at the beginning of `text`.
fn word(text: &str) -> usize {
    text.find(|it: char| !(it.is_alphanumeric() || it == '_')).unwrap_or(text.len())
}

/// Returns the length in bytes up to the bracket that closes the first one, or of the whole text if no bracket closes
/// it.
fn bracket(text: &str) -> usize {
    let mut depth = 0_usize;
    for (at, it) in text.char_indices() {
        match it {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return at + 1;
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::length;

    #[test]
    fn what_begins_at_a_place_is_shown_whole() {
        let whole = |text: &'static str| &text[..length(text)];
        assert_eq!(whole("list.iter().copied().sum()"), "list.iter().copied().sum()");
        assert_eq!(whole("gains.twice(x)[0]; more"), "gains.twice(x)[0]");
        assert_eq!(whole("now - self.last;"), "now - self.last");
        assert_eq!(whole("self.count += 1;"), "self.count += 1");
        assert_eq!(whole("-raw } else { raw }"), "-raw");
        assert_eq!(whole("let value = &(a[n] * 2.0);"), "let value = &(a[n] * 2.0);");
        assert_eq!(whole("while x > 1.0 {"), "while x > 1.0");
        assert_eq!(whole("core::cmp::max::<u8>(a, b), c"), "core::cmp::max::<u8>(a, b)");
        assert_eq!(whole("0.5, y"), "0.5");
        assert_eq!(whole("{ x }"), "{");
        assert_eq!(whole("values[(i"), "values[(i");
        assert_eq!(whole(""), "");
    }
}
