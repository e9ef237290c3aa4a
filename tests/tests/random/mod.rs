//! Random programs in the DSL's Rust, through everything: what rustc makes of them against what the
//! interpreter and the C do, the bits of each result and the kind of each fault.
//!
//! `BESSEMER_RANDOM=seeds` runs that many batches, from the seed `BESSEMER_RANDOM_FROM`, instead of one.

mod calls;
mod chains;
mod native;
mod patterns;
mod shrink;
mod statements;
mod types;
mod values;
mod writer;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use bessemer_codegen::c::names::FAULTS;
use bessemer_codegen::compile::{self, Compiled, Options};
use bessemer_codegen::diagnostic;
use bessemer_codegen::generate::{self as generation, Error};
use bessemer_codegen::interpret::{Interpreter, Stop};
use bessemer_codegen::source::Sources;
use bessemer_ir::{Function, FunctionId, Mode, Module, Type};
use bessemer_tests::arguments::{Size, words};
use bessemer_tests::harness;
use bessemer_tests::outcome::{Outcome, meant, same};
use bessemer_tests::process::Process;
use bessemer_tests::random::Random;
use bessemer_tests::toolchain::Toolchain;
use bessemer_tests::workspace::Workspace;

use writer::Program;

/// Programs in a batch.
const PROGRAMS: usize = 80;
/// Calls of each.
const CALLS: usize = 48;

const SANITIZED: [&str; 3] = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-w"];

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
}

impl Batch {
    fn new(seed: u64) -> Batch {
        let mut programs = Vec::new();
        for index in 0..PROGRAMS {
            let mut random = Random(seed << 32 | index as u64);
            programs.push(writer::program(&mut random, &format!("p{index}")));
        }
        Batch::of(programs)
    }

    fn of(programs: Vec<Program>) -> Batch {
        Batch {
            programs,
            refused: BTreeMap::new(),
            mistaken: BTreeMap::new(),
            lines: Vec::new(),
            text: String::new(),
        }
    }

    /// The programs that nobody has refused.
    fn left(&self) -> Vec<&Program> {
        let out = |name: &str| self.refused.contains_key(name) || self.mistaken.contains_key(name);
        self.programs.iter().filter(|it| !out(&it.name)).collect()
    }

    /// What the validation of the IR refused, which is a mistake of the tool.
    fn internal(&self) -> impl Iterator<Item = Difference> {
        let internal = self.refused.iter().filter(|it| is_internal(it.1));
        internal
            .map(|(name, why)| Difference { program: name.clone(), text: format!("{name}: {why}") })
    }

