//! Decisions of an expression, and their conditions.

use super::tokens::Token;
use super::{Condition, Decision, closing};

/// Operators that separate expressions in which each is a value by itself.
const BETWEEN: [&str; 15] =
    [",", ";", "=", "?", ":", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="];

/// Adds the decisions in a range of tokens; the range itself is one if it `controls`.
pub(super) fn find(
    text: &str,
    tokens: &[Token],
    range: (usize, usize),
    controls: bool,
    found: &mut Vec<Decision>,
) {
    Finder { text, tokens, found }.values(range, controls);
}

struct Finder<'a> {
    text: &'a str,
    tokens: &'a [Token],
    found: &'a mut Vec<Decision>,
}

impl Finder<'_> {
    fn word(&self, at: usize) -> &str {
        self.tokens[at].text(self.text)
    }

    /// Returns the places in a range that are in no brackets of it.
    fn outer(&self, (from, to): (usize, usize)) -> Vec<usize> {
        let mut places = Vec::new();
        let mut at = from;
        while at < to {
            places.push(at);
            at = match self.word(at) {
                "(" | "[" | "{" => {
                    closing(self.text, self.tokens, at).map_or(to, |close| close.max(at + 1))
                }
                _ => at + 1,
            };
        }
        places
    }

    /// Splits a range at operators outside of its brackets.
    fn split(&self, range: (usize, usize), at: impl Fn(&str) -> bool) -> Vec<(usize, usize)> {
        let mut parts = Vec::new();
        let mut start = range.0;
        for place in self.outer(range) {
            if at(self.word(place)) {
                parts.push((start, place));
                start = place + 1;
            }
        }
        parts.push((start.min(range.1), range.1));
        parts
    }

    /// Finds decisions in the values of a range.
    fn values(&mut self, range: (usize, usize), controls: bool) {
        let parts = self.split(range, |word| BETWEEN.contains(&word));
        if let [whole] = parts[..] {
            return self.value(whole, controls);
        }
        for part in parts {
            let decides = part.1 < range.1 && self.word(part.1) == "?";
            self.value(part, decides);
        }
        if controls {
            // A choice of values, or a list, that decides as a whole.
            self.push(range, true, vec![range]);
        }
    }

    /// Finds decisions in one value.
    fn value(&mut self, range: (usize, usize), controls: bool) {
        if range.0 >= range.1 {
            return;
        }
        let joins = |word: &str| matches!(word, "&&" | "||");
        let joined = self.outer(range).into_iter().any(|at| joins(self.word(at)));
        if !joined && !controls {
            return self.inside(range);
        }
        let mut conditions = Vec::new();
        self.conditions(range, &mut conditions);
        conditions.iter().for_each(|it| self.inside(*it));
        self.push(range, controls, conditions);
    }

    fn push(&mut self, range: (usize, usize), controls: bool, conditions: Vec<(usize, usize)>) {
        let bytes = |(from, to): (usize, usize)| (self.tokens[from].start, self.tokens[to - 1].end);
        let conditions = conditions
            .into_iter()
            .map(|range| Condition { range: bytes(range), line: self.tokens[range.0].line });
        let conditions = conditions.collect();
        let line = self.tokens[range.0].line;
        self.found.push(Decision { range: bytes(range), line, controls, conditions });
    }

    /// Finds decisions in the brackets of a range.
    fn inside(&mut self, range: (usize, usize)) {
        for at in self.outer(range) {
            if matches!(self.word(at), "(" | "[" | "{")
                && let Some(close) = closing(self.text, self.tokens, at)
                && close <= range.1
            {
                self.values((at + 1, close), false);
            }
        }
    }

    /// Adds the conditions of a Boolean.
    fn conditions(&self, range: (usize, usize), found: &mut Vec<(usize, usize)>) {
        for operator in ["||", "&&"] {
            let parts = self.split(range, |word| word == operator);
            if parts.len() > 1 && parts.iter().all(|part| part.0 < part.1) {
                return parts.into_iter().for_each(|part| self.conditions(part, found));
            }
        }
        let mut inner = range;
        while inner.0 < inner.1 && self.word(inner.0) == "!" {
            inner.0 += 1;
        }
        let whole = inner.0 < inner.1
            && self.word(inner.0) == "("
            && closing(self.text, self.tokens, inner.0) == Some(inner.1 - 1)
            && inner.1 - inner.0 > 2;
        if whole {
            let within = (inner.0 + 1, inner.1 - 1);
            let single = self.split(within, |word| BETWEEN.contains(&word)).len() == 1;
            if single {
                return self.conditions(within, found);
            }
        }
        found.push(range);
    }
}
