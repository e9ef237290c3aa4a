//! Every program of the corpus: native Rust, the interpreter and the C give the same bits and the same
//! faults.
//!
//! Each call is on its own: words for the state and the arguments in, words for the result, the state and
//! the changed arguments out. Half of the calls have words drawn from the edges of each type; the other
//! half are a run, as a component lives: small numbers, and the state that the call before left.

use std::panic::{AssertUnwindSafe, catch_unwind, set_hook};
use std::thread;

use bessemer_codegen::c::names::FAULTS;
use bessemer_codegen::compile::{Compiled, Layout, Options};
use bessemer_codegen::interpret::{Interpreter, Stop};
use bessemer_ir::{
    Fault, Float, Form, Function, FunctionId, Int, Local, Mode, Module, Owner, Scalar, Type,
};
use bessemer_tests::process::{Error, Process};
use bessemer_tests::toolchain::{self, Toolchain};
use bessemer_tests::{corpus, corpus_with, entry, harness};
use corpus::Entry;

/// Calls of each entry point with words from the edges.
const CALLS: usize = 200;
/// Calls of each entry point in its run.
const RUN: usize = 100;

/// Tells of what C leaves undefined; warnings are another run's.
const SANITIZED: [&str; 3] = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-w"];

/// The words that come out, or the fault.
type Outcome = Result<Vec<u64>, Fault>;

struct Case {
    name: String,
    id: FunctionId,
    /// The words of each call: of the state, then of each argument.
    calls: Vec<Vec<Vec<u64>>>,
    /// The types of the values of an outcome, and those of their words.
    types: Vec<Type>,
    leaves: Vec<Type>,
    native: Vec<Outcome>,
}

/// A generator of words; the same in every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    fn below(&mut self, count: u64) -> u64 {
        self.next() % count
    }

    /// Makes sense of random words: lengths for which there is room, nothing where nothing is.
    fn meant(&mut self, module: &Module, ty: &Type, mut words: Vec<u64>) -> Vec<u64> {
        self.lengths(module, ty, &mut words);
        module.canonical(ty, &mut words);
        words
    }

    fn lengths<'w>(&mut self, module: &Module, ty: &Type, words: &'w mut [u64]) -> &'w mut [u64] {
        match ty {
            Type::Array { element, len } => {
                (0..*len).fold(words, |words, _| self.lengths(module, element, words))
            }
            Type::Struct(id) => {
                let item = &module.structs[id.index()];
                if item.form == Form::Sequence
                    && let Type::Array { len, .. } = item.fields[1].ty
                {
                    words[0] = self.below(u64::from(len) + 1);
                }
                let fields = item.fields.iter();
                fields.fold(words, |words, field| self.lengths(module, &field.ty, words))
            }
            other => &mut words[module.leaves(other).len()..],
        }
    }

    /// A small number, as sensors and set points are.
    fn tame(&mut self, module: &Module, ty: &Type) -> u64 {
        match ty {
            Type::Scalar(Scalar::Float(Float::F64)) => {
                ((self.below(4001) as f64 - 2000.0) / 512.0).to_bits()
            }
            Type::Scalar(Scalar::Float(Float::F32)) => {
                u64::from(((self.below(4001) as f32 - 2000.0) / 512.0).to_bits())
            }
            Type::Scalar(Scalar::Int(_)) => self.below(8),
            _ => self.word(module, ty),
        }
    }

    fn word(&mut self, module: &Module, ty: &Type) -> u64 {
        match ty {
            Type::Enum(id) => self.below(module.enums[id.index()].variants.len() as u64),
            Type::Scalar(Scalar::Bool) => self.below(2),
            Type::Scalar(Scalar::Float(float)) => {
                let value = match self.below(4) {
                    0 => FLOATS[self.below(FLOATS.len() as u64) as usize],
                    1 => f64::from_bits(self.next()),
                    _ => (self.below(41) as f64 - 20.0) / 4.0,
                };
                match float {
                    Float::F64 => value.to_bits(),
                    Float::F32 => u64::from((value as f32).to_bits()),
                }
            }
            Type::Scalar(Scalar::Int(int)) => {
                let (min, max) = (Int::min(*int), Int::max(*int));
                let value = match self.below(8) {
                    0 => [min, min + 1, max, max - 1][self.below(4) as usize],
                    1 => i128::from(self.next()),
                    2 => -i128::from(self.below(8)),
                    _ => i128::from(self.below(8)),
                };
                let span = max - min + 1;
                ((value - min).rem_euclid(span) + min) as u64
            }
            _ => 0,
        }
    }
}

const FLOATS: [f64; 14] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    f64::MAX,
    f64::MIN_POSITIVE,
    5e-324,
    1e-40,
    9007199254740993.0,
    4294967296.5,
    -2147483649.0,
];

