//! The comparison: the original, the marked copy, the interpreter before and after the passes, and the C of gcc at `-O2`.
//!
//! Each function is called with the inputs of the crate's own tests, with edge values, and with small numbers. An outcome is a fault or words; any NaN is any
//! other. The copy, the interpreter and the C must agree in each word. The original may differ where it calls elementary functions of another library.

use bessemer_backend::c::names::FAULTS;
use bessemer_codegen::compile::{self, Compiled, Options};
use bessemer_codegen::generate::{self, Error, Job};
use bessemer_frontend::diagnostic;
use bessemer_frontend::source::Sources;
use bessemer_interpret::{Interpreter, Stop};
use bessemer_ir::{Float, FunctionId, Module, Scalar, Type};
use bessemer_tests::arguments::{Size, words};
use bessemer_tests::outcome::{Outcome, meant, same};
use bessemer_tests::process::{Process, at_once};
use bessemer_tests::random::Random;
use bessemer_tests::{harness, toolchain};

use super::native;
use super::source::{self, Crate, LaidOut};

/// Number of calls of each function with edge values, and with small numbers.
const CALLS: usize = 200;

/// Numbers of calls and differences of a crate.
#[derive(Clone, Copy, Default)]
pub struct Counts {
    /// Number of functions.
    pub entries: usize,
    /// Number of calls of each leg.
    pub calls: usize,
    /// Number of calls with inputs of the crate's own tests.
    pub of_tests: usize,
    /// Number of calls in which interpreter or C differ from the marked copy.
    pub legs: usize,
    /// Number of calls in which the marked copy differs from the original.
    pub original: usize,
    /// Number of differing calls with inputs of the crate's own tests.
    pub tests_differ: usize,
    /// Largest difference from the original in a floating-point number, in units of its last place.
    pub ulp: u64,
}

/// A function and its calls.
struct Case<'f> {
    name: &'f str,
    id: FunctionId,
    result: Type,
    leaves: Vec<Type>,
    calls: Vec<Vec<Vec<u64>>>,
    of_tests: usize,
    original: Vec<Outcome>,
    marked: Vec<Outcome>,
}

/// Compares the legs of a crate in its workspace.
pub fn compare(of: &Crate, laid: &LaidOut, say: &dyn Fn(&str)) -> Result<Counts, String> {
    say("the marked copy becomes C");
    let compiled = compiled(of, laid)?;
    say("the original and the copy are built");
    let program = native::build(&laid.workspace, &format!("native-{}", of.name))?;
    say("calls");
    let module = &compiled.module;
    let mut random = Random(7);
    let absent = source::expected(&laid.workspace.join("marked/src"))?;
    let mut cases = Vec::new();
    for (index, function) in laid.functions.iter().enumerate() {
        let at = module.functions.iter().position(|it| {
            it.owner.is_none() && it.name == function.name && it.module.ends_with("drive")
        });
        let at = at.ok_or_else(|| {
            let known = module.functions.iter().map(|it| format!("{}::{}", it.module, it.name));
            let known: Vec<String> = known.collect();
            format!("`{}` is not among the functions: {}", function.name, known.join(" "))
        })?;
        let (id, function) = (FunctionId(at as u32), function);
        let params: Vec<&Type> = module.functions[at].parameters()[..function.params.len()]
            .iter()
            .map(|local| &local.ty)
            .collect();
        let mut calls = of_tests(of, &function.name, module, &params)?;
        let count = calls.len();
        let drawn = if params.is_empty() { usize::from(count == 0) } else { CALLS };
        for size in [Size::Edges, Size::Tame] {
            for _ in 0..drawn {
                calls.push(params.iter().map(|ty| words(&mut random, module, ty, size)).collect());
            }
        }
        let ask = |side: usize| {
            let flat: Vec<_> = calls.iter().map(|it| (2 * index + side, it.concat())).collect();
            native::run(&program, &flat, &absent)
        };
        let (original, marked) = (ask(0)?, ask(1)?);
        let result = module.functions[at].result.clone();
        let leaves = module.leaves(&result);
        cases.push(Case {
            name: &laid.functions[index].name,
            id,
            result,
            leaves,
            calls,
            of_tests: count,
            original,
            marked,
        });
    }
    let mut counts = Counts { entries: cases.len(), ..Counts::default() };
    let mut wrong: Vec<Vec<bool>> = cases.iter().map(|it| vec![false; it.calls.len()]).collect();
    for module in [&compiled.module, &compiled.explicit] {
        interpreted(&compiled, module, &cases, &mut wrong)?;
    }
    say("gcc compiles the C");
    by_c(&compiled, &cases, &mut wrong)?;
    for (case, wrong) in cases.iter().zip(&wrong) {
        counts.calls += case.calls.len();
        counts.of_tests += case.of_tests;
        counts.legs += wrong.iter().filter(|it| **it).count();
        for at in 0..case.calls.len() {
            let (one, other) = (&case.original[at], &case.marked[at]);
            if !same(one, other, &case.leaves) {
                counts.original += 1;
                counts.tests_differ += usize::from(at < case.of_tests);
                counts.ulp = counts.ulp.max(ulp(one, other, &case.leaves));
                if counts.original <= 3 {
                    say(&format!(
                        "{}({:x?}): the original {one:x?}, the copy {other:x?}",
                        case.name, case.calls[at]
                    ));
                }
            }
        }
        if let Some(at) = wrong.iter().position(|it| *it) {
            say(&format!(
                "{}({:x?}): a leg differs from {:x?}",
                case.name, case.calls[at], case.marked[at]
            ));
        }
    }
    Ok(counts)
}