    fn write(&mut self, workspace: &Workspace) {
        let mut text = String::from(HEAD);
        for ty in types::INTS {
            text += &TICK.replace("TYPE", ty).replace("WORD", "x as u64");
        }
        text += &TICK.replace("TYPE", "bool").replace("WORD", "x as u64");
        text += &TICK.replace("TYPE", "f64").replace("WORD", "x.to_bits()");
        text += &TICK.replace("TYPE", "f32").replace("WORD", "x.to_bits() as u64");
        let mut lines = Vec::new();
        for program in self.left() {
            lines.push((text.lines().count() + 1, program.name.clone()));
            text += &program.text;
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

    /// The programs that a compiler complains of, each with its first complaint.
    fn told(&self, said: &str) -> BTreeMap<String, String> {
        let mut told = BTreeMap::new();
        let mut title = "";
        for line in said.lines() {
            if line.starts_with("error") {
                title = line;
            }
            let place = line.split_once("src/lib.rs:");
            let Some((number, column)) = place.and_then(|(_, at)| {
                let mut numbers = at.split(':').map(|it| it.parse::<usize>().unwrap_or(1));
                Some((numbers.next()?, numbers.next()?))
            }) else {
                continue;
            };
            if let Some(name) = self.at(number) {
                let at = self.text.lines().nth(number - 1).unwrap_or_default();
                let at = at.get(column - 1..).unwrap_or(at);
                told.entry(name).or_insert_with(|| format!("{title}\n    {at}"));
            }
        }
        told
    }
}

const HEAD: &str = "//! Random programs.\n#![allow(warnings, arithmetic_overflow, unconditional_panic, overflowing_literals)]\n\
                    #![allow(clippy::all)]\nuse bessemer::prelude::*;\n";

const TICK: &str = "
/// Tells `t` of a value.
#[function]
pub fn tick_TYPE(x: TYPE, t: &mut u64) -> TYPE {
    *t = t.wrapping_mul(31).wrapping_add(WORD);
    x
}
";

/// The native program and the C of the batch, without what was refused.
fn compiled(workspace: &Workspace, batch: &mut Batch) -> (String, Vec<String>, Compiled) {
    let native = loop {
        batch.write(workspace);
        let result = native::build(workspace, &batch.left());
        match result {
            Ok(native) => break native,
            Err(said) => {
                let told = batch.told(&said);
                assert!(!told.is_empty(), "{said}");
                // What has no number of rustc's is said by the DSL's attributes.
                let (mistaken, refused) = told.into_iter().partition(|it| it.1.contains("error[E"));
                batch.mistaken.extend::<BTreeMap<_, _>>(mistaken);
                batch.refused.extend::<BTreeMap<_, _>>(refused);
            }
        }
    };
    // Their places in the native program, which has more than what is left in the end.
    let places = batch.left().iter().map(|it| it.name.clone()).collect();
    let sources = Sources::new(workspace.path(""));
    loop {
        batch.write(workspace);
        let said = match generation::tree(&workspace.path(""), "models") {
            Ok(package) => match compile::compile(&package, &sources, &Options::default()) {
                Ok(compiled) => return (native, places, compiled),
                Err(errors) => diagnostic::render(&errors, &sources, false),
            },
            Err(Error::Models(said) | Error::Refused(said)) => said,
            Err(error) => panic!("{error}"),
        };
        let told = batch.told(&said);
        assert!(!told.is_empty(), "{said}");
        batch.refused.extend(told);
    }
}

/// A program with its calls, and what Rust makes of them.
struct Case<'b> {
    program: &'b Program,
    id: FunctionId,
    calls: Vec<Vec<Vec<u64>>>,
    types: Vec<Type>,
    leaves: Vec<Type>,
    native: Vec<Outcome>,
}

fn cases<'b>(
    batch: &'b Batch,
    native: &str,
    places: &[String],
    compiled: &Compiled,
) -> Vec<Case<'b>> {
    let module = &compiled.module;
    let mut random = Random(7);
    let mut cases = Vec::new();
    for program in batch.left() {
        let found =
            module.functions.iter().position(|it| it.name == program.name && it.owner.is_none());
        // A smaller variant may have lost its attribute.
        let Some(found) = found else { continue };
        let id = FunctionId(found as u32);
        let function: &Function = &module.functions[id.index()];
        let mut types = vec![function.result.clone()];
        let changed = function.parameters().iter().filter(|local| local.mode == Mode::RefMut);
        types.extend(changed.map(|local| local.ty.clone()));
        let leaves: Vec<Type> = types.iter().flat_map(|ty| module.leaves(ty)).collect();
        let calls: Vec<Vec<Vec<u64>>> = (0..CALLS)
            .map(|at| {
                let size = if at % 2 == 0 { Size::Edges } else { Size::Tame };
                let parameters = function.parameters().iter();
                parameters.map(|local| words(&mut random, module, &local.ty, size)).collect()
            })
            .collect();
        let place = places.iter().position(|it| *it == program.name).expect("it was built");
        let flat: Vec<_> = calls.iter().map(|call| (place, call.concat())).collect();
        let native = native::run(native, &flat);
        cases.push(Case { program, id, calls, types, leaves, native });
    }
    cases
}

/// Something that is not the same on two legs.
struct Difference {
    program: String,
    text: String,
}

fn compare(
    leg: &str,
    module: &Module,
    case: &Case,
    at: usize,
    got: &Outcome,
) -> Option<Difference> {
    let got = meant(module, &case.types, got);
    if same(&case.native[at], &got, &case.leaves) {
        return None;
    }
    let text = format!(
        "{} in {leg}, call {at} of {:x?}\nRust  {:x?}\n{leg} {got:x?}",
        case.program.name, case.calls[at], case.native[at]
    );
    Some(Difference { program: case.program.name.clone(), text })
}

fn interpreted(leg: &str, module: &Module, cases: &[Case]) -> Vec<Difference> {
    let mut all = Vec::new();
    for case in cases {
        let parameters = module.functions[case.id.index()].parameters();
        for (at, call) in case.calls.iter().enumerate() {
            let mut arguments = call.clone();
            for added in &parameters[call.len()..] {
                arguments.push(vec![0; module.leaves(&added.ty).len()]);
            }
            let got = match Interpreter::new(module).call(case.id, &mut arguments) {
                Ok(mut words) => {
                    for (index, argument) in arguments[..call.len()].iter().enumerate() {
                        if parameters[index].mode == Mode::RefMut {
                            words.extend(argument);
                        }
                    }
                    Ok(words)
                }
                Err(Stop::Fault { fault, .. }) => Err(fault),
                Err(stop) => {
                    let text = format!("{} in {leg}: {stop}", case.program.name);
                    all.push(Difference { program: case.program.name.clone(), text });
                    break;
                }
            };
            if let Some(difference) = compare(leg, module, case, at, &got) {
                all.push(difference);
                break;
            }
        }
    }
    all
}

