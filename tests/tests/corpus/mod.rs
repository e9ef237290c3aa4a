//! Every program of the corpus: native Rust, the interpreter and the C give the same bits and the same
//! faults.
//!
//! Each call is on its own: words for the state and the arguments in, words for the result, the state and
//! the changed arguments out. Half of the calls have words drawn from the edges of each type; the other
//! half are a run, as a component lives: small numbers, and the state that the call before left.

mod blocks;
mod book;
mod cookbook;
mod coverage;
mod estimators;
mod eva;
mod guards;
mod kinds;
mod misra;
mod mistakes;
mod names;

use std::sync::OnceLock;
use std::thread;

use bessemer_backend::c::names::FAULTS;
use bessemer_codegen::compile::{Compiled, Layout, Options};
use bessemer_interpret::{Interpreter, Stop};
use bessemer_ir::{Fault, Function, FunctionId, Mode, Module, Owner, Type};
use bessemer_tests::arguments::{Size, words};
use bessemer_tests::outcome::{self, Outcome, fault};
use bessemer_tests::panics::caught;
use bessemer_tests::process::{Error, Process, at_once, lay_out};
use bessemer_tests::random::Random;
use bessemer_tests::store::once;
use bessemer_tests::toolchain::{self, Toolchain, run};
use bessemer_tests::{alive, corpus, corpus_with, harness, texts, turn};
use callables::Entry;

/// Calls of each entry point with words from the edges.
const CALLS: usize = 200;
/// Calls of each entry point in its run.
const RUN: usize = 100;

/// Tells of what C leaves undefined; warnings are another run's.
const SANITIZED: [&str; 3] = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-w"];

#[derive(Clone, Hash)]
pub(super) struct Case {
    name: String,
    /// Its module, which has a file of C of its own.
    program: &'static str,
    id: FunctionId,
    /// True if it is an entry point of a component.
    stateful: bool,
    /// The words of each call: of the state, then of each argument.
    calls: Vec<Vec<Vec<u64>>>,
    /// The types of the values of an outcome, and those of their words.
    types: Vec<Type>,
    leaves: Vec<Type>,
    native: Vec<Outcome>,
}

/// Returns the results of Rust, computed once for every leg.
fn cases() -> &'static [Case] {
    static CASES: OnceLock<Vec<Case>> = OnceLock::new();
    CASES.get_or_init(|| lived(corpus(), natives()))
}

/// Returns the results of Rust for calls of each entry.
pub(super) fn lived(
    compiled: &Compiled,
    natives: impl IntoIterator<Item = &'static Entry>,
) -> Vec<Case> {
    let module = &compiled.module;
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let case = |native: &'static Entry| {
        let name = name(native);
        let id = callable(compiled, native).unwrap_or_else(|| panic!("`{name}` was not compiled"));
        let function = &module.functions[id.index()];
        let stateful = !native.component.is_empty();
        let mut types = vec![function.result.clone()];
        for (index, local) in function.parameters().iter().enumerate() {
            if index == 0 && stateful || local.mode == Mode::RefMut {
                types.push(local.ty.clone());
            }
        }
        let leaves = types.iter().flat_map(|ty| module.leaves(ty)).collect();
        let (calls, outcomes) = lives(native, module, function, &mut random);
        let program = native.module;
        Case { name, program, id, stateful, calls, types, leaves, native: outcomes }
    };
    natives.into_iter().map(case).collect()
}

/// The functions and entry points.
fn natives() -> &'static [Entry] {
    corpus::programs::ENTRIES
}

fn name(native: &Entry) -> String {
    format!("{}::{}{}::{}", native.module, native.component, native.data, native.name)
}

/// The function or entry point in the module.
fn callable(compiled: &Compiled, native: &Entry) -> Option<FunctionId> {
    let module = &compiled.module;
    let index = module.functions.iter().position(|function| {
        let owner = match function.owner {
            Some(Owner::Struct(id)) => module.structs[id.index()].name.as_str(),
            Some(Owner::Enum(id)) => module.enums[id.index()].name.as_str(),
            None => "",
        };
        let wanted = if native.data.is_empty() { native.component } else { native.data };
        (owner, function.name.as_str(), function.module.as_str())
            == (wanted, native.name, native.module)
    })?;
    Some(FunctionId(index as u32))
}