/// Compiles the marked copy to C.
fn compiled(of: &Crate, laid: &LaidOut) -> Result<Compiled, String> {
    let job = Job::new(&laid.workspace, &format!("marked-{}", of.name));
    let sources = Sources::new(&laid.workspace);
    let tree = generate::tree(&job).map_err(|error| match error {
        Error::Models(messages) | Error::Refused(messages) if !messages.diagnostics.is_empty() => {
            diagnostic::render(&messages.diagnostics, &sources, false)
        }
        other => other.to_string(),
    })?;
    compile::compile(&tree.package, &sources, &Options::default())
        .map_err(|errors| diagnostic::render(&errors, &sources, false))
}

/// The calls of `inputs`: the name of a function, and the numbers of its arguments in their order; a missing number is 0.
fn of_tests(
    of: &Crate,
    name: &str,
    module: &Module,
    params: &[&Type],
) -> Result<Vec<Vec<Vec<u64>>>, String> {
    let inputs = of.ours("inputs");
    let mut calls = Vec::new();
    for line in inputs.lines() {
        let mut numbers = line.split_whitespace();
        if numbers.next() != Some(name) {
            continue;
        }
        let mut call = Vec::new();
        for param in params {
            let mut of_one = Vec::new();
            for leaf in module.leaves(param) {
                let text = numbers.next().unwrap_or("0");
                of_one.push(
                    word(&leaf, text).ok_or_else(|| format!("inputs: `{text}` in `{line}`"))?,
                );
            }
            call.push(of_one);
        }
        if let Some(more) = numbers.next() {
            return Err(format!("inputs: `{more}` in `{line}` is too many"));
        }
        calls.push(call);
    }
    Ok(calls)
}

fn word(leaf: &Type, text: &str) -> Option<u64> {
    match leaf {
        Type::Scalar(Scalar::Float(Float::F64)) => text.parse::<f64>().ok().map(f64::to_bits),
        Type::Scalar(Scalar::Float(Float::F32)) => {
            text.parse::<f32>().ok().map(|it| u64::from(it.to_bits()))
        }
        Type::Scalar(Scalar::Bool) => text.parse::<u64>().ok().map(|it| it.min(1)),
        _ => {
            let hex = text.strip_prefix("0x").map(|it| u64::from_str_radix(it, 16).ok());
            hex.unwrap_or_else(|| text.parse::<i128>().ok().map(|it| it as u64))
        }
    }
}

