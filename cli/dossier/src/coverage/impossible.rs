//! Proof that no input shows the effect of a condition, from the text of the decision alone.
//!
//! Rule: a decision is evaluated in the order of C, with short circuit. Within one evaluation equal text has an equal
//! value, since no part of a decision has an effect. A comparison that holds says an order of its two terms, and that
//! neither is NaN; one that does not hold says the opposite order only if another comparison, or a constant, excludes
//! NaN. Constants are ordered by their values. An evaluation is impossible if a chain of these orders leads from a term to
//! itself through a `<`, or if two terms are equal and differ. A condition is impossible to show if each pair of
//! evaluations that would show it has an impossible one.
//!
//! An evaluation that is not refuted may still be impossible, since the values of the terms are not known. Must not know:
//! any run.

use super::instrument::Observed;
use super::{Evaluation, State, shows};
use crate::scan::tokens::tokens;

/// Form of a decision over its conditions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A condition, by its place.
    Condition(usize),
    /// Negation.
    Not(Box<Shape>),
    /// All of them, by `&&`.
    All(Vec<Shape>),
    /// One of them, by `||`.
    Any(Vec<Shape>),
}

impl Shape {
    /// Reads the form of the decision at `range`, whose conditions are at these places of the text; none if it has other
    /// operators.
    pub fn of(text: &str, range: (usize, usize), conditions: &[(usize, usize)]) -> Option<Shape> {
        let mut words: Vec<Word> = Vec::new();
        let mut at = range.0;
        for (place, (from, to)) in conditions.iter().enumerate() {
            words.extend(
                tokens(text.get(at..*from)?).iter().map(|it| Word::of(it.text(&text[at..]))),
            );
            words.push(Word::Condition(place));
            at = *to;
        }
        words
            .extend(tokens(text.get(at..range.1)?).iter().map(|it| Word::of(it.text(&text[at..]))));
        let mut reader = Reader { words: &words, at: 0 };
        let shape = reader.any()?;
        (reader.at == words.len()).then_some(shape)
    }

