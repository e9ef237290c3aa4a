//! Makes a program that differs smaller: leaves lines out while it still does.
//!
//! Many variants go through one build, since a build is what takes time.

use std::collections::BTreeSet;

use bessemer_tests::workspace::Workspace;

use super::writer::Program;
use super::{Batch, differing};

/// Variants in a build.
const VARIANTS: usize = 160;
/// Builds.
const ROUNDS: usize = 25;

/// The smallest variant of each program that was found.
pub fn shrunk(workspace: &Workspace, programs: &[&Program]) -> Vec<Program> {
    if programs.is_empty() {
        return Vec::new();
    }
    let mut best: Vec<Program> = programs
        .iter()
        .enumerate()
        .map(|(of, program)| named(program, &program.text, &format!("v{of}_0")))
        .collect();
    for round in 0..ROUNDS {
        let mut all = Vec::new();
        for (of, one) in best.iter().enumerate() {
            let texts = variants(&one.text, round, VARIANTS / programs.len());
            all.extend(texts.iter().enumerate().map(|(index, text)| {
                named(one, text, &format!("v{of}_{}", round * VARIANTS + index + 1))
            }));
        }
        let mut batch = Batch::of(all);
        let differing = differing(workspace, &mut batch);
        let mut smaller = false;
        for program in batch.programs.into_iter().filter(|it| differing.contains(&it.name)) {
            let of = program.name[1..].split('_').next().and_then(|of| of.parse::<usize>().ok());
            let one = &mut best[of.expect("its own name")];
            if program.text.len() < one.text.len() {
                *one = program;
                smaller = true;
            }
        }
        if !smaller && round > 3 {
            break;
        }
    }
    best
}

/// The program with another text and name.
pub(super) fn named(program: &Program, text: &str, name: &str) -> Program {
    let renamed = |text: &str| {
        let text = text.replace(&program.name, name);
        text.replace(&program.name.to_uppercase(), &name.to_uppercase())
    };
    let text = renamed(text);
    Program {
        name: name.to_owned(),
        text,
        unit: program.unit.as_deref().map(renamed),
        entries: program.entries.iter().map(|entry| entry.renamed(&renamed)).collect(),
        instances: program.instances,
    }
}

/// Texts without some lines, or with a group in parentheses replaced: the largest first, others in each round.
fn variants(text: &str, round: usize, count: usize) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let mut all = BTreeSet::new();
    for from in 0..lines.len() {
        let mut depth = 0_i64;
        for to in from..lines.len() {
            let opened = |c: char| lines[to].matches(c).count() as i64;
            let least: i64 = opened('{') - opened('}') + opened('(') - opened(')');
            depth += least;
            if depth == 0 {
                let kept = [&lines[..from], &lines[to + 1..]].concat();
                all.insert(kept.join("\n") + "\n");
            }
            if depth < 0 {
                break;
            }
        }
    }
    for (at, _) in text.match_indices('(') {
        if let Some(end) = closing(text, at) {
            for value in ["(0)", "(1)", "true", "()"] {
                all.insert(format!("{}{value}{}", &text[..at], &text[end + 1..]));
            }
            let inner = &text[at + 1..end];
            for operator in [" + ", ", ", " && ", " < ", " == "] {
                if let Some((one, other)) = inner.split_once(operator) {
                    all.insert(format!("{}{one}{}", &text[..at], &text[end + 1..]));
                    all.insert(format!("{}{other}{}", &text[..at], &text[end + 1..]));
                }
            }
        }
    }
    for (at, _) in text.match_indices("{ ") {
        if let Some(end) = closing(text, at) {
            all.insert(format!("{} {{ }} {}", &text[..at], &text[end + 1..]));
        }
    }
    // What the native program names stays.
    let named =
        |text: &str| ["pub fn ", "pub struct ", "pub enum "].map(|item| text.matches(item).count());
    let mut all: Vec<String> = all.into_iter().filter(|it| named(it) == named(text)).collect();
    all.sort_by_key(String::len);
    let step = (all.len() / count).max(1);
    // Some of each size, others in each round.
    all.into_iter().skip(round % step).step_by(step).take(count).collect()
}

fn closing(text: &str, at: usize) -> Option<usize> {
    let mut depth = 0_i64;
    for (index, c) in text[at..].char_indices() {
        match c {
            '(' | '{' | '[' => depth += 1,
            ')' | '}' | ']' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some(at + index);
        }
    }
    None
}
