//! Random programs in the DSL's Rust on all legs. Results of rustc's program are compared with those of the interpreter
//! and the C: the bits of each result and the kind of each fault.
//!
//! Each turn has a seed of its own. `BESSEMER_RANDOM=seeds` runs that many batches, from the seed
//! `BESSEMER_RANDOM_FROM`, instead of a smaller one. `cargo xtask fuzz` runs many that aim at the proofs.
//! `BESSEMER_FOUND=folder`, with `-- --ignored those_of_a_folder`, runs what someone wrote.

mod aimed;
mod beside;
mod bounded;
mod calls;
mod chains;
mod found;
mod fuzz;
mod generics;
mod interfaces;
mod legs;
mod links;
mod matrices;
mod native;
mod numbers;
mod options;
mod patterns;
mod reference;
mod shrink;
mod slices;
mod statements;
mod texts;
mod types;
mod values;
mod warnings;
mod writer;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use bessemer_backend::c::CFile;
use bessemer_codegen::compile::{self, Compiled, Options};
use bessemer_codegen::generate::{Error, Tree};
use bessemer_frontend::diagnostic;
use bessemer_frontend::source::Sources;
use bessemer_ir::tree::Package;
use bessemer_tests::random::Random;
use bessemer_tests::toolchain::{self, Toolchain};
use bessemer_tests::turn;
use bessemer_tests::workspace::Workspace;

use legs::{Difference, in_c, interpreted};
use writer::Program;

/// Programs in a batch of a full run, and of any other.
const PROGRAMS: usize = 36;
const FEWER: usize = 8;
/// Texts that aim at the proofs, of a seed that stays and of one that does not, and the instances of each.
const AIMED: usize = 4;
/// Small bodies of a seed whose operands write, or that have iterators with a name.
const BESIDE: usize = 16;
const ITERATING: usize = 8;
const INSTANCES: usize = 4;

const SANITIZED: [&str; 3] = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-w"];
/// Warnings are reported, each with its program, and the rest goes on.
const WARNED: [&str; 1] = ["-Wno-error"];

/// Returns true if the tool contradicted itself, which is no answer to any program.
fn is_internal(why: &str) -> bool {
    why.contains(diagnostic::OUR_FAULT)
}

/// Some programs in one file.
struct Batch {
    programs: Vec<Program>,
    /// Those that are left out, and why.
    refused: BTreeMap<String, String>,
    /// Those that rustc refused: mistakes of this generator.
    mistaken: BTreeMap<String, String>,
    /// The first line of each program that is in the file.
    lines: Vec<(usize, String)>,
    /// The file.
    text: String,
    /// True if it is one of many: what is dear is then done for a part of them.
    is_of_many: bool,
    /// True if rustc gets one function of each text instead of its instances, which costs it a tenth.
    of_one: bool,
}

impl Batch {
    fn new(seed: u64, programs: usize) -> Batch {
        let program = |index| {
            let mut random = Random(seed << 32 | index as u64);
            writer::program(&mut random, &format!("p{index}"))
        };
        Batch::of((0..programs).map(program).collect())
    }

    /// Returns a batch of texts that aim at the proofs, with a number of instances each.
    fn aimed(seed: u64, texts: usize, instances: usize) -> Batch {
        let program = |index| {
            let mut random = Random(!(seed << 32 | index as u64));
            aimed::program(&mut random, &format!("aimed{seed}_{index}"), instances)
        };
        Batch::of((0..texts).map(program).collect())
    }

    /// Returns a batch of small bodies whose operands write other operands' variables.
    fn beside(seed: u64, bodies: usize) -> Batch {
        let program = |index| {
            let mut random = Random(seed.rotate_left(32) ^ (3 << 62) ^ index as u64);
            beside::program(&mut random, &format!("beside{index}"))
        };
        Batch::of((0..bodies).map(program).collect())
    }