fn note(case: &Case, module: &Module, at: usize, got: &Outcome, wrong: &mut bool) {
    let got = meant(module, std::slice::from_ref(&case.result), got);
    *wrong |= !same(&case.marked[at], &got, &case.leaves);
}

fn interpreted(
    compiled: &Compiled,
    module: &Module,
    cases: &[Case],
    wrong: &mut [Vec<bool>],
) -> Result<(), String> {
    let mut interpreter = Interpreter::new(module);
    for (case, wrong) in cases.iter().zip(wrong) {
        let parameters = module.functions[case.id.index()].parameters();
        for (at, call) in case.calls.iter().enumerate() {
            let mut arguments = call.clone();
            for added in &parameters[call.len()..] {
                arguments.push(vec![0; module.width(&added.ty)]);
            }
            let got = match interpreter.call(case.id, &mut arguments) {
                Ok(words) => Ok(words),
                Err(Stop::Fault { fault, .. }) => Err(fault),
                Err(stop) => return Err(format!("{}: {stop}", case.name)),
            };
            note(case, &compiled.module, at, &got, &mut wrong[at]);
        }
    }
    Ok(())
}

fn by_c(compiled: &Compiled, cases: &[Case], wrong: &mut [Vec<bool>]) -> Result<(), String> {
    let toolchains = toolchain::host();
    let gcc = toolchains.iter().find(|it| it.compiler == "gcc" && it.level == 2);
    let gcc = gcc.ok_or("gcc is missing: `cargo xtask test --install`")?;
    let params = |id: FunctionId| compiled.module.functions[id.index()].params;
    let ids: Vec<_> = cases.iter().map(|case| (case.id, params(case.id))).collect();
    let main = harness::programs_with(&compiled.explicit, &ids, &Options::default());
    let mut process =
        Process::run(compiled, &main, gcc, &[]).map_err(|error| format!("gcc: {error}"))?;
    for (place, (case, wrong)) in cases.iter().zip(wrong).enumerate() {
        let taken = case.calls.iter().map(|call| 1 + call.iter().flatten().count());
        let together = at_once(taken.max().unwrap_or_default().max(1 + case.leaves.len()));
        for (batch, calls) in case.calls.chunks(together).enumerate() {
            let died = |error| format!("{}: the C ended: {error}", case.name);
            process.ask(place, calls).map_err(died)?;
            for at in (batch * together..).take(calls.len()) {
                let got = match process.receive(1).map_err(died)?[0] {
                    0 => Ok(process.receive(case.leaves.len()).map_err(died)?),
                    status => Err(FAULTS[status as usize - 1]),
                };
                note(case, &compiled.module, at, &got, &mut wrong[at]);
            }
        }
    }
    Ok(())
}

/// Returns the largest distance of two outcomes' floating-point numbers, in units of the last place. It is the largest number there is if
/// something else differs, or one is a fault.
fn ulp(one: &Outcome, other: &Outcome, leaves: &[Type]) -> u64 {
    let (Ok(one), Ok(other)) = (one, other) else { return u64::MAX };
    let ordered = |word: u64, sign: u64| match word & sign {
        0 => i128::from(word),
        _ => -i128::from(word & (sign - 1)),
    };
    let far = |((a, b), leaf): ((&u64, &u64), &Type)| match leaf.as_float() {
        Some(Float::F64) => (ordered(*a, 1 << 63) - ordered(*b, 1 << 63)).unsigned_abs(),
        Some(Float::F32) => (ordered(*a, 1 << 31) - ordered(*b, 1 << 31)).unsigned_abs(),
        None if a == b => 0,
        None => u128::from(u64::MAX),
    };
    let far = one.iter().zip(other).zip(leaves).map(far).max().unwrap_or_default();
    u64::try_from(far).unwrap_or(u64::MAX)
}
