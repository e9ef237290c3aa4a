//! Functions, statements and decisions of a C file, with their places.
//!
//! It reads the C that the tool emits: braces around each body, one statement after the other. Of other C it finds at
//! least the functions; what it cannot read becomes one statement.
//!
//! Must not know: where the C comes from, or who uses the places.

mod decisions;
mod statements;
pub mod tokens;

use tokens::{Token, tokens};

/// A function with a body.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Function {
    /// Its name.
    pub name: String,
    /// Line of the name.
    pub line: u32,
    /// Line of the last brace.
    pub last_line: u32,
    /// Statements, in the order of the text; those of inner blocks follow the one that has them.
    pub statements: Vec<Statement>,
    /// Decisions, in the order of the text.
    pub decisions: Vec<Decision>,
}

/// A statement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement {
    /// Kind of the statement.
    pub kind: Kind,
    /// First byte.
    pub start: usize,
    /// First line.
    pub line: u32,
    /// Last line of the statement, or of its head if it has a body.
    pub last_line: u32,
    /// True if another statement can be put before it: not behind `else`, not a body without braces.
    pub is_in_block: bool,
}

/// Kinds of statements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A declaration without a value, or a static one: nothing is executed.
    Declaration,
    /// A statement that is executed as a whole.
    Simple,
    /// `return`, `break` or `continue`.
    Leave,
    /// `if`, `for`, `while` or `switch`.
    Control,
}

/// An expression that decides by Booleans: a controlling one, or one with `&&` or `||`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decision {
    /// Bytes of the expression.
    pub range: (usize, usize),
    /// Line of the expression.
    pub line: u32,
    /// True if it decides on the next statement.
    pub controls: bool,
    /// Conditions, in the order of evaluation.
    pub conditions: Vec<Condition>,
}

/// A Boolean without `&&` and `||` in a decision.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Condition {
    /// Bytes of the expression.
    pub range: (usize, usize),
    /// Line of the expression.
    pub line: u32,
}

/// Words that are no name of a function.
const NO_NAMES: [&str; 8] =
    ["if", "for", "while", "switch", "return", "sizeof", "__attribute__", "defined"];

/// Returns the functions of a C file that have bodies.
pub fn functions(text: &str) -> Vec<Function> {
    let all = tokens(text);
    let mut found = Vec::new();
    let mut at = 0;
    while at < all.len() {
        if is(text, &all, at, "(")
            && let Some(close) = closing(text, &all, at)
        {
            let name = at.checked_sub(1).map(|name| all[name]);
            let named = name.filter(|name| {
                let name = name.text(text);
                name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
                    && !NO_NAMES.contains(&name)
            });
            if let Some(name) = named
                && is(text, &all, close + 1, "{")
                && let Some(end) = closing(text, &all, close + 1)
            {
                let mut function = Function {
                    name: name.text(text).to_owned(),
                    line: name.line,
                    last_line: all[end].last_line,
                    ..Function::default()
                };
                statements::read(text, &all, (close + 2, end), &mut function);
                function.decisions.sort_by_key(|it| (it.range.0, std::cmp::Reverse(it.range.1)));
                found.push(function);
                at = end + 1;
                continue;
            }
            at = close + 1;
            continue;
        }
        // The brace of `extern "C" {` encloses functions; any other one encloses members or values.
        let of_language = at > 0 && all[at - 1].text(text).starts_with('"');
        if is(text, &all, at, "{")
            && !of_language
            && let Some(close) = closing(text, &all, at)
        {
            at = close;
        }
        at += 1;
    }
    found
}

/// Returns true if the token at this place has this text.
fn is(text: &str, tokens: &[Token], at: usize, wanted: &str) -> bool {
    tokens.get(at).is_some_and(|token| token.text(text) == wanted)
}

/// Returns the place of the bracket that closes the one at `open`.
fn closing(text: &str, tokens: &[Token], open: usize) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, token) in tokens.iter().enumerate().skip(open) {
        match token.text(text) {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => {
                depth = depth.checked_sub(1)?;
                if depth == 0 {
                    return Some(at);
                }
            }
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "\
/* if (x) { */
extern \"C\" {
typedef struct { int a; } t;
static const int table[2] = {1, 2};
int f(int a, int b)
{
    static const int own[2] = {1, 2};
    int sum;
    const bool both = a > 0 && (b > 0 || !(a == b));
    if (both) {
        sum = a;
    } else if (a
        && b) {
        return a ? 1 : 2;
    } else {
        sum = g(a && b, h[a || b]);
    }
    for (int i = 0; i < 3 && a; i++) {
        continue;
    }
    switch (a) {
    case 1:
        sum = 1;
        break;
    default: {
        int x = 2;
        sum = x;
        break;
    }
    }
    do { sum++; } while (sum < 9);
    for (;;) {
    }
}
}
";

    #[test]
    fn statements_and_decisions_are_found() {
        let [function] = &functions(TEXT)[..] else { panic!("one function") };
        assert_eq!((&*function.name, function.line, function.last_line), ("f", 5, 34));
        let lines: Vec<_> =
            function.statements.iter().map(|it| (it.line, it.last_line, it.kind)).collect();
        use Kind::{Control, Declaration, Leave, Simple};
        assert_eq!(
            lines,
            [
                (7, 7, Declaration),
                (8, 8, Declaration),
                (9, 9, Simple),
                (10, 10, Control),
                (11, 11, Simple),
                (12, 13, Control),
                (14, 14, Leave),
                (16, 16, Simple),
                (18, 18, Control),
                (19, 19, Leave),
                (21, 21, Control),
                (23, 23, Simple),
                (24, 24, Leave),
                (26, 26, Simple),
                (27, 27, Simple),
                (28, 28, Leave),
                (31, 31, Control),
                (31, 31, Simple),
                (32, 32, Control),
            ]
        );
        let blocked: Vec<u32> =
            function.statements.iter().filter(|it| !it.is_in_block).map(|it| it.line).collect();
        assert_eq!(blocked, [12]);
        let decisions: Vec<_> = function
            .decisions
            .iter()
            .map(|it| {
                let of = |range: (usize, usize)| &TEXT[range.0..range.1];
                let conditions = it.conditions.iter().map(|it| of(it.range));
                (it.line, it.controls, conditions.collect::<Vec<_>>())
            })
            .collect();
        assert_eq!(
            decisions,
            [
                (9, false, vec!["a > 0", "b > 0", "a == b"]),
                (10, true, vec!["both"]),
                (12, true, vec!["a", "b"]),
                (14, true, vec!["a"]),
                (16, false, vec!["a", "b"]),
                (16, false, vec!["a", "b"]),
                (18, true, vec!["i < 3", "a"]),
                (31, true, vec!["sum < 9"]),
            ]
        );
    }

    #[test]
    fn no_text_makes_it_fail() {
        for end in 0..TEXT.len() {
            functions(&TEXT[..end]);
            functions(&TEXT[end..]);
        }
    }
}