    /// Returns a batch of such bodies with explicit `next` calls.
    fn iterating(seed: u64, bodies: usize) -> Batch {
        let program = |index| {
            let mut random = Random(!seed.rotate_left(32) ^ (3 << 62) ^ index as u64);
            beside::iterating(&mut random, &format!("beside{index}"))
        };
        Batch::of((0..bodies).map(program).collect())
    }

    fn of(programs: Vec<Program>) -> Batch {
        Batch {
            programs,
            refused: BTreeMap::new(),
            mistaken: BTreeMap::new(),
            lines: Vec::new(),
            text: String::new(),
            is_of_many: false,
            of_one: false,
        }
    }

    /// Returns true if its programs aim at the proofs: small ones, of which there are many.
    fn is_aimed(&self) -> bool {
        self.programs.iter().all(|program| program.instances.is_some())
    }

    /// Returns true if its programs are small, and there are many of them.
    fn is_small(&self) -> bool {
        self.is_aimed() || self.programs.iter().all(|it| it.name.starts_with("beside"))
    }

    /// The programs that nobody has refused.
    fn left(&self) -> Vec<&Program> {
        let out = |name: &str| self.refused.contains_key(name) || self.mistaken.contains_key(name);
        self.programs.iter().filter(|it| !out(&it.name)).collect()
    }

    /// Returns errors of the IR's validation, which are errors of the tool.
    fn internal(&self) -> impl Iterator<Item = Difference> {
        let internal = self.refused.iter().filter(|it| is_internal(it.1));
        internal
            .map(|(name, why)| Difference { program: name.clone(), text: format!("{name}: {why}") })
    }

    fn is_made_of_one(&self, program: &Program) -> bool {
        self.of_one && program.instances.is_some()
    }

    /// Writes the file as the compiler gets it, or as the native program does.
    fn write(&mut self, workspace: &Workspace, native: bool) {
        let mut text = String::from(HEAD);
        for ty in types::INTS {
            text += &TICK.replace("TYPE", ty).replace("WORD", "x as u64");
        }
        text += &TICK.replace("TYPE", "bool").replace("WORD", "x as u64");
        text += &TICK.replace("TYPE", "f64").replace("WORD", "x.to_bits()");
        text += &TICK.replace("TYPE", "f32").replace("WORD", "x.to_bits() as u64");
        // Large enough to be left out where nothing needs it.
        if self.left().iter().any(|it| it.text.to_lowercase().contains("beside")) {
            text += beside::GIVEN;
        }
        let mut lines = Vec::new();
        for program in self.left() {
            lines.push((text.lines().count() + 1, program.name.clone()));
            text += &match (self.is_made_of_one(program), native) {
                (true, true) => aimed::with_constants_as_arguments(program),
                (true, false) => aimed::of_first_instance(program),
                (false, _) => program.text.clone(),
            };
        }
        self.lines = lines;
        workspace.set_source(&text).expect("a source file");
        self.text = text;
    }

    /// The program at a line.
    fn at(&self, line: usize) -> Option<String> {
        let found = self.lines.iter().rev().find(|(first, _)| *first <= line);
        found.map(|(_, name)| name.clone())
    }

