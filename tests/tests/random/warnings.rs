//! Warnings of a C compiler in the C of random programs: each is a fault of ours, since no emitted C raises a warning.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_backend::c::CFile;

use super::legs::Difference;

/// Warnings that the program itself causes. It compares a value with itself or with an impossible constant; or an
/// optimiser looks behind a check that always fails, as at the shift in `if n > 31 { return FAULT; } 1 << n` with n
/// known to be 40.
const OWN: [&str; 8] = [
    "[-Wtautological-",
    "[-Wtype-limits]",
    "[-Wshift-count-",
    "[-Wshift-overflow",
    "[-Wdiv-by-zero]",
    "[-Warray-bounds",
    "[-Wstringop-",
    "[-Wdivision-by-zero]",
];

/// The first warning of each program that has one.
pub fn told(leg: &str, said: &str, files: &[CFile], programs: &BTreeSet<&str>) -> Vec<Difference> {
    let mut told = BTreeMap::new();
    for line in said.lines() {
        let Some((place, warning)) = line.split_once(": warning: ") else { continue };
        if OWN.iter().any(|own| warning.contains(own)) {
            continue;
        }
        let mut parts = place.rsplitn(3, ':').collect::<Vec<_>>().into_iter().rev();
        let (file, number) = (parts.next().unwrap_or_default(), parts.next().unwrap_or_default());
        let file = files.iter().find(|it| file.ends_with(&format!("/{}", it.name)));
        let number = number.parse().unwrap_or(0);
        let text = file.map(|it| it.text.as_str()).unwrap_or_default();
        let program = owner(text, number, programs).unwrap_or("all").to_owned();
        let around = around(text, number);
        told.entry(program).or_insert_with(|| format!("warned of in {leg}: {warning}\n{around}"));
    }
    let difference = |(program, text): (String, String)| Difference {
        text: format!("{program} {text}"),
        program,
    };
    told.into_iter().map(difference).collect()
}

/// The program whose function or type a line of C belongs to: the last that is named outside of braces, up to it.
fn owner<'p>(text: &str, number: usize, programs: &BTreeSet<&'p str>) -> Option<&'p str> {
    let above: Vec<&str> = text.lines().take(number).collect();
    let outside = above.iter().rev().filter(|line| line.starts_with(char::is_alphabetic));
    let words = outside.flat_map(|line| line.split(|c: char| !c.is_alphanumeric()));
    words.flat_map(|word| programs.get(word)).next().copied()
}

/// The line with those beside it.
fn around(text: &str, number: usize) -> String {
    let lines = text.lines().enumerate().skip(number.saturating_sub(4)).take(6);
    lines.map(|(at, line)| format!("    {} {line}\n", at + 1)).collect()
}
