//! Counts what a reviewer stumbles over in the emitted C: in `generated/`, and in the golden files of the corpus.
//!
//! The counts are committed in `signed.txt`. Those of `generated/` may only fall; those of the corpus also grow with its
//! programs. `UPDATE_DOCS=1 cargo test -p xtask --test signed` writes them, and never where one of `generated/` rose.

mod shared;

use std::collections::BTreeSet;

use shared::{files, root};

/// The file of the counts.
const COUNTS: &str = "xtask/tests/signed.txt";

/// Endings of names that the generator chose for want of a better one.
const VAGUE: [&str; 5] = ["_choice", "_holds", "_part", "_operand", "_left"];

/// Types that a cast of a cast may have.
const TYPES: [&str; 10] = [
    "int8_t", "int16_t", "int32_t", "int64_t", "uint8_t", "uint16_t", "uint32_t", "uint64_t",
    "float", "double",
];

/// A variable that a line declares, with the text of its value if the line is `name = value;`.
#[derive(Debug, PartialEq)]
struct Declared<'l> {
    name: &'l str,
    value: Option<&'l str>,
    constant: bool,
}

/// Returns the variable that a line declares.
fn declared(line: &str) -> Option<Declared<'_>> {
    let text = line.trim_start();
    let text = text.strip_prefix("for (").unwrap_or(text);
    let end = text.find(['=', ';', '['])?;
    let mut words: Vec<&str> = text[..end].split_whitespace().collect();
    let is_name = |word: &&str| {
        let word = word.trim_start_matches('*');
        !word.is_empty() && word.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
    };
    let name = words.pop()?;
    let is_type =
        !words.is_empty() && !matches!(words[0], "return" | "goto" | "typedef" | "extern");
    if !is_type || !words.iter().all(is_name) || !is_name(&name) {
        return None;
    }
    let value = text[end..].strip_prefix("= ").and_then(|rest| rest.strip_suffix(';'));
    Some(Declared { name: name.trim_start_matches('*'), value, constant: words[0] == "const" })
}

/// Returns true if a number at the end of a name distinguishes it from another. Then the name without it is among the
/// words of the file, and the name with 0 is not: otherwise the number is the index of an element.
fn is_numbered(name: &str, words: &BTreeSet<&str>) -> bool {
    name.rsplit_once('_').is_some_and(|(stem, number)| {
        number.len() == 1
            && number.as_bytes()[0].is_ascii_digit()
            && stem.ends_with(|c: char| c.is_ascii_lowercase())
            && words.contains(stem)
            && !words.contains(format!("{stem}_0").as_str())
    })
}

/// Returns true if a value is a name alone.
fn is_alone(value: &str) -> bool {
    value.starts_with(|c: char| c.is_ascii_lowercase())
        && value.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// Returns the number of casts of casts in a line.
fn casts_of_casts(line: &str) -> usize {
    let pair = |(a, b): (&str, &str)| format!("({a})({b})");
    let pairs = TYPES.iter().flat_map(|a| TYPES.iter().map(move |b| (*a, *b)));
    pairs.map(|types| line.matches(pair(types).as_str()).count()).sum()
}

/// Counts everything in files of C.
fn counts<'t>(texts: impl Iterator<Item = &'t str>) -> [(&'static str, usize); 4] {
    let [mut numbered, mut vague, mut renamed, mut casts] = [0; 4];
    for text in texts {
        let words: BTreeSet<&str> =
            text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').collect();
        for line in text.lines() {
            casts += casts_of_casts(line);
            let Some(Declared { name, value, constant }) = declared(line) else { continue };
            numbered += usize::from(is_numbered(name, &words));
            vague += usize::from(VAGUE.iter().any(|ending| name.ends_with(ending)));
            renamed += usize::from(constant && value.is_some_and(is_alone));
        }
    }
    [
        ("variables whose name is numbered", numbered),
        ("variables whose name says nothing", vague),
        ("constants that only rename", renamed),
        ("casts of casts", casts),
    ]
}

#[test]
fn each_count_of_the_models_only_falls() {
    let all = files();
    let of = |folder: &str| {
        let is_c =
            |path: &str| path.starts_with(folder) && (path.ends_with(".c") || path.ends_with(".h"));
        let files = all.iter().filter(move |file| is_c(&file.path));
        counts(files.map(|file| file.text.as_str()))
    };
    let (models, corpus) = (of("generated/"), of("tests/corpus/golden/"));
    let path = root().join(COUNTS);
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    let bound = |what: &str| {
        let line = committed.lines().find(|line| line.ends_with(what));
        line.and_then(|line| line.split_whitespace().next()?.parse().ok()).unwrap_or(usize::MAX)
    };
    for (what, count) in models {
        assert!(count <= bound(what), "{count} {what} in generated/, more than {}", bound(what));
    }
    let line = |((what, one), (_, other)): ((&str, usize), (&str, usize))| {
        format!("{one:>4} {other:>4} {what}\n")
    };
    let rows: String = models.into_iter().zip(corpus).map(line).collect();
    let table = format!("generated/, golden files of the corpus\n{rows}");
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(&path, table).expect("the counts are written");
    } else {
        let renewal = "UPDATE_DOCS=1 cargo test -p xtask --test signed";
        assert!(committed == table, "{COUNTS} is stale: run {renewal}. It should be\n{table}");
    }
}

#[test]
fn what_counts() {
    let c = "    rates[row] = next_0;\n\
             \x20   const double next_1 = 0.0;\n\
             \x20   const uint32_t index = others_taken;\n\
             \x20   double rates_2[3];\n\
             \x20   for (uint32_t row_2 = 0U; row_2 < 3U; row_2++) {\n\
             \x20       double *const kept_part = &work[36];\n\
             \x20       sum_2 += (int64_t)(uint32_t)index;\n\
             \x20       return value_2;\n\
             product_f64_3x3_3x3(a, b, c);\n\
             static const double table_6x6[36] = {\n";
    let counts = counts([c].into_iter()).map(|(_, count)| count);
    assert_eq!(counts, [2, 1, 1, 1]);
}