/// The words of each call of an entry point, and what Rust makes of them.
fn lives(
    native: &'static Entry,
    module: &Module,
    function: &Function,
    random: &mut Random,
) -> (Vec<Vec<Vec<u64>>>, Vec<Outcome>) {
    let parameters = function.parameters();
    let call = |random: &mut Random, size: Size| -> Vec<Vec<u64>> {
        let drawn = parameters.iter().map(|local| words(random, module, &local.ty, size));
        values(native, drawn.collect())
    };
    let mut calls: Vec<Vec<Vec<u64>>> = (0..CALLS).map(|_| call(random, Size::Edges)).collect();
    let mut outcomes: Vec<Outcome> = calls.iter().map(|call| run_native(native, call)).collect();
    let mut initial = Vec::new();
    (native.initial)(&mut |word| initial.push(word));
    // Of plain data the words of a method's own are those of an argument, given back if it may change it.
    let of_data = parameters.first().filter(|it| !native.data.is_empty() && it.name == "self");
    let starts = !native.component.is_empty() || of_data.is_some() && !initial.is_empty();
    let given_back =
        !native.component.is_empty() || of_data.is_some_and(|it| it.mode == Mode::RefMut);
    let results = module.width(&function.result);
    let mut state = initial.clone();
    for _ in 0..RUN {
        let mut call = call(random, Size::Tame);
        if starts {
            call[0].clone_from(&state);
        }
        let outcome = run_native(native, &call);
        state = match &outcome {
            Ok(words) if starts && given_back => words[results..results + initial.len()].to_vec(),
            _ => initial.clone(),
        };
        calls.push(call);
        outcomes.push(outcome);
    }
    (calls, outcomes)
}

/// Words of values: not each word is a character, or a number that is not zero.
fn values(entry: &Entry, call: Vec<Vec<u64>>) -> Vec<Vec<u64>> {
    let mut words = call.iter().flatten().copied();
    let mut made = Vec::new();
    let mut next = || words.next().expect("a word for each scalar");
    (entry.made)(&mut next, &mut |word| made.push(word));
    let mut made = made.into_iter();
    call.iter().map(|words| made.by_ref().take(words.len()).collect()).collect()
}

fn run_native(entry: &Entry, call: &[Vec<u64>]) -> Outcome {
    let mut words = call.iter().flatten().copied();
    let mut out = Vec::new();
    caught(|| {
        (entry.run)(&mut || words.next().expect("a word for each scalar"), &mut |word| {
            out.push(word);
        });
    })
    .map(|()| out)
    .map_err(|message| fault(&message))
}

fn agree(leg: &str, module: &Module, case: &Case, index: usize, got: &Outcome) {
    let got = outcome::meant(module, &case.types, got);
    let same = outcome::same(&case.native[index], &got, &case.leaves);
    assert!(
        same,
        "{} in {leg}\nof    {:x?}\nRust  {:x?}\n{leg} {got:x?}",
        case.name, case.calls[index], case.native[index]
    );
}

#[test]
fn the_interpreter_agrees() {
    let compiled = corpus();
    for module in [&compiled.module, &compiled.explicit] {
        let mut interpreter = Interpreter::new(module);
        for case in cases() {
            interpreted(compiled, module, &mut interpreter, case);
        }
    }
}

/// Each call of an entry point in an interpreter of `module`.
pub(super) fn interpreted(
    compiled: &Compiled,
    module: &Module,
    interpreter: &mut Interpreter,
    case: &Case,
) {
    let parameters = module.functions[case.id.index()].parameters();
    let stateful = case.stateful;
    for (index, call) in case.calls.iter().enumerate() {
        let mut arguments = call.clone();
        // What the compiler added, a work struct, is nothing that Rust knows.
        for added in &parameters[call.len()..] {
            arguments.push(vec![0; module.width(&added.ty)]);
        }
        let got = match interpreter.call(case.id, &mut arguments) {
            Ok(mut words) => {
                for (at, argument) in arguments[..call.len()].iter().enumerate() {
                    if at == 0 && stateful || parameters[at].mode == Mode::RefMut {
                        words.extend(argument);
                    }
                }
                Ok(words)
            }
            Err(Stop::Fault { fault, .. }) => Err(fault),
            Err(stop) => panic!("{}: {stop}", case.name),
        };
        agree("interpreter", &compiled.module, case, index, &got);
    }
}

/// Every call in one process, as many at once as its pipes hold.
pub(super) fn run_c(compiled: &Compiled, cases: &[Case], toolchain: &Toolchain, flags: &[&str]) {
    run_c_with(compiled, cases, toolchain, flags, &Options::default());
}

pub(super) fn run_c_with(
    compiled: &Compiled,
    cases: &[Case],
    toolchain: &Toolchain,
    flags: &[&str],
    options: &Options,
) {
    let leg = format!("{} {} {:?}", toolchain.name(), flags.join(" "), options.layout);
    let params = |id: FunctionId| compiled.module.functions[id.index()].params;
    let ids: Vec<_> = cases.iter().map(|case| (case.id, params(case.id))).collect();
    let main = harness::programs_with(&compiled.explicit, &ids, options);
    let content = (texts(&compiled.files), &main, cases, toolchain);
    once(&leg, &content, || ask_c(compiled, cases, toolchain, flags, &main, &leg));
}

