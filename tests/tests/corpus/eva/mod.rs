//! An independent analysis of the removed checks: Frama-C's Eva over the corpus' C with each proved check in place, and
//! any words as arguments. A check that Eva cannot prove fails the test.
//!
//! `unseen.tsv` lists what Eva cannot see, each with the reason: it knows intervals and few relations of two values.
//! The list may only shrink: a row that is not needed fails, too.
//!
//! A full run takes every program, any other one alternately. None where Frama-C is not requested: see `BESSEMER_LEGS`.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use bessemer_backend::passes;
use bessemer_codegen::compile::Compiled;
use bessemer_ir::visit::Walk as _;
use bessemer_ir::{FunctionId, Module};
use bessemer_tests::process::{Folder, lay_out_needed};
use bessemer_tests::store::once;
use bessemer_tests::{harness, texts, toolchain, turn};

use super::{callable, kept, kept_options, natives};

/// Programs of a run that is not full: one is three to thirteen seconds of processor.
const SOME: usize = 1;
/// Most statements of such a program, with the functions that it calls. Larger ones are left to a full run.
const MOST: usize = 300;
/// Seconds that a program may take, on a machine that has other work.
const PATIENCE: &str = "600";

/// Precision of Eva at first, and for the unproved rest: more separate states, relations of two values.
const GLANCE: &[&str] = &["-eva-precision", "2"];
const LOOK: &[&str] =
    &["-eva-precision", "6", "-eva-auto-loop-unroll", "256", "-eva-domains", "octagon,equality"];

/// Declaration of `abort` for Eva, by which a proved check ends the program: a function that nothing may call.
const NEVER: &str = "#include <stdlib.h>
/*@ requires left_out: \\false; assigns \\nothing; ensures \\false; */
void left_out(void);
#define abort left_out
";

/// Macros that compilers define, and for which Frama-C has no headers.
const MACHINE: &str = "-DBESSEMER_PLAIN -U__SSE2__ -U__AVX__";

const MISSING: &str =
    "frama-c does not run: `cargo xtask test --install` installs it (frama-c-base of Debian)";

type Entries = Vec<(FunctionId, u32)>;

/// The checks of a program that fail for all that Eva sees: the file, and what is asked of it. Where some are known, a glance
/// would be in vain.
fn unseen(compiled: &Compiled, entries: &Entries, some_are_known: bool) -> Vec<String> {
    let main = harness::programs_with(&compiled.explicit, entries, &kept_options());
    let folder = lay_out_needed(&compiled.files, &main).expect("the C");
    let has_checks =
        |path: &Path| std::fs::read_to_string(path).is_ok_and(|text| text.contains("abort();"));
    if !folder.sources().iter().any(|path| has_checks(path)) {
        return Vec::new();
    }
    std::fs::write(folder.path().join("eva_main.c"), main).expect("a file");
    std::fs::write(folder.path().join("never.h"), NEVER).expect("a file");
    let in_vain = some_are_known || !alarms(&folder, GLANCE).is_empty();
    if in_vain { alarms(&folder, LOOK) } else { Vec::new() }
}

fn alarms(folder: &Folder, settings: &[&str]) -> Vec<String> {
    let path = folder.path();
    let never = path.join("never.h");
    let output = Command::new("timeout")
        .args([PATIENCE, "frama-c", "-eva", "-eva-no-show-progress", "-machdep", "gcc_x86_64"])
        .args(settings)
        // Infinite numbers and NaN are values as any other.
        .args(["-warn-special-float", "none"])
        .arg(format!("-cpp-extra-args=-I{} -include {} {MACHINE}", path.display(), never.display()))
        .arg(path.join("eva_main.c"))
        .args(folder.sources())
        .output()
        .expect(MISSING);
    let said = String::from_utf8_lossy(&output.stdout);
    let complained = String::from_utf8_lossy(&output.stderr);
    assert!(said.contains("ANALYSIS SUMMARY"), "Eva came to no end:\n{said}\n{complained}");
    let told = said.lines().zip(said.lines().skip(1));
    let told = told.filter(|(_, line)| line.contains("left_out: precondition"));
    let mut unseen: Vec<String> = told.map(|(place, _)| asked(path, place)).collect();
    unseen.sort();
    unseen
}

