//! Statements of a function body.

use super::decisions;
use super::tokens::Token;
use super::{Function, Kind, Statement, closing, is};

/// Reads the statements between two places.
pub(super) fn read(
    text: &str,
    tokens: &[Token],
    (from, to): (usize, usize),
    function: &mut Function,
) {
    let mut reader = Reader { text, tokens, end: to, function };
    let mut at = from;
    while at < to {
        at = reader.statement(at, true).max(at + 1);
    }
}

struct Reader<'a> {
    text: &'a str,
    tokens: &'a [Token],
    /// Place of the brace that closes the body.
    end: usize,
    function: &'a mut Function,
}

impl Reader<'_> {
    fn word(&self, at: usize) -> &str {
        match at < self.end {
            true => self.tokens[at].text(self.text),
            false => "",
        }
    }

    fn close(&self, open: usize) -> usize {
        closing(self.text, self.tokens, open).filter(|it| *it < self.end).unwrap_or(self.end)
    }

    /// Reads one statement; returns the place behind it.
    fn statement(&mut self, at: usize, is_in_block: bool) -> usize {
        match self.word(at) {
            "" => self.end,
            "}" | ";" => at + 1,
            "{" => {
                let close = self.close(at);
                let mut inner = at + 1;
                while inner < close {
                    inner = self.statement(inner, true).max(inner + 1);
                }
                close + 1
            }
            "case" => {
                let mut colon = at;
                while !matches!(self.word(colon), ":" | "") {
                    colon += 1;
                }
                colon + 1
            }
            "default" if self.word(at + 1) == ":" => at + 2,
            "else" => self.statement(at + 1, false),
            "do" => {
                self.push(Kind::Control, at, at, is_in_block);
                self.statement(at + 1, false)
            }
            "if" | "while" | "switch" | "for" => self.control(at, is_in_block),
            _ => self.simple(at, is_in_block),
        }
    }

    /// Reads the head of `if`, `while`, `switch` or `for`, then the body.
    fn control(&mut self, at: usize, is_in_block: bool) -> usize {
        let close = self.close(at + 1);
        let word = self.word(at).to_owned();
        // The `while` of a `do` has no body.
        if word == "while" && self.word(close + 1) == ";" {
            self.decide((at + 2, close), true);
            return close + 2;
        }
        self.push(Kind::Control, at, close, is_in_block);
        match &*word {
            "for" => {
                let parts = self.parts((at + 2, close));
                for (index, part) in parts.into_iter().enumerate() {
                    self.decide(part, index == 1 && part.0 < part.1);
                }
            }
            "switch" => self.decide((at + 2, close), false),
            _ => self.decide((at + 2, close), true),
        }
        if close >= self.end {
            return self.end;
        }
        self.statement(close + 1, false)
    }

    /// Splits the head of a `for` at its semicolons.
    fn parts(&self, (from, to): (usize, usize)) -> Vec<(usize, usize)> {
        let mut parts = Vec::new();
        let mut start = from;
        for at in from..to {
            if self.word(at) == ";" {
                parts.push((start, at));
                start = at + 1;
            }
        }
        parts.push((start.min(to), to));
        parts
    }

    fn simple(&mut self, at: usize, is_in_block: bool) -> usize {
        // A macro before a loop, such as `UNROLL(4)`, is a part of the loop.
        if self.word(at + 1) == "(" {
            let close = self.close(at + 1);
            if matches!(self.word(close + 1), "for" | "while") {
                let behind = self.control(close + 1, is_in_block);
                return behind;
            }
        }
        let mut end = at;
        while !matches!(self.word(end), ";" | "") {
            end = match self.word(end) {
                "(" | "[" | "{" => self.close(end) + 1,
                _ => end + 1,
            };
        }
        let end = end.min(self.end);
        let words = || (at..end).map(|at| self.word(at));
        let kind = match self.word(at) {
            "return" | "break" | "continue" | "goto" => Kind::Leave,
            "static" => Kind::Declaration,
            _ if words().any(|it| matches!(it, "=" | "(" | "++" | "--") || is_compound(it)) => {
                Kind::Simple
            }
            _ => Kind::Declaration,
        };
        let is_static = self.word(at) == "static";
        self.push(kind, at, end, is_in_block);
        if !is_static {
            let from = at + usize::from(kind == Kind::Leave);
            self.decide((from, end), false);
        }
        end + 1
    }

    fn push(&mut self, kind: Kind, first: usize, last: usize, is_in_block: bool) {
        let last = last.min(self.end);
        let (first, last) = (self.tokens[first], self.tokens[last]);
        self.function.statements.push(Statement {
            kind,
            start: first.start,
            line: first.line,
            last_line: last.last_line,
            is_in_block,
        });
    }

    fn decide(&mut self, range: (usize, usize), controls: bool) {
        let range = (range.0, range.1.min(self.end));
        if range.0 < range.1 && !is(self.text, self.tokens, range.0, "static") {
            decisions::find(self.text, self.tokens, range, controls, &mut self.function.decisions);
        }
    }
}

fn is_compound(word: &str) -> bool {
    word.len() > 1 && word.ends_with('=') && !matches!(word, "==" | "!=" | "<=" | ">=")
}