/// The calls of the cases, of their C with `main` around it.
fn ask_c(
    compiled: &Compiled,
    cases: &[Case],
    toolchain: &Toolchain,
    flags: &[&str],
    main: &str,
    leg: &str,
) {
    // In a full run the target's files, and those that are not optimised, each by itself, as a firmware's build has them.
    let alone = turn::is_full()
        && (toolchain.emulator.is_some()
            || (toolchain.compiler == "gcc" && toolchain.level == 0 && flags.is_empty()));
    let run = if alone { Process::run } else { Process::run_in_units };
    let mut process =
        run(compiled, main, toolchain, flags).unwrap_or_else(|error| panic!("{leg}: {error}"));
    for (at, case) in cases.iter().enumerate() {
        let taken = case.calls.iter().map(|call| 1 + call.iter().flatten().count());
        let together = at_once(taken.max().unwrap_or_default().max(1 + case.leaves.len()));
        for (batch, calls) in case.calls.chunks(together).enumerate() {
            let died = |error| -> ! { panic!("{leg}, {} in {calls:x?}: {error}", case.name) };
            process.ask(at, calls).unwrap_or_else(|error| died(error));
            for index in (batch * together..).take(calls.len()) {
                let got = answer(&mut process, case.leaves.len());
                let got = got.unwrap_or_else(|error| died(error));
                agree(leg, &compiled.module, case, index, &got);
            }
        }
    }
    a_wrong_variant_is_a_fault(&mut process, cases, leg);
}

/// Checks an argument that Rust cannot have: an enum with an invalid variant.
fn a_wrong_variant_is_a_fault(process: &mut Process, cases: &[Case], leg: &str) {
    let follower = |case: &Case| case.name.ends_with("::Follower::step");
    let Some(at) = cases.iter().position(follower) else { return };
    for (wish, expected) in [(2, None), (3, Some(Fault::Variant)), (255, Some(Fault::Variant))] {
        process.ask(at, &[[vec![0.5_f64.to_bits(), wish]]]).expect("it listens");
        let got = answer(process, cases[at].leaves.len()).expect("it answers");
        assert_eq!(got.err(), expected, "{leg}: {wish}");
    }
}

fn answer(process: &mut Process, results: usize) -> Result<Outcome, Error> {
    match process.receive(1)?[0] {
        0 => Ok(Ok(process.receive(results)?)),
        status => Ok(Err(FAULTS[status as usize - 1])),
    }
}

#[test]
fn the_c_agrees() {
    let compiled = corpus();
    let cases = cases();
    thread::scope(|scope| {
        for (number, (toolchain, flags)) in legs().into_iter().enumerate() {
            // Legs that follow one another take other programs, so that none of these is left out by all.
            scope.spawn(move || run_c(compiled, &every(3, number, cases), &toolchain, flags));
        }
    });
}

/// In the full run: a test of its own, so that it can be run by itself.
#[test]
fn the_c_agrees_on_other_machines() {
    let others = turn::others();
    if others.is_empty() {
        return;
    }
    let (compiled, cases) = (corpus(), cases());
    thread::scope(|scope| {
        for toolchain in &others {
            scope.spawn(move || run_c(compiled, cases, toolchain, &[]));
        }
    });
    let names: Vec<String> = others.iter().map(Toolchain::name).collect();
    let calls: usize = cases.iter().map(|case| case.calls.len()).sum();
    println!("{} entries, {calls} calls, the same bits: {}", cases.len(), names.join(", "));
}

/// Returns a rotating subset of the cases: of `count` consecutive programs one with all its cases; all in a full run.
/// Whole programs, because a compiler compiles all files of a program for any of its cases.
fn every(count: usize, number: usize, cases: &[Case]) -> Vec<Case> {
    let programs: Vec<&[Case]> = cases.chunk_by(|one, next| one.program == next.program).collect();
    let of_some = |some: &[&[Case]]| turn::some_of_shifted(some.to_vec(), 1, number).concat();
    programs.chunks(count).flat_map(of_some).collect()
}