    /// The programs that a compiler complains of, each with its first complaint; all that are left, if none can be reported.
    fn told(&self, said: &str, workspace: &Workspace) -> BTreeMap<String, String> {
        let mut reasons = BTreeMap::new();
        let (mut title, mut shown) = ("", 0);
        for line in said.lines() {
            if let Some((number, _)) = line.split_once('|') {
                shown = number.trim().parse().unwrap_or(shown);
            }
            // The mistake is in a fixed item, by the argument of a program.
            if line.ends_with("called here")
                && let Some(name) = self.at(shown)
            {
                reasons.entry(name).or_insert_with(|| title.to_owned());
            }
            if line.starts_with("error") {
                title = line;
                // A claim is refused where its check is: in the library, in a fixed item, or in the program.
                let claimed = line.split('`').nth(1).filter(|_| line.contains("is not infallible"));
                let left = self.left();
                if let Some(program) = left.iter().find(|it| claimed == Some(it.name.as_str())) {
                    reasons.entry(program.name.clone()).or_insert_with(|| title.to_owned());
                }
            }
            if let Some((number, _)) = place(line, native::SOURCE)
                && let Some(name) = native::at(workspace, number)
            {
                reasons.entry(name).or_insert_with(|| format!("{title}\n    where it is called"));
            }
            let Some((number, column)) = place(line, "src/lib.rs") else { continue };
            if let Some(name) = self.at(number) {
                let at = self.text.lines().nth(number - 1).unwrap_or_default();
                let (before, at) = at.split_at_checked(column - 1).unwrap_or(("", at));
                reasons.entry(name).or_insert_with(|| {
                    let before = &before[before.len().saturating_sub(80)..];
                    format!("{title}\n    {before} >>> {:.200}", at)
                });
            }
        }
        if reasons.is_empty() {
            let all = self.left();
            assert!(!all.is_empty(), "what the programs call is refused: {said}");
            reasons.extend(all.into_iter().map(|it| (it.name.clone(), said.to_owned())));
        }
        reasons
    }
}

/// The line and the column in a file that a line of a compiler's tells.
fn place(line: &str, file: &str) -> Option<(usize, usize)> {
    let (_, at) = line.split_once(&format!("{file}:"))?;
    let mut numbers = at.split(':').map(|it| it.parse::<usize>().unwrap_or(1));
    Some((numbers.next()?, numbers.next()?))
}

/// Beginning of each file. A program may import the same names itself: those of a glob give way.
const HEAD: &str = "//! Random programs.\n#![allow(warnings, arithmetic_overflow, unconditional_panic, overflowing_literals)]\n\
                    #![allow(clippy::all)]\nuse bessemer::prelude::*;\n\
                    mod imported {\n\
                    pub use bessemer::nalgebra::{Complex, ComplexField};\n\
                    pub use core::cmp::Reverse;\n\
                    pub use core::num::{NonZeroU32, Wrapping};\n\
                    pub use core::ops::{AddAssign, DivAssign, MulAssign, SubAssign};\n}\n\
                    use imported::*;\n";

const TICK: &str = "
/// Tells `t` of a value.
#[function]
pub fn tick_TYPE(x: TYPE, t: &mut u64) -> TYPE {
    *t = t.wrapping_mul(31).wrapping_add(WORD);
    x
}
";

/// Results of a batch without the refused programs.
struct Built {
    /// The native program.
    native: String,
    /// The names of the entries in it.
    places: Vec<String>,
    compiled: Compiled,
    /// C with the proved checks.
    kept: Compiled,
}

fn built(workspace: &Workspace, batch: &mut Batch) -> Built {
    let native = loop {
        batch.write(workspace, true);
        let result = native::build(workspace, &batch.left());
        match result {
            Ok(native) => break native,
            Err(said) => {
                let told = batch.told(&said, workspace);
                // What has no number of rustc's is said by the DSL's attributes.
                let (mistaken, refused) = told.into_iter().partition(|it| it.1.contains("error[E"));
                batch.mistaken.extend::<BTreeMap<_, _>>(mistaken);
                batch.refused.extend::<BTreeMap<_, _>>(refused);
            }
        }
    };
    // Their places in the native program, which has more than what is left in the end.
    let entries = batch.left().into_iter().flat_map(|it| &it.entries);
    let places = entries.map(|it| it.name.clone()).collect();
    let sources = Sources::new(workspace.path(""));
    let mut package = tree(workspace, batch);
    loop {
        match compile::compile(&package, &sources, &Options::default()) {
            Ok(mut compiled) => {
                let options = Options { keep_checks: true, ..Options::default() };
                let kept = compiled.anew(&options).map_err(drop);
                let mut kept = kept.expect("what compiles does so with checks that were proved");
                compiled.files.extend(brought());
                kept.files.extend(brought());
                return Built { native, places, compiled, kept };
            }
            Err(errors) => {
                let told = batch.told(&diagnostic::render(&errors, &sources, false), workspace);
                // Nothing else names what such programs have: they need no build of their own to be without.
                let is_small = batch.is_small();
                if is_small {
                    without(&mut package, &told);
                }
                batch.refused.extend(told);
                if !is_small {
                    package = tree(workspace, batch);
                }
            }
        }
    }
}

