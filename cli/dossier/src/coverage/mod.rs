//! Coverage of the C: statements, branches, and for each condition the pair of inputs that shows its effect (MC/DC).
//!
//! A condition is covered if two evaluations differ in it and in the outcome, and are equal in each other condition that
//! both evaluated: unique cause with short circuit, as in clang's `-fcoverage-mcdc`.
//!
//! Must not know: how the C was run.

mod impossible;
pub mod instrument;
pub mod reasons;

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;

use crate::trace::Folder;
use instrument::{Instrumented, Observed};

/// Effects of a run of instrumented C.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Seen {
    /// Statements that ran, by their number.
    pub ran: Vec<bool>,
    /// Combinations that were evaluated.
    pub combinations: Vec<bool>,
}

impl Seen {
    /// Reads the arrays that a program wrote; none if their size is another.
    pub fn read(bytes: &[u8], of: &Instrumented) -> Option<Seen> {
        let points = of.points.len().max(1);
        if bytes.len() != points + of.bytes.max(1) {
            return None;
        }
        let flags = |bytes: &[u8]| bytes.iter().map(|it| *it != 0).collect();
        Some(Seen { ran: flags(&bytes[..points]), combinations: flags(&bytes[points..]) })
    }

    /// Returns true if another run did something that is not here.
    pub fn lacks(&self, other: &Seen) -> bool {
        let new = |own: &[bool], other: &[bool]| {
            other.iter().enumerate().any(|(at, it)| *it && own.get(at) != Some(&true))
        };
        new(&self.ran, &other.ran) || new(&self.combinations, &other.combinations)
    }

    /// Adds what another run did.
    pub fn add(&mut self, other: &Seen) {
        if self.ran.is_empty() {
            return self.clone_from(other);
        }
        let add = |own: &mut Vec<bool>, other: &[bool]| {
            own.iter_mut().zip(other).for_each(|(own, other)| *own |= other);
        };
        add(&mut self.ran, &other.ran);
        add(&mut self.combinations, &other.combinations);
    }
}

/// State of a condition in an evaluation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    NotEvaluated,
    False,
    True,
}

/// An evaluation of a decision.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Evaluation {
    states: Vec<State>,
    outcome: bool,
}

fn evaluations(of: &Observed, seen: &Seen) -> Vec<Evaluation> {
    let places = 0..of.combinations();
    let there = places.filter(|at| seen.combinations.get(of.offset + at) == Some(&true));
    let evaluation = |at: usize| {
        let mut trail = at / 2;
        let states = of.conditions.iter().map(|_| {
            let state = [State::NotEvaluated, State::False, State::True][trail % 3];
            trail /= 3;
            state
        });
        Evaluation { states: states.collect(), outcome: at % 2 == 1 }
    };
    there.map(evaluation).collect()
}

/// Returns true if two evaluations show the effect of a condition.
fn shows(one: &Evaluation, other: &Evaluation, condition: usize) -> bool {
    let differs = |(one, other): (&State, &State)| {
        *one != State::NotEvaluated && *other != State::NotEvaluated && one != other
    };
    let mut pairs = one.states.iter().zip(&other.states).enumerate();
    one.outcome != other.outcome && pairs.all(|(at, pair)| differs(pair) == (at == condition))
}

/// Numbers of one measure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Count {
    /// Number that was covered.
    pub covered: usize,
    /// Number of all.
    pub all: usize,
    /// Share in percent, rounded down.
    pub percent: usize,
}

impl Count {
    fn add(&mut self, covered: usize, all: usize) {
        self.covered += covered;
        self.all += all;
        self.percent = (self.covered * 100).checked_div(self.all).unwrap_or(100);
    }
}

/// The three measures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// Executed statements.
    pub statements: Count,
    /// Both outcomes of each condition.
    pub branches: Count,
    /// Conditions whose effect was shown.
    pub conditions: Count,
}

/// Coverage of a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct OfFile {
    /// Name of the file.
    pub name: String,
    /// Measures.
    pub counts: Counts,
}

/// A condition or a statement that was not covered.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Missing {
    /// Place in the C.
    pub place: String,
    /// Function.
    pub function: String,
    /// Place in the Rust.
    pub rust: String,
    /// Text of the decision or of the line.
    pub text: String,
    /// Text of the condition; empty for a statement.
    pub condition: String,
    /// Missing evaluation.
    pub why: String,
    /// True if it is proved that no input shows the condition.
    pub is_impossible: bool,
    /// The author's reason why no test is needed, if there is one.
    pub reason: String,
}

/// The report.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Report {
    /// Sources of the inputs.
    pub inputs: Vec<String>,
    /// Measures of all files.
    pub counts: Counts,
    /// Measures of each file.
    pub files: Vec<OfFile>,
    /// Statements that never ran, one for each function that was never called.
    pub statements: Vec<Missing>,
    /// Conditions without a pair.
    pub conditions: Vec<Missing>,
    /// Number of these that are proved impossible.
    pub impossible: usize,
    /// Decisions with too many conditions.
    pub too_many: Vec<String>,
    /// Functions with the texts of their decisions, conditions and statements.
    #[serde(skip)]
    pub codes: BTreeSet<(String, String)>,
}

