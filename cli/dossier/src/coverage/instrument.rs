//! Instruments C: each statement and each decision reports what it did to arrays of bytes.
//!
//! Calls are put into the text, and nothing is removed, so that the C computes the same. No library is needed: on a
//! target a debugger reads the arrays. Must not know: the inputs.

use std::fmt::Write as _;

use super::impossible::Shape;
use crate::scan::{self, Decision, Kind};

/// Most conditions of a decision whose combinations are recorded.
pub const MOST: usize = 8;
/// Name of the header that declares the arrays.
pub const HEADER: &str = "bessemer_probes.h";
/// Name of the source that defines them.
pub const SOURCE: &str = "bessemer_probes.c";

/// A statement that is observed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Point {
    /// File.
    pub file: String,
    /// Function.
    pub function: String,
    /// Line.
    pub line: u32,
    /// Its number; none for an `else if`, which is executed if its decision is.
    pub by_decision: Option<usize>,
}

/// A decision that is observed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Observed {
    /// File.
    pub file: String,
    /// Function.
    pub function: String,
    /// The decision.
    pub decision: Decision,
    /// Text of the decision.
    pub text: String,
    /// Texts of the conditions.
    pub conditions: Vec<String>,
    /// Its form; none if it has other operators than `&&`, `||` and `!`.
    pub shape: Option<Shape>,
    /// First byte of its combinations.
    pub offset: usize,
}

impl Observed {
    /// Number of bytes of its combinations: three states of each condition, two outcomes.
    pub fn combinations(&self) -> usize {
        2 * 3_usize.pow(self.conditions.len() as u32)
    }
}

/// Instrumented C.
#[derive(Clone, Debug, Default)]
pub struct Instrumented {
    /// Files by name, with header and source of the arrays.
    pub files: Vec<(String, String)>,
    /// Statements, by their number.
    pub points: Vec<Point>,
    /// Decisions, by their number.
    pub decisions: Vec<Observed>,
    /// Decisions with more than [`MOST`] conditions.
    pub too_many: Vec<String>,
    /// Bytes of all combinations.
    pub bytes: usize,
}

/// Instruments the files for which `wanted` is true; the others are taken as they are.
pub fn instrument<'f>(
    files: impl Iterator<Item = (&'f str, &'f str)>,
    wanted: impl Fn(&str) -> bool,
) -> Instrumented {
    let mut done = Instrumented::default();
    let mut texts = Vec::new();
    for (name, text) in files {
        let is_c = name.ends_with(".c") || name.ends_with(".h");
        texts.push((
            name.to_owned(),
            match is_c && wanted(name) {
                true => file(name, text, &mut done),
                false => text.to_owned(),
            },
        ));
    }
    let (header, source) = arrays(&done);
    texts.push((HEADER.to_owned(), header));
    texts.push((SOURCE.to_owned(), source));
    done.files = texts;
    done
}

fn file(name: &str, text: &str, done: &mut Instrumented) -> String {
    // Insertions: the place, the order there, and the text.
    let mut inserted: Vec<(usize, u8, String)> = Vec::new();
    for function in scan::functions(text) {
        let first = done.decisions.len();
        for decision in &function.decisions {
            let of = |(from, to): (usize, usize)| {
                text[from..to].split_whitespace().collect::<Vec<_>>().join(" ")
            };
            if decision.conditions.len() > MOST {
                done.too_many.push(format!("{name}:{}", decision.line));
                continue;
            }
            let number = done.decisions.len();
            let places: Vec<_> = decision.conditions.iter().map(|it| it.range).collect();
            let observed = Observed {
                file: name.to_owned(),
                function: function.name.clone(),
                text: of(decision.range),
                conditions: decision.conditions.iter().map(|it| of(it.range)).collect(),
                shape: Shape::of(text, decision.range, &places),
                decision: decision.clone(),
                offset: done.bytes,
            };
            let (from, to) = decision.range;
            inserted.push((
                from,
                1,
                format!(
                    "bessemer_probe_end({number}U, {}U, (bessemer_probe_begin({number}U), (",
                    observed.offset
                ),
            ));
            inserted.push((to, 1, ")))".to_owned()));
            let mut weight = 1;
            for condition in &decision.conditions {
                let (from, to) = condition.range;
                inserted.push((from, 2, format!("bessemer_probe({number}U, {weight}U, (")));
                inserted.push((to, 0, "))".to_owned()));
                weight *= 3;
            }
            done.bytes += observed.combinations();
            done.decisions.push(observed);
        }
        for statement in function.statements.iter().filter(|it| it.kind != Kind::Declaration) {
            let by_decision = (!statement.is_in_block).then(|| {
                let own = |it: &Observed| {
                    it.file == name
                        && it.decision.range.0 >= statement.start
                        && it.decision.controls
                };
                done.decisions[first..].iter().position(own).map_or(usize::MAX, |at| first + at)
            });
            if by_decision.is_none() {
                let number = done.points.len();
                inserted.push((statement.start, 0, format!("bessemer_probe_at({number}U); ")));
            }
            done.points.push(Point {
                file: name.to_owned(),
                function: function.name.clone(),
                line: statement.line,
                by_decision,
            });
        }
    }
    if inserted.is_empty() {
        return text.to_owned();
    }
    // At one place, ends come before begins, and an outer begin before an inner one.
    let is_end = |text: &str| text.starts_with(')');
    inserted.sort_by(|one, other| {
        (one.0, !is_end(&one.2), one.1).cmp(&(other.0, !is_end(&other.2), other.1))
    });
    let mut result = format!("#include \"{HEADER}\"\n");
    let mut at = 0;
    for (place, _, piece) in inserted {
        result += &text[at..place];
        result += &piece;
        at = place;
    }
    result + &text[at..]
}