/// The C that a firmware brings for the function that is external.
fn brought() -> impl Iterator<Item = CFile> {
    let file = |(name, text): (&str, &str)| CFile {
        name: name.to_owned(),
        text: text.to_owned(),
        map: Vec::new(),
    };
    beside::SENSOR.into_iter().map(file)
}

/// The tree of what is left of a batch.
fn tree(workspace: &Workspace, batch: &mut Batch) -> Package {
    loop {
        batch.write(workspace, false);
        let said = match workspace.tree() {
            Ok(Tree { mut package, .. }) => {
                for program in batch.left() {
                    match batch.is_made_of_one(program) {
                        true => aimed::instantiate(&mut package, program),
                        false => aimed::hold(&package, program),
                    }
                }
                return package;
            }
            Err(Error::Models(said) | Error::Refused(said)) => said.to_string(),
            Err(error) => panic!("{error}"),
        };
        let told = batch.told(&said, workspace);
        batch.refused.extend(told);
    }
}

/// Takes programs out of a package.
fn without(package: &mut Package, programs: &BTreeMap<String, String>) {
    let stays = |path: &str| {
        let named = |name: &String| {
            path.split("::").any(|part| {
                let (head, rest) = part.split_at_checked(name.len()).unwrap_or((part, ""));
                head.eq_ignore_ascii_case(name) && !rest.starts_with(|c: char| c.is_ascii_digit())
            })
        };
        !programs.keys().any(named)
    };
    package.functions.retain(|function| stays(&function.path));
    package.types.retain(|ty| stays(&ty.path));
}

/// Returns the toolchains for a seed: gcc and clang alternately, every third time the Cortex-A9 too.
fn by_turns(seed: u64) -> Vec<Toolchain> {
    let host = toolchain::host();
    let (compiler, level) = if seed % 2 == 1 { ("gcc", 3) } else { ("clang", 2) };
    let there = |it: &&Toolchain| (it.compiler, it.level) == (compiler, level);
    let one = host.iter().find(there).or(host.iter().find(|it| it.level == 3));
    let target =
        toolchain::target().into_iter().filter(|it| it.level == 2 && seed.is_multiple_of(3));
    one.cloned().into_iter().chain(target).collect()
}

/// Returns the fastest compiler for many programs: clang, if installed.
fn quickest() -> Toolchain {
    let clang = toolchain::host().into_iter().find(|it| it.compiler == "clang");
    Toolchain { level: 0, ..clang.unwrap_or(toolchain::GCC) }
}

/// Coverage.
#[derive(Default)]
struct Reached {
    programs: usize,
    calls: usize,
    faults: usize,
    /// Programs that the DSL, or rustc, does not take.
    refused: usize,
    differences: Vec<Difference>,
}

impl Reached {
    fn add(&mut self, other: Reached) {
        self.programs += other.programs;
        self.calls += other.calls;
        self.faults += other.faults;
        self.refused += other.refused;
        self.differences.extend(other.differences);
    }
}