/// Builds the report of what runs have shown.
pub fn report(of: &Instrumented, seen: &Seen, folder: &Folder, inputs: Vec<String>) -> Report {
    let mut files: BTreeMap<&str, Counts> = BTreeMap::new();
    let mut report = Report { inputs, too_many: of.too_many.clone(), ..Report::default() };
    let evaluated: Vec<Vec<Evaluation>> =
        of.decisions.iter().map(|it| evaluations(it, seen)).collect();
    let rust = |file: &str, line: u32| {
        let row = folder.file(file).ok().and_then(|it| it.counterpart(line));
        row.map(|(_, _, row)| format!("{}:{}", row.rust_file, row.rust_line)).unwrap_or_default()
    };
    let text = |file: &str, line: u32| {
        let text = folder.file(file).ok().map(|it| it.text.as_str()).unwrap_or_default();
        text.lines().nth(line.saturating_sub(1) as usize).unwrap_or_default().trim().to_owned()
    };
    let mut numbers = 0;
    let mut of_function: BTreeMap<(&str, &str), (usize, Vec<u32>)> = BTreeMap::new();
    for (at, point) in of.points.iter().enumerate() {
        let ran = match point.by_decision {
            Some(decision) => evaluated.get(decision).is_some_and(|it| !it.is_empty()),
            None => seen.ran.get(at) == Some(&true),
        };
        numbers += 1;
        report.codes.insert((point.function.clone(), text(&point.file, point.line)));
        files.entry(&point.file).or_default().statements.add(usize::from(ran), 1);
        report.counts.statements.add(usize::from(ran), 1);
        let own = of_function.entry((&point.file, &point.function)).or_default();
        own.0 += 1;
        if !ran {
            own.1.push(point.line);
        }
    }
    debug_assert_eq!(numbers, of.points.len());
    for ((file, function), (all, lines)) in of_function {
        let whole = lines.len() == all;
        let shown = if whole { &lines[..1] } else { &lines[..] };
        for line in shown {
            report.statements.push(Missing {
                place: format!("{file}:{line}"),
                function: function.to_owned(),
                rust: rust(file, *line),
                text: text(file, *line),
                why: if whole {
                    format!("`{function}` is never called")
                } else {
                    "never runs".to_owned()
                },
                ..Missing::default()
            });
        }
    }
    for (observed, evaluations) in of.decisions.iter().zip(&evaluated) {
        let counts = files.entry(&observed.file).or_default();
        let texts = observed.conditions.iter().chain([&observed.text]);
        report.codes.extend(texts.map(|text| (observed.function.clone(), text.clone())));
        for at in 0..observed.conditions.len() {
            let was = |state: State| evaluations.iter().any(|it| it.states[at] == state);
            let both = usize::from(was(State::True)) + usize::from(was(State::False));
            let pair = evaluations
                .iter()
                .enumerate()
                .any(|(index, one)| evaluations[..index].iter().any(|other| shows(one, other, at)));
            for counts in [&mut *counts, &mut report.counts] {
                counts.branches.add(both, 2);
                counts.conditions.add(usize::from(pair), 1);
            }
            if !pair {
                let line = observed.decision.line;
                let is_impossible = impossible::is_impossible(observed, at);
                report.impossible += usize::from(is_impossible);
                report.conditions.push(Missing {
                    place: format!("{}:{line}", observed.file),
                    function: observed.function.clone(),
                    rust: rust(&observed.file, line),
                    text: observed.text.clone(),
                    condition: observed.conditions[at].clone(),
                    why: missing(observed, evaluations, at),
                    is_impossible,
                    ..Missing::default()
                });
            }
        }
    }
    report.files =
        files.into_iter().map(|(name, counts)| OfFile { name: name.to_owned(), counts }).collect();
    report
}

/// Names the pair of evaluations that a condition lacks.
fn missing(of: &Observed, evaluations: &[Evaluation], at: usize) -> String {
    let condition = &of.conditions[at];
    let was = |state: State| evaluations.iter().any(|it| it.states[at] == state);
    let never = match (was(State::True), was(State::False)) {
        _ if evaluations.is_empty() => return "never evaluated".to_owned(),
        (false, false) => return format!("`{condition}` is never evaluated"),
        (false, true) => format!("`{condition}` is never true"),
        (true, false) => format!("`{condition}` is never false"),
        (true, true) => format!("never decided by `{condition}`"),
    };
    let one = evaluations.iter().find(|it| it.states[at] != State::NotEvaluated);
    let Some(one) = one.filter(|_| of.conditions.len() > 1) else { return never };
    let wanted =
        of.conditions.iter().zip(&one.states).enumerate().filter_map(|(place, (text, state))| {
            let state = match (place == at, state) {
                (true, State::True) => State::False,
                (true, _) => State::True,
                (false, state) => *state,
            };
            match state {
                State::True => Some(format!("`{text}`")),
                State::False => Some(format!("not `{text}`")),
                State::NotEvaluated => None,
            }
        });
    let outcome = if one.outcome { "false" } else { "true" };
    format!(
        "{never}: lacks an input with {} that makes it {outcome}",
        wanted.collect::<Vec<_>>().join(", ")
    )
}

#[cfg(test)]
mod tests;