    /// Evaluates with short circuit, and marks the conditions that are evaluated.
    fn evaluate(&self, values: u32, states: &mut [State]) -> bool {
        match self {
            Shape::Condition(at) => {
                let value = values >> at & 1 == 1;
                states[*at] = if value { State::True } else { State::False };
                value
            }
            Shape::Not(of) => !of.evaluate(values, states),
            Shape::All(parts) => parts.iter().all(|it| it.evaluate(values, states)),
            Shape::Any(parts) => parts.iter().any(|it| it.evaluate(values, states)),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Word {
    Condition(usize),
    Not,
    And,
    Or,
    Open,
    Close,
    Other,
}

impl Word {
    fn of(text: &str) -> Word {
        match text {
            "!" => Word::Not,
            "&&" => Word::And,
            "||" => Word::Or,
            "(" => Word::Open,
            ")" => Word::Close,
            _ => Word::Other,
        }
    }
}

struct Reader<'w> {
    words: &'w [Word],
    at: usize,
}

impl Reader<'_> {
    fn next_is(&mut self, wanted: Word) -> bool {
        let is = self.words.get(self.at) == Some(&wanted);
        self.at += usize::from(is);
        is
    }

    fn any(&mut self) -> Option<Shape> {
        let mut parts = vec![self.all()?];
        while self.next_is(Word::Or) {
            parts.push(self.all()?);
        }
        Some(if parts.len() == 1 { parts.remove(0) } else { Shape::Any(parts) })
    }

    fn all(&mut self) -> Option<Shape> {
        let mut parts = vec![self.one()?];
        while self.next_is(Word::And) {
            parts.push(self.one()?);
        }
        Some(if parts.len() == 1 { parts.remove(0) } else { Shape::All(parts) })
    }

    fn one(&mut self) -> Option<Shape> {
        if self.next_is(Word::Not) {
            return Some(Shape::Not(Box::new(self.one()?)));
        }
        if self.next_is(Word::Open) {
            let inner = self.any()?;
            return self.next_is(Word::Close).then_some(inner);
        }
        match self.words.get(self.at) {
            Some(Word::Condition(place)) => {
                self.at += 1;
                Some(Shape::Condition(*place))
            }
            _ => None,
        }
    }
}

/// Returns true if no two possible evaluations show the effect of the condition at a place.
pub(super) fn is_impossible(of: &Observed, at: usize) -> bool {
    let Some(shape) = &of.shape else { return false };
    let facts: Vec<Fact> = of.conditions.iter().map(|it| Fact::of(it)).collect();
    let mut possible: Vec<Evaluation> = Vec::new();
    for values in 0..1_u32 << of.conditions.len() {
        let mut states = vec![State::NotEvaluated; of.conditions.len()];
        let outcome = shape.evaluate(values, &mut states);
        let evaluation = Evaluation { states, outcome };
        if !possible.contains(&evaluation) && !is_refuted(&facts, &evaluation.states) {
            possible.push(evaluation);
        }
    }
    !possible.iter().any(|one| possible.iter().any(|other| shows(one, other, at)))
}

/// A condition as a statement about two terms, or about its own text.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Fact {
    relation: Relation,
    /// True if the condition is the negation of the relation.
    negated: bool,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Relation {
    /// `left < right`.
    Below(String, String),
    /// `left <= right`.
    AtMost(String, String),
    /// `left == right`.
    Equal(String, String),
    /// A Boolean.
    Holds(String),
}

impl Fact {
    fn of(condition: &str) -> Fact {
        let (mut text, mut negated) = (condition.trim(), false);
        loop {
            if let Some(rest) = text.strip_prefix('!').filter(|it| !it.starts_with('='))
                && is_one_operand(rest)
            {
                (text, negated) = (rest.trim(), !negated);
            } else if let Some(inner) = bare(text) {
                text = inner;
            } else {
                break;
            }
        }
        let words = tokens(text);
        let mut depth = 0;
        let mut found = Vec::new();
        for word in &words {
            match word.text(text) {
                "(" | "[" => depth += 1,
                ")" | "]" => depth -= 1,
                "<" | "<=" | ">" | ">=" | "==" | "!=" if depth == 0 => found.push(*word),
                _ => {}
            }
        }
        let [operator] = found[..] else {
            return Fact { relation: Relation::Holds(text.to_owned()), negated };
        };
        let left = term(&text[..operator.start]);
        let right = term(&text[operator.end..]);
        let (relation, turned) = match operator.text(text) {
            "<" => (Relation::Below(left, right), false),
            "<=" => (Relation::AtMost(left, right), false),
            ">" => (Relation::Below(right, left), false),
            ">=" => (Relation::AtMost(right, left), false),
            "==" => (Relation::Equal(left, right), false),
            _ => (Relation::Equal(left, right), true),
        };
        Fact { relation, negated: negated != turned }
    }
}

/// Returns the text within the brackets that enclose all of it.
fn bare(text: &str) -> Option<&str> {
    let words = tokens(text);
    let mut depth = 0;
    for (at, word) in words.iter().enumerate() {
        depth += match word.text(text) {
            "(" => 1,
            ")" => -1,
            _ => 0,
        };
        if depth == 0 {
            let whole = at + 1 == words.len() && at > 1 && word.text(text) == ")";
            return whole.then(|| text[words[0].end..word.start].trim());
        }
    }
    None
}

/// Returns true if a text is a single operand of `!`: a name with brackets and members, or something in brackets.
fn is_one_operand(text: &str) -> bool {
    let (mut depth, mut one) = (0, true);
    for word in tokens(text) {
        match word.text(text) {
            "(" | "[" => depth += 1,
            ")" | "]" => depth -= 1,
            "." | "->" | "!" => {}
            other => {
                one &= depth > 0 || other.starts_with(|it: char| it.is_alphanumeric() || it == '_')
            }
        }
    }
    one
}

fn term(text: &str) -> String {
    let mut text = text.trim();
    while let Some(inner) = bare(text) {
        text = inner;
    }
    text.to_owned()
}

/// Returns the value of a numeric constant, if a double has it.
fn number(term: &str) -> Option<f64> {
    let (sign, digits) = match term.strip_prefix('-') {
        Some(rest) => (-1.0, rest.trim()),
        None => (1.0, term),
    };
    let wrapped = ["UINT64_C(", "INT64_C("].iter().find_map(|it| digits.strip_prefix(it));
    let digits = wrapped.and_then(|it| it.strip_suffix(')')).unwrap_or(digits);
    if !digits.starts_with(|it: char| it.is_ascii_digit()) {
        return None;
    }
    let whole = digits.trim_end_matches(['U', 'L']);
    let value = match whole.parse::<u64>() {
        Ok(integer) if integer <= 1 << 53 => integer as f64,
        Ok(_) => return None,
        Err(_) => match digits.strip_suffix(['f', 'F']).filter(|_| !digits.starts_with("0x")) {
            Some(single) => f64::from(single.parse::<f32>().ok()?),
            None => digits.parse::<f64>().ok()?,
        },
    };
    value.is_finite().then_some(sign * value)
}

/// Orders of terms: `strict` is false for `<=`.
struct Order<'f> {
    from: &'f str,
    to: &'f str,
    strict: bool,
}