/// Returns the differences in the programs of a seed.
fn attack(workspace: &Workspace, seed: u64, batch: &mut Batch) -> Reached {
    let Built { native, places, compiled, kept } = built(workspace, batch);
    let cases = legs::cases(&batch.left(), &native, &places, &compiled);
    let refused: Vec<_> = batch.refused.values().chain(batch.mistaken.values()).collect();
    assert!(!cases.is_empty() || batch.is_small(), "nothing was compiled: {refused:?}");
    if cases.is_empty() {
        // A small batch may contain refused bodies only.
        return Reached { refused: refused.len(), ..Reached::default() };
    }
    assert_eq!(cases.len(), batch.left().len(), "each program was compiled");
    let mut all = interpreted("interpreter", &compiled.module, &cases);
    all.extend(batch.internal());
    all.extend(interpreted("explicit", &compiled.explicit, &cases));
    all.extend(interpreted("what was proved", &kept.explicit, &cases));
    // What is dear, small programs do alternately, and more rarely where there are many of them.
    let by_turn = |few: u64, many: u64| match (batch.is_small(), batch.is_of_many) {
        (false, _) => true,
        (true, false) => seed.is_multiple_of(few),
        (true, true) => seed.is_multiple_of(many),
    };
    // Of large ones, what C leaves undefined is looked for in what is emitted or in what was proved, alternately.
    let [emitted, proved] = match batch.is_small() || turn::is_full() {
        true => [true; 2],
        false => [seed.is_multiple_of(2), !seed.is_multiple_of(2)],
    };
    let gcc = Toolchain { level: 0, ..toolchain::GCC };
    if emitted && by_turn(3, 11) {
        all.extend(in_c(&compiled, &cases, &gcc, &SANITIZED));
    }
    if proved && by_turn(4, 13) {
        all.extend(in_c(&kept, &cases, &Toolchain { level: 1, ..gcc }, &SANITIZED));
    } else {
        all.extend(in_c(&kept, &cases, &quickest(), &["-w"]));
    }
    if by_turn(1, 7) {
        for toolchain in by_turns(seed) {
            all.extend(in_c(&compiled, &cases, &toolchain, &WARNED));
        }
    }
    let (calls, faults) = legs::counted(&cases);
    println!(
        "seed {seed}: {} programs, {calls} calls, {faults} of them faults; {} refused, {} not Rust; {} differ",
        cases.len(),
        batch.refused.len(),
        batch.mistaken.len(),
        all.iter().map(|it| &it.program).collect::<BTreeSet<_>>().len()
    );
    report(batch, &all, seed, workspace);
    let refused = batch.refused.len() + batch.mistaken.len();
    let programs = batch.left().iter().map(|it| it.count()).sum();
    Reached { programs, calls, faults, refused, differences: all }
}

/// Returns the names of programs with differences in the interpreter, or with refusals that no program should have.
fn differing(workspace: &Workspace, batch: &mut Batch) -> BTreeSet<String> {
    let Built { native, places, compiled, kept } = built(workspace, batch);
    let cases = legs::cases(&batch.left(), &native, &places, &compiled);
    let modules = [&compiled.module, &compiled.explicit, &kept.explicit];
    let all = modules.into_iter().flat_map(|module| interpreted("interpreter", module, &cases));
    let mut names: BTreeSet<String> = all.map(|it| it.program).collect();
    names.extend(batch.internal().map(|it| it.program));
    names
}

/// The programs that are worth making smaller: what only a compiler of C warns of is small enough as it is reported.
fn wrong<'b>(batch: &'b Batch, all: &[Difference]) -> Vec<&'b Program> {
    let told = all.iter().filter(|it| !it.text.contains(" warned of in "));
    let seen: BTreeSet<_> = told.map(|it| &it.program).collect();
    let wrong = |it: &&Program| {
        seen.contains(&it.name) || batch.refused.get(&it.name).is_some_and(|why| is_internal(why))
    };
    batch.programs.iter().filter(wrong).take(10).collect()
}