fn arrays(of: &Instrumented) -> (String, String) {
    let (points, decisions, bytes) =
        (of.points.len().max(1), of.decisions.len().max(1), of.bytes.max(1));
    let mut header = String::new();
    // Writing to a string cannot fail.
    let _ = write!(
        header,
        "#ifndef BESSEMER_PROBES_H\n#define BESSEMER_PROBES_H\n\n#include <stdbool.h>\n#include <stdint.h>\n\n\
/* Statements that ran, combinations of conditions that were seen, and the one that is being evaluated. */\n\
extern uint8_t bessemer_probe_ran[{points}];\nextern uint8_t bessemer_probe_seen[{bytes}];\n\
extern uint32_t bessemer_probe_trail[{decisions}];\n\n\
static inline void bessemer_probe_at(uint32_t point)\n{{\n    bessemer_probe_ran[point] = 1U;\n}}\n\n\
static inline void bessemer_probe_begin(uint32_t decision)\n{{\n    bessemer_probe_trail[decision] = 0U;\n}}\n\n\
static inline bool bessemer_probe(uint32_t decision, uint32_t weight, bool value)\n{{\n    \
bessemer_probe_trail[decision] += value ? 2U * weight : weight;\n    return value;\n}}\n\n\
static inline bool bessemer_probe_end(uint32_t decision, uint32_t offset, bool value)\n{{\n    \
bessemer_probe_seen[offset + 2U * bessemer_probe_trail[decision] + (value ? 1U : 0U)] = 1U;\n    return value;\n}}\n\n#endif\n"
    );
    let source = format!(
        "#include \"{HEADER}\"\n\nuint8_t bessemer_probe_ran[{points}];\nuint8_t bessemer_probe_seen[{bytes}];\n\
uint32_t bessemer_probe_trail[{decisions}];\n"
    );
    (header, source)
}

/// Adds to a program that it writes the arrays at its end, to the file that its first argument names.
pub fn writing(main: &str) -> Option<String> {
    let (before, after) = main.split_once("int main(void)")?;
    Some(format!(
        "#include <stdio.h>\n#include <stdlib.h>\n#include \"{HEADER}\"\n{before}static void bessemer_probed_main(void){after}\n\
static const char *bessemer_probe_file;\n\nstatic void bessemer_probe_write(void)\n{{\n    \
FILE *file = fopen(bessemer_probe_file, \"wb\");\n    if (file != NULL) {{\n        \
(void)fwrite(bessemer_probe_ran, 1U, sizeof(bessemer_probe_ran), file);\n        \
(void)fwrite(bessemer_probe_seen, 1U, sizeof(bessemer_probe_seen), file);\n        \
(void)fclose(file);\n    }}\n}}\n\nint main(int count, char **words)\n{{\n    if (count < 2) {{\n        return 99;\n    }}\n    \
bessemer_probe_file = words[1];\n    (void)atexit(bessemer_probe_write);\n    bessemer_probed_main();\n    return 0;\n}}\n"
    ))
}