/// Returns the condition of a check at the place of its call: `[eva:alarm] FILE:LINE: Warning:`.
fn asked(folder: &Path, place: &str) -> String {
    let place = place.trim_start_matches("[eva:alarm] ");
    let mut parts = place.split(':');
    let (file, line) = (parts.next().expect("a file"), parts.next().expect("a line"));
    let file = Path::new(file).file_name().expect("a file").to_string_lossy().into_owned();
    let text = std::fs::read_to_string(folder.join(&file)).expect("a file of the C");
    let above: Vec<&str> = text.lines().take(line.parse().expect("a line")).collect();
    let first =
        above.iter().rposition(|line| line.trim_start().starts_with("if (")).expect("a check");
    let condition: Vec<&str> = above[first..above.len() - 1].iter().map(|it| it.trim()).collect();
    format!("{file}\t{}", condition.join(" ").trim_end_matches(" {"))
}

/// Returns the checks that Eva is known not to prove, by program.
fn known() -> BTreeMap<&'static str, Vec<String>> {
    let mut known: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for row in include_str!("unseen.tsv").lines().skip(1) {
        let [program, file, check, reason] = row.split('\t').collect::<Vec<_>>()[..] else {
            panic!("four columns: {row}")
        };
        assert!(!reason.is_empty(), "a reason: {row}");
        known.entry(program).or_default().push(format!("{file}\t{check}"));
    }
    known.values_mut().for_each(|checks| checks.sort());
    known
}

#[test]
fn what_was_left_out_cannot_fail() {
    if !toolchain::is_asked_for("frama-c") {
        return;
    }
    let kept = kept();
    once("what was left out, to Eva", &texts(&kept.files), || look_at_some(kept));
}

fn look_at_some(kept: &Compiled) {
    let mut programs: BTreeMap<&str, Entries> = BTreeMap::new();
    for native in natives() {
        let id = callable(kept, native).expect("it was compiled");
        let params = kept.module.functions[id.index()].params;
        programs.entry(native.module).or_default().push((id, params));
    }
    let known = known();
    if let Some(unknown) = known.keys().find(|program| !programs.contains_key(**program)) {
        panic!("unseen.tsv names `{unknown}`, which is no program of the corpus");
    }
    if !turn::is_full() {
        programs.retain(|_, entries| statements(&kept.explicit, entries) <= MOST);
    }
    let programs = turn::some_of(programs.into_iter().collect(), SOME);
    let (next, wrong) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let work = || {
        while let Some((name, entries)) = programs.get(next.fetch_add(1, Ordering::Relaxed)) {
            let known = known.get(name).cloned().unwrap_or_default();
            let unseen = unseen(kept, entries, !known.is_empty());
            let mut wrong = wrong.lock().expect("no worker stops");
            wrong.extend(
                without(&unseen, &known).map(|it| format!("not seen to hold: {name}\t{it}")),
            );
            wrong.extend(without(&known, &unseen).map(|it| format!("seen now: {name}\t{it}")));
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    let wrong = wrong.into_inner().expect("no worker stops");
    assert!(
        wrong.is_empty(),
        "A check that was left out may be wrong, or Eva does not see why it holds: read it, and say so in unseen.tsv. \
         A row there of what is seen goes.\n{}",
        wrong.join("\n")
    );
}

/// Returns the number of statements of entries and of the functions that they call.
fn statements(module: &Module, entries: &Entries) -> usize {
    let reached = entries.iter().flat_map(|(id, _)| passes::reached(module, id.index()));
    let functions: BTreeSet<usize> = reached.collect();
    let mut count = 0;
    for function in functions {
        module.functions[function].body.0.each_stmt(|_| count += 1);
    }
    count
}

/// Returns those of the first list that are not in the second, with multiplicity.
fn without<'a>(these: &'a [String], others: &'a [String]) -> impl Iterator<Item = &'a String> {
    let count = |of: &[String], it: &String| of.iter().filter(|other| *other == it).count();
    these
        .iter()
        .enumerate()
        .filter_map(move |(at, it)| (count(&these[..at], it) >= count(others, it)).then_some(it))
}