/// Each file of C includes what it needs: compiled with others, one could do so for another.
#[test]
fn each_file_compiles_alone() {
    let toolchains = toolchain::host();
    let Some(toolchain) = toolchains.first() else { return };
    once("each file by itself", &texts(&corpus().files), || {
        let folder = lay_out(corpus()).expect("the C");
        // Every other one alternately.
        let (first, second): (Vec<_>, Vec<_>) =
            folder.sources().iter().enumerate().partition(|(at, _)| at % 2 == 0);
        let sources: Vec<_> = turn::one_of(vec![first, second]).into_iter().flatten().collect();
        let sources: Vec<_> = sources.into_iter().map(|(_, source)| source).collect();
        thread::scope(|scope| {
            for half in sources.chunks(sources.len().div_ceil(2)) {
                scope.spawn(move || {
                    let mut command = toolchain.command();
                    run(command.arg("-fsyntax-only").args(half))
                        .unwrap_or_else(|said| panic!("{said}"));
                });
            }
        });
    });
}

/// Returns one compiler with checks of undefined behaviour, the other with optimisation, and the Cortex-A9. A full run
/// has the least and the most optimised of all; the flight tests use every level.
fn legs() -> Vec<(Toolchain, &'static [&'static str])> {
    let levels = |it: &Toolchain| if it.emulator.is_some() { it.level == 2 } else { it.level != 2 };
    let mut all: Vec<(_, &[&str])> =
        toolchain::all().into_iter().filter(levels).map(|it| (it, &[][..])).collect();
    let plain = toolchain::host().into_iter().filter(|it| it.level == 0);
    all.extend(plain.map(|it| (it, &SANITIZED[..])));
    if !turn::is_full() {
        let sanitized = turn::one_of(vec!["gcc", "clang"]);
        all.retain(|(it, flags)| {
            let is_sanitized = !flags.is_empty();
            it.emulator.is_some()
                || (is_sanitized || it.level > 0)
                    && sanitized.contains(&it.compiler) == is_sanitized
        });
    }
    all
}

/// Checks programs with matrices in the layouts by rows and as arrays of rows, a sixth of them in a run: the bits are
/// equal.
#[test]
fn the_c_agrees_in_every_layout() {
    let mut cases = cases().to_vec();
    let chapters = ["matrices", "algorithms", "kinds", "data"];
    let has_matrices =
        |name: &str| chapters.iter().any(|chapter| name.contains(&format!("programs::{chapter}")));
    cases.retain(|case| has_matrices(&case.name));
    let mut cases = every(6, 0, &cases);
    let natives = |case: &Case| {
        let is = |native: &&Entry| case.name == name(native);
        corpus::programs::ENTRIES.iter().find(is).expect("a program of the corpus")
    };
    for layout in turn::one_of(vec![Layout::Rows, Layout::Array]) {
        let options = Options { layout, ..Options::default() };
        let compiled = corpus_with(&options);
        for case in &mut cases {
            case.id = callable(&compiled, natives(case)).expect("it was compiled before");
        }
        thread::scope(|scope| {
            // What compilers make of C is the other test's; here a sanitized build of this machine, and the target's.
            let chosen = |it: &Toolchain| match it.emulator.is_some() {
                true => it.level == 2 && turn::is_full(),
                false => it.level == 0 && it.compiler == "gcc",
            };
            for toolchain in toolchain::all().into_iter().filter(chosen) {
                let (compiled, cases, options) = (&compiled, &cases, &options);
                let sanitized = toolchain.emulator.is_none();
                let flags = if sanitized { &SANITIZED[..] } else { &[][..] };
                scope.spawn(move || run_c_with(compiled, cases, &toolchain, flags, options));
            }
        });
    }
}

fn kept_options() -> Options {
    Options { keep_checks: true, ..Options::default() }
}

/// The corpus with the checks that were proved.
fn kept() -> &'static Compiled {
    static KEPT: OnceLock<Compiled> = OnceLock::new();
    KEPT.get_or_init(|| corpus_with(&kept_options()))
}

/// Checks that were proved are in the module and in the C all the same, and none of them fails.
#[test]
fn what_was_proved_holds() {
    let kept = kept();
    let cases = cases();
    let mut interpreter = Interpreter::new(&kept.explicit);
    for case in cases {
        interpreted(kept, &kept.explicit, &mut interpreter, case);
    }
    // What a check asks is the same at every level, and least work at this one.
    let chosen = toolchain::host().into_iter().find(|it| it.level == 0);
    if let Some(toolchain) = chosen {
        run_c_with(kept, &every(3, 0, cases), &toolchain, &["-w"], &kept_options());
    }
}

#[test]
fn work_is_little_more_than_what_is_alive_at_once() {
    let mut wide: Vec<String> = Vec::new();
    for (name, bytes, alive) in alive::lent(corpus()) {
        if 10 * bytes > 11 * alive {
            wide.push(format!("{name} is lent {bytes} bytes, and needs {alive}"));
        }
    }
    assert!(wide.is_empty(), "{}", wide.join("\n"));
}