/// Returns true if these states of the conditions contradict each other.
fn is_refuted(facts: &[Fact], states: &[State]) -> bool {
    let truths = facts.iter().zip(states).filter(|(_, state)| **state != State::NotEvaluated);
    let truths: Vec<(&Relation, bool)> = truths
        .map(|(fact, state)| (&fact.relation, (*state == State::True) != fact.negated))
        .collect();
    let opposed = |it: &(&Relation, bool)| truths.contains(&(it.0, !it.1));
    if truths.iter().any(opposed) {
        return true;
    }
    let mut terms: Vec<&str> = Vec::new();
    let mut ordered: Vec<&str> = Vec::new();
    for (relation, holds) in &truths {
        if let Relation::Below(left, right)
        | Relation::AtMost(left, right)
        | Relation::Equal(left, right) = relation
        {
            terms.extend([&**left, right]);
            if *holds {
                ordered.extend([&**left, right]);
            }
        }
    }
    terms.sort_unstable();
    terms.dedup();
    let is_ordered = |term: &str| number(term).is_some() || ordered.contains(&term);
    let mut orders: Vec<Order<'_>> = Vec::new();
    let mut differ: Vec<(&str, &str)> = Vec::new();
    let mut order = |from, to, strict| orders.push(Order { from, to, strict });
    for one in &terms {
        for other in &terms {
            if let (Some(low), Some(high)) = (number(one), number(other))
                && one != other
                && low <= high
            {
                order(*one, *other, low < high);
            }
        }
    }
    for (relation, holds) in &truths {
        match (relation, holds) {
            (Relation::Below(left, right), true) => order(left, right, true),
            (Relation::AtMost(left, right), true) => order(left, right, false),
            (Relation::Equal(left, right), true) => {
                order(left, right, false);
                order(right, left, false);
            }
            (Relation::Holds(_), _) => {}
            (Relation::Below(left, right), false) if is_ordered(left) && is_ordered(right) => {
                order(right, left, false);
            }
            (Relation::AtMost(left, right), false) if is_ordered(left) && is_ordered(right) => {
                order(right, left, true);
            }
            (Relation::Equal(left, right), false) if is_ordered(left) && is_ordered(right) => {
                differ.push((left, right));
            }
            (_, false) => {}
        }
    }
    let reaches = reached(&terms, &orders);
    let at = |term: &str| terms.iter().position(|it| *it == term);
    let least =
        |from: &str, to: &str| at(from).zip(at(to)).and_then(|(from, to)| reaches[from][to]);
    terms.iter().any(|term| least(term, term) == Some(true))
        || differ.iter().any(|(one, other)| {
            one == other || least(one, other).is_some() && least(other, one).is_some()
        })
}

/// Returns for each two terms whether orders lead from one to the other: none, or true if one of them is strict.
fn reached(terms: &[&str], orders: &[Order<'_>]) -> Vec<Vec<Option<bool>>> {
    let count = terms.len();
    let mut reached = vec![vec![None; count]; count];
    let place = |term: &str| terms.iter().position(|it| *it == term).unwrap_or_default();
    for order in orders {
        let cell: &mut Option<bool> = &mut reached[place(order.from)][place(order.to)];
        *cell = Some(cell.unwrap_or(false) || order.strict);
    }
    for middle in 0..count {
        for from in 0..count {
            for to in 0..count {
                if let (Some(one), Some(other)) = (reached[from][middle], reached[middle][to]) {
                    let strict = one || other || reached[from][to] == Some(true);
                    reached[from][to] = Some(strict);
                }
            }
        }
    }
    reached
}

#[cfg(test)]
mod tests;