fn cases(compiled: &Compiled) -> Vec<Case> {
    let module = &compiled.module;
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    // The panics of models are expected.
    set_hook(Box::new(|info| {
        if thread::current().name() != Some("native") {
            eprintln!("{info}");
        }
    }));
    let cases = corpus::programs::ENTRIES.iter().map(|native| {
        let name = format!("{}::{}::{}", native.module, native.component, native.name);
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
        let (calls, native) = lives(native, module, function, &mut random);
        Case { name, id, calls, types, leaves, native }
    });
    thread::scope(|scope| {
        let native = thread::Builder::new().name("native".into());
        let native = native.spawn_scoped(scope, || cases.collect());
        native.expect("threads start").join().expect("panics of models are caught")
    })
}

/// The function or entry point in the module.
fn callable(compiled: &Compiled, native: &Entry) -> Option<FunctionId> {
    let module = &compiled.module;
    let index = module.functions.iter().position(|function| {
        let owner = match function.owner {
            Some(Owner::Struct(id)) => module.structs[id.index()].name.as_str(),
            Some(_) => return false,
            None => "",
        };
        (owner, function.name.as_str(), function.module.as_str())
            == (native.component, native.name, native.module)
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
    let words = |random: &mut Random, local: &Local, of: fn(&mut Random, &Module, &Type) -> u64| {
        let leaves = module.leaves(&local.ty);
        let words = leaves.iter().map(|ty| of(random, module, ty)).collect();
        random.meant(module, &local.ty, words)
    };
    let mut calls: Vec<Vec<Vec<u64>>> = (0..CALLS)
        .map(|_| parameters.iter().map(|local| words(random, local, Random::word)).collect())
        .collect();
    let mut outcomes: Vec<Outcome> = calls.iter().map(|call| run_native(native, call)).collect();
    let mut initial = Vec::new();
    (native.initial)(&mut |word| initial.push(word));
    let results = module.leaves(&function.result).len();
    let mut state = initial.clone();
    for _ in 0..RUN {
        let mut call: Vec<Vec<u64>> =
            parameters.iter().map(|local| words(random, local, Random::tame)).collect();
        if !native.component.is_empty() {
            call[0].clone_from(&state);
        }
        let outcome = run_native(native, &call);
        state = match &outcome {
            Ok(words) if !native.component.is_empty() => {
                words[results..results + initial.len()].to_vec()
            }
            _ => initial.clone(),
        };
        calls.push(call);
        outcomes.push(outcome);
    }
    (calls, outcomes)
}

fn run_native(entry: &Entry, call: &[Vec<u64>]) -> Outcome {
    let mut words = call.iter().flatten().copied();
    let mut out = Vec::new();
    catch_unwind(AssertUnwindSafe(|| {
        (entry.run)(&mut || words.next().expect("a word for each scalar"), &mut |word| {
            out.push(word);
        });
    }))
    .map(|()| out)
    .map_err(|panic| {
        let text = (panic.downcast_ref::<String>().map(String::as_str))
            .or(panic.downcast_ref::<&str>().copied())
            .unwrap_or_default();
        fault(text)
    })
}

/// The fault that a panic of rustc's, core's or nalgebra's stands for.
fn fault(text: &str) -> Fault {
    match text {
        _ if text.contains("divide by zero") => Fault::DivisionByZero,
        _ if text.contains("divisor of zero") => Fault::DivisionByZero,
        _ if text.contains("attempt to shift") => Fault::Shift,
        _ if text.contains("overflow") => Fault::Overflow,
        _ if text.contains("out of bounds") || text.contains("out of range") => Fault::Index,
        _ if text.contains("slice index") || text.contains("slice length") => Fault::Index,
        _ if text.contains("copy_from_slice") || text.contains("mid > len") => Fault::Index,
        _ if text.contains("the container is full") => Fault::Capacity,
        _ if text.contains("within its bound") => Fault::Bound,
        _ if text.contains("`None` value") || text.contains("on an `Err` value") => Fault::Absent,
        _ if text.contains("on an `Ok` value") || text.contains("must be there") => Fault::Absent,
        _ if text.contains("low <= high") || text.contains("min > max") => Fault::Clamp,
        // The author's own words.
        _ => Fault::Assertion,
    }
}

fn agree(leg: &str, module: &Module, case: &Case, index: usize, got: &Outcome) {
    // What means nothing may hold anything.
    let got = &got.clone().map(|mut words| {
        case.types.iter().fold(words.as_mut_slice(), |rest, ty| module.canonical(ty, rest));
        words
    });
    let same = match (&case.native[index], got) {
        (Ok(one), Ok(other)) => {
            one.len() == other.len()
                && one.iter().zip(other).zip(&case.leaves).all(|((a, b), ty)| {
                    a == b
                        || match ty.as_float() {
                            Some(Float::F64) => {
                                f64::from_bits(*a).is_nan() && f64::from_bits(*b).is_nan()
                            }
                            Some(Float::F32) => {
                                f32::from_bits(*a as u32).is_nan()
                                    && f32::from_bits(*b as u32).is_nan()
                            }
                            None => false,
                        }
                })
        }
        (one, other) => one == other,
    };
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
        for case in cases(compiled) {
            let parameters = module.functions[case.id.index()].parameters();
            let stateful = module.functions[case.id.index()].owner.is_some();
            for (index, call) in case.calls.iter().enumerate() {
                let mut arguments = call.clone();
                // What the compiler added, a work struct, is nothing that Rust knows.
                for added in &parameters[call.len()..] {
                    arguments.push(vec![0; module.leaves(&added.ty).len()]);
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
                agree("interpreter", module, &case, index, &got);
            }
        }
    }
}

/// Every call in one process: all words in from one thread, all words out in another.
fn run_c(compiled: &Compiled, cases: &[Case], toolchain: &Toolchain, flags: &[&str]) {
    run_c_with(compiled, cases, toolchain, flags, &Options::default());
}

fn run_c_with(
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
    let mut process = Process::run(compiled, &main, toolchain, flags)
        .unwrap_or_else(|error| panic!("{leg}: {error}"));
    for (at, case) in cases.iter().enumerate() {
        for (index, call) in case.calls.iter().enumerate() {
            let mut words = vec![at as u64];
            words.extend(call.iter().flatten());
            let got = called(&mut process, &words, case.leaves.len())
                .unwrap_or_else(|error| panic!("{leg}, {} of {call:x?}: {error}", case.name));
            agree(&leg, &compiled.module, case, index, &got);
        }
    }
}

fn called(process: &mut Process, words: &[u64], results: usize) -> Result<Outcome, Error> {
    process.send(words)?;
    match process.receive(1)?[0] {
        0 => Ok(Ok(process.receive(results)?)),
        status => Ok(Err(FAULTS[status as usize - 1])),
    }
}

#[test]
fn the_c_agrees() {
    let compiled = corpus();
    let cases = cases(compiled);
    thread::scope(|scope| {
        // Least and most optimised; the flight goes through every level.
        let levels =
            |it: &Toolchain| if it.emulator.is_some() { it.level == 2 } else { it.level != 2 };
        for toolchain in toolchain::all().into_iter().filter(levels) {
            let cases = &cases;
            scope.spawn(move || run_c(compiled, cases, &toolchain, &[]));
        }
        for toolchain in toolchain::host().into_iter().filter(|it| it.level == 0) {
            let cases = &cases;
            scope.spawn(move || run_c(compiled, cases, &toolchain, &SANITIZED));
        }
    });
}

/// What has matrices, with these by rows and as arrays of rows: the same bits again.
#[test]
fn the_c_agrees_in_every_layout() {
    let mut cases = cases(corpus());
    let chapters = ["matrices", "algorithms", "kinds", "data"];
    let has_matrices =
        |name: &str| chapters.iter().any(|chapter| name.contains(&format!("programs::{chapter}")));
    cases.retain(|case| has_matrices(&case.name));
    let natives = corpus::programs::ENTRIES.iter().filter(|native| has_matrices(native.module));
    for layout in [Layout::Rows, Layout::Array] {
        let options = Options { layout, ..Options::default() };
        let compiled = corpus_with(&options);
        for (case, native) in cases.iter_mut().zip(natives.clone()) {
            case.id = callable(&compiled, native).expect("it was compiled before");
        }
        thread::scope(|scope| {
            let levels = |it: &Toolchain| it.level == if it.emulator.is_some() { 2 } else { 0 };
            for toolchain in toolchain::all().into_iter().filter(levels) {
                let (compiled, cases, options) = (&compiled, &cases, &options);
                let sanitized = toolchain.emulator.is_none() && toolchain.compiler == "gcc";
                let flags = if sanitized { &SANITIZED[..] } else { &[][..] };
                scope.spawn(move || run_c_with(compiled, cases, &toolchain, flags, options));
            }
        });
    }
}

/// What Rust cannot be handed: an enum that holds none of its variants.
#[test]
fn a_wrong_variant_is_a_fault() {
    let compiled = corpus();
    let id = entry(compiled, "Follower", "step").expect("a program of the corpus");
    let main = harness::programs(&compiled.explicit, &[(id, 2)]);
    for toolchain in toolchain::host() {
        let mut process = Process::run(compiled, &main, &toolchain, &[]).expect("it builds");
        for (wish, expected) in [(2, None), (3, Some(Fault::Variant)), (255, Some(Fault::Variant))]
        {
            let words = [0, 0.5_f64.to_bits(), wish];
            let got = called(&mut process, &words, 2).expect("it answers");
            assert_eq!(got.err(), expected, "{} of {wish}", toolchain.name());
        }
    }
}