/// Shows what was refused, and keeps what differs, where `BESSEMER_RANDOM_SHOW` says.
fn report(batch: &Batch, all: &[Difference], seed: u64, workspace: &Workspace) {
    let Some(folder) = std::env::var_os("BESSEMER_RANDOM_SHOW") else { return };
    let folder = std::path::PathBuf::from(folder);
    let mut text = String::new();
    for (name, why) in &batch.mistaken {
        let _ = writeln!(text, "MISTAKE {name}: {why}");
    }
    for (name, why) in &batch.refused {
        let _ = writeln!(text, "REFUSED {name}: {why}");
        if is_internal(why)
            && let Some(program) = batch.programs.iter().find(|it| it.name == *name)
        {
            let _ = writeln!(text, "{}", program.text);
        }
    }
    let mut seen = BTreeSet::new();
    for difference in all {
        let _ = writeln!(text, "DIFFERENT {}", difference.text);
        if seen.insert(&difference.program)
            && let Some(program) = batch.programs.iter().find(|it| it.name == difference.program)
        {
            let _ = writeln!(text, "{}", program.text);
        }
    }
    std::fs::write(folder.join(format!("seed{seed}-{}.txt", batch.programs.len())), &text)
        .expect("a folder to show in");
    let wrong = wrong(batch, all);
    if !wrong.is_empty() {
        text += "SHRUNK\n";
        for program in shrink::shrunk(workspace, &wrong) {
            let _ = writeln!(text, "{}", program.text);
        }
        std::fs::write(folder.join(format!("seed{seed}-{}.txt", batch.programs.len())), text)
            .expect("a folder to show in");
    }
}

/// Returns the number of seeds, and the first.
fn seeds() -> (u64, u64) {
    let number = |name: &str, default: u64| {
        std::env::var(name).ok().and_then(|it| it.parse().ok()).unwrap_or(default)
    };
    (number("BESSEMER_RANDOM", 1), number("BESSEMER_RANDOM_FROM", turn::turn() as u64))
}

#[test]
fn random_programs_agree() {
    let (seeds, from) = seeds();
    let chosen = std::env::var_os("BESSEMER_RANDOM").is_some();
    let programs = if chosen || turn::is_full() { PROGRAMS } else { FEWER };
    let workspace = Workspace::with_source("").expect("a workspace");
    let mut all = Vec::new();
    for seed in from..from + seeds {
        let mut batch = Batch::new(seed, programs);
        if seed == from {
            // Three turns that follow one another have all of them.
            let found = found::programs();
            let third = found.len().div_ceil(3);
            batch.programs.extend(turn::some_of(found, third));
            for seed in BTreeSet::from([0, from]) {
                batch.programs.extend(Batch::aimed(seed, AIMED, INSTANCES).programs);
            }
        }
        let mut found = attack(&workspace, seed, &mut batch).differences;
        let mut small = match seed % 2 {
            0 => Batch::beside(seed, BESIDE),
            _ => Batch::iterating(seed, ITERATING),
        };
        found.extend(attack(&workspace, seed, &mut small).differences);
        let refused = batch.refused.iter().chain(&batch.mistaken);
        let kept = refused.filter(|it| it.0.starts_with("found_"));
        all.extend(kept.map(|(name, why)| format!("{name} says nothing any more: {why}")));
        all.extend(found.into_iter().map(|it| format!("seed {seed}: {}", it.text)));
    }
    assert!(all.is_empty(), "{}", all.join("\n\n"));
}

#[test]
#[ignore = "it runs programs of a folder that BESSEMER_FOUND names, written as those of tests/found"]
fn those_of_a_folder_agree() {
    let folder = std::env::var_os("BESSEMER_FOUND").expect("BESSEMER_FOUND names a folder");
    let mut batch = Batch::of(found::programs_in(folder.as_ref()));
    let workspace = Workspace::with_source("").expect("a workspace");
    let reached = attack(&workspace, 0, &mut batch);
    for (name, why) in &batch.mistaken {
        println!("not Rust: {name}: {why}\n");
    }
    for (name, why) in &batch.refused {
        println!("refused: {name}: {why}\n");
    }
    let told: Vec<_> = reached.differences.into_iter().map(|it| it.text).collect();
    assert!(told.is_empty(), "{}", told.join("\n\n"));
}
