//! MISRA C:2012, by cppcheck's addon, over the C of the models and of the corpus. Each finding belongs to a rule that
//! `docs/misra.md` lists with its reason.
//!
//! A full run looks at every source, any other at a few alternately. None where cppcheck is not requested: see
//! `BESSEMER_LEGS`.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_tests::process::lay_out;
use bessemer_tests::store::once;
use bessemer_tests::{corpus, texts, toolchain, turn};

/// Sources of a run that is not full, of the models and of the corpus: half a second of processor each.
const SOME: usize = 3;

/// Macros that compilers define and cppcheck does not know: the head of each source requires them.
const KNOWN: [&str; 8] = [
    "-DFLT_MANT_DIG=24",
    "-DDBL_MANT_DIG=53",
    "-DFLT_EVAL_METHOD=0",
    "-DUINT64_C(x)=x##ULL",
    "-DINT64_C(x)=x##LL",
    "-DINT32_MIN=(-2147483647-1)",
    "-DINT64_MIN=(-9223372036854775807LL-1)",
    "-DBESSEMER_PLAIN",
];

const MISSING: &str = "cppcheck does not run: `cargo xtask test --install` installs it";

#[test]
fn each_finding_is_of_a_rule_with_a_reason() {
    if !toolchain::is_asked_for("cppcheck") {
        return;
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let page = std::fs::read_to_string(root.join("docs/misra.md")).expect("the page");
    // cppcheck leaves files beside what it looks at.
    let folder = tempfile::tempdir().expect("a folder");
    let of_models = copied(&root.join("generated"), folder.path());
    let models: Vec<_> = of_models.iter().map(|it| std::fs::read(it).expect("a source")).collect();
    let content = (texts(&corpus().files), models, &page);
    once("rules of MISRA C", &content, || hold_to_rules(of_models, &page));
}

fn hold_to_rules(of_models: Vec<PathBuf>, page: &str) {
    let of_corpus = lay_out(corpus()).expect("the C of the corpus");
    // Each package by itself: two of them may have one name.
    let mut found = findings(&turn::some_of(of_corpus.sources().to_vec(), SOME));
    found.extend(findings(&turn::some_of(of_models, SOME)));

    let listed = rules(page);
    let unlisted: Vec<_> = found.iter().filter(|(rule, _)| !listed.contains(rule)).collect();
    assert!(
        unlisted.is_empty(),
        "The C goes against rules that docs/misra.md does not list: mend it, or give a reason there.\n{unlisted:#?}"
    );
}

/// The C of a folder in another; its sources there.
fn copied(from: &Path, to: &Path) -> Vec<PathBuf> {
    let mut sources = Vec::new();
    for entry in std::fs::read_dir(from).expect("a folder of C").flatten() {
        let path = to.join(entry.file_name());
        std::fs::copy(entry.path(), &path).expect("a copy");
        sources.extend(path.extension().is_some_and(|it| it == "c").then_some(path));
    }
    sources.sort();
    sources
}

/// The rules that the sources go against, each with the first place.
fn findings(sources: &[PathBuf]) -> BTreeMap<String, String> {
    let output = Command::new("cppcheck")
        .args(["--addon=misra", "--std=c99", "--quiet", "--template={file}:{line} {id}"])
        .args(KNOWN)
        .args(sources)
        .output()
        .expect(MISSING);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    let mut found = BTreeMap::new();
    for line in said.lines() {
        let Some((place, rule)) = line.split_once(" misra-c2012-") else {
            assert!(line.trim().is_empty(), "cppcheck says: {line}");
            continue;
        };
        found.entry(rule.to_owned()).or_insert_with(|| place.to_owned());
    }
    found
}

/// The first column of the page's table.
fn rules(page: &str) -> Vec<String> {
    let rows = page.lines().filter_map(|line| line.strip_prefix("| "));
    let first = rows.filter_map(|row| row.split(" | ").next());
    let is_rule = |it: &&str| it.starts_with(|letter: char| letter.is_ascii_digit());
    first.filter(is_rule).map(str::to_owned).collect()
}