fn in_c(
    compiled: &Compiled,
    cases: &[Case],
    toolchain: &Toolchain,
    flags: &[&str],
) -> Vec<Difference> {
    let leg = format!("{} {}", toolchain.name(), flags.join(" "));
    let module = &compiled.module;
    let ids: Vec<_> =
        cases.iter().map(|case| (case.id, module.functions[case.id.index()].params)).collect();
    let main = harness::programs(&compiled.explicit, &ids);
    let mut process = match Process::run(compiled, &main, toolchain, flags) {
        Ok(process) => process,
        Err(error) => {
            let text = format!("{leg}: {error}");
            return vec![Difference { program: "all".into(), text }];
        }
    };
    let mut all = Vec::new();
    for (index, case) in cases.iter().enumerate() {
        for (at, call) in case.calls.iter().enumerate() {
            let mut words = vec![index as u64];
            words.extend(call.iter().flatten());
            let mut ask = || {
                process.send(&words)?;
                Ok(match process.receive(1)?[0] {
                    0 => Ok(process.receive(case.leaves.len())?),
                    status => Err(FAULTS[status as usize - 1]),
                })
            };
            let difference = match ask() {
                Ok(got) => compare(&leg, module, case, at, &got),
                Err::<_, bessemer_tests::process::Error>(error) => {
                    let text = format!("{} in {leg}, call {at}: {error}", case.program.name);
                    all.push(Difference { program: case.program.name.clone(), text });
                    if process.restart(toolchain).is_err() {
                        return all;
                    }
                    None
                }
            };
            if let Some(difference) = difference {
                all.push(difference);
                break;
            }
        }
    }
    all
}

/// What was different in the programs of a seed.
fn attack(workspace: &Workspace, seed: u64) -> Vec<Difference> {
    let mut batch = Batch::new(seed);
    let (native, places, compiled) = compiled(workspace, &mut batch);
    let cases = cases(&batch, &native, &places, &compiled);
    assert_eq!(cases.len(), batch.left().len(), "each program was compiled");
    let mut all = interpreted("interpreter", &compiled.module, &cases);
    all.extend(batch.internal());
    all.extend(interpreted("explicit", &compiled.explicit, &cases));
    let gcc = |level| Toolchain { compiler: "gcc", level, emulator: None, more: &[] };
    all.extend(in_c(&compiled, &cases, &gcc(0), &SANITIZED));
    all.extend(in_c(&compiled, &cases, &gcc(3), &["-w"]));
    let calls: usize = cases.iter().map(|case| case.calls.len()).sum();
    let faults: usize =
        cases.iter().map(|case| case.native.iter().filter(|it| it.is_err()).count()).sum();
    println!(
        "seed {seed}: {} programs, {calls} calls, {faults} of them faults; {} refused, {} not Rust; {} differ",
        cases.len(),
        batch.refused.len(),
        batch.mistaken.len(),
        all.iter().map(|it| &it.program).collect::<BTreeSet<_>>().len()
    );
    report(&batch, &all, seed, workspace);
    all
}

/// The names of the programs that the interpreter does not make what Rust makes of them, or that are refused as
/// no program is meant to be.
fn differing(workspace: &Workspace, batch: &mut Batch) -> BTreeSet<String> {
    let (native, places, compiled) = compiled(workspace, batch);
    let cases = cases(batch, &native, &places, &compiled);
    let all = interpreted("interpreter", &compiled.module, &cases).into_iter();
    let mut names: BTreeSet<String> = all.map(|it| it.program).collect();
    names.extend(batch.internal().map(|it| it.program));
    names
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
        // What the validation finds is a mistake of the tool.
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
    std::fs::write(folder.join(format!("seed{seed}.txt")), &text).expect("a folder to show in");
    let wrong = |it: &&Program| {
        seen.contains(&it.name) || batch.refused.get(&it.name).is_some_and(|why| is_internal(why))
    };
    let wrong: Vec<&Program> = batch.programs.iter().filter(wrong).take(10).collect();
    if !wrong.is_empty() {
        text += "SHRUNK\n";
        for program in shrink::shrunk(workspace, &wrong) {
            let _ = writeln!(text, "{}", program.text);
        }
        std::fs::write(folder.join(format!("seed{seed}.txt")), text).expect("a folder to show in");
    }
}

/// Whether the tool contradicted itself, which is no answer to any program.
fn is_internal(why: &str) -> bool {
    why.contains(diagnostic::OUR_FAULT)
}

#[test]
fn random_programs_agree() {
    let number = |name: &str, default: u64| {
        std::env::var(name).ok().and_then(|it| it.parse().ok()).unwrap_or(default)
    };
    let (seeds, from) = (number("BESSEMER_RANDOM", 1), number("BESSEMER_RANDOM_FROM", 1));
    let workspace = Workspace::with_source("").expect("a workspace");
    let mut all = Vec::new();
    for seed in from..from + seeds {
        all.extend(attack(&workspace, seed));
    }
    let texts: Vec<_> = all.into_iter().map(|it| it.text).collect();
    assert!(texts.is_empty(), "{}", texts.join("\n\n"));
}
