//! MC/DC of the instrumented C is held to the numbers of `clang -fcoverage-mcdc`. The decisions have all shapes, and the
//! inputs cover them in part.
//!
//! clang counts decisions of two and more conditions. It runs where clang 19 with its LLVM is installed; `BESSEMER_FULL`
//! requires it.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use bessemer_dossier::coverage::instrument::{self, Instrumented};
use bessemer_dossier::coverage::{self, Seen};
use bessemer_dossier::trace::Folder;

const SHAPES: &str = include_str!("shapes.c");
const HEADER: &str = include_str!("shapes.h");
const MAIN: &str = "#include <inttypes.h>\n#include <stdio.h>\n#include \"shapes.h\"\n\nint main(void)\n{\n    \
    uint32_t w[4];\n    while (scanf(\"%\" SCNu32 \"%\" SCNu32 \"%\" SCNu32 \"%\" SCNu32, w, w + 1, w + 2, w + 3) == 4) {\n        \
    (void)printf(\"%\" PRIu32 \"\\n\", shapes(w[0], w[1], w[2], w[3]));\n    }\n}\n";

/// Runs a command that must succeed; returns its output.
fn run(command: &mut Command, input: &str) -> Vec<u8> {
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("it starts");
    child.stdin.take().expect("a pipe").write_all(input.as_bytes()).expect("it reads");
    let output = child.wait_with_output().expect("it ends");
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&output.stderr));
    output.stdout
}

/// Covered conditions, and all, of decisions with two and more.
fn own(done: &Instrumented, seen: &Seen) -> (u64, u64) {
    let texts = BTreeMap::from([("shapes.c".to_owned(), SHAPES.to_owned())]);
    let folder = Folder::of(&texts, Path::new("x")).expect("a folder");
    let report = coverage::report(done, seen, &folder, Vec::new());
    let (mut covered, mut all) = (0, 0);
    for decision in done.decisions.iter().filter(|it| it.conditions.len() > 1) {
        let place = format!("shapes.c:{}", decision.decision.line);
        let own =
            report.conditions.iter().filter(|it| it.place == place && it.text == decision.text);
        let count = decision.conditions.len();
        (covered, all) = (covered + count - own.count(), all + count);
    }
    (covered as u64, all as u64)
}

#[test]
fn conditions_are_counted_as_clang_counts_them() {
    let there = |name: &str| Command::new(name).arg("--version").output().is_ok();
    if !["clang-19", "llvm-profdata-19", "llvm-cov-19"].into_iter().all(there) {
        assert!(std::env::var_os("BESSEMER_FULL").is_none(), "clang 19 and llvm 19 are missing");
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name);
    let files = [("shapes.c", SHAPES), ("shapes.h", HEADER)];
    let done = instrument::instrument(files.into_iter(), |name| name == "shapes.c");
    let compile = |text: &[(&str, &str)], program: &str, flags: &[&str]| {
        text.iter().for_each(|(name, text)| fs::write(file(name), text).expect("a file"));
        let sources = text.iter().map(|it| it.0).filter(|name| name.ends_with(".c"));
        let mut clang = Command::new("clang-19");
        clang.current_dir(folder.path()).args(["-std=c99", "-o", program]).args(flags);
        run(clang.args(sources), "");
    };
    let coverage = ["-fprofile-instr-generate", "-fcoverage-mapping", "-fcoverage-mcdc"];
    compile(&[files[0], files[1], ("main.c", MAIN)], "theirs", &coverage);
    let main = instrument::writing(MAIN).expect("a program");
    let probed: Vec<(&str, &str)> =
        done.files.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
    compile(&[&probed[..], &[("main.c", &main)]].concat(), "ours", &[]);

    let mut shares = Vec::new();
    let mut state = 1_u64;
    for calls in 0..40 {
        let mut input = String::new();
        for _ in 0..4 * calls {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            input += &format!("{} ", (state >> 33) % 4);
        }
        let ours = run(Command::new(file("ours")).arg(file("seen")), &input);
        let mut theirs = Command::new(file("theirs"));
        theirs.env("LLVM_PROFILE_FILE", file("raw"));
        assert_eq!(ours, run(&mut theirs, &input), "the probes change the results");
        let mut merge = Command::new("llvm-profdata-19");
        run(merge.arg("merge").arg(file("raw")).arg("-o").arg(file("profile")), "");
        let mut export = Command::new("llvm-cov-19");
        export.args(["export", "--summary-only"]).arg(file("theirs"));
        export.arg(format!("--instr-profile={}", file("profile").display())).arg(file("shapes.c"));
        let json: serde_json::Value =
            serde_json::from_slice(&run(&mut export, "")).expect("its summary");
        let mcdc = &json["data"][0]["totals"]["mcdc"];
        let theirs = (mcdc["covered"].as_u64(), mcdc["count"].as_u64());
        let bytes = fs::read(file("seen")).expect("what was seen");
        let ours = own(&done, &Seen::read(&bytes, &done).expect("its size"));
        assert_eq!((Some(ours.0), Some(ours.1)), theirs, "{calls} calls: {input}");
        shares.push(ours.0);
    }
    shares.dedup();
    assert!(shares.len() > 5, "the inputs cover too much alike: {shares:?}");
}
