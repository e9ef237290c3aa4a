//! The table of edge values: every operation on every type of number, at every edge, on every leg.
//!
//! Native Rust, the interpreter and the C (gcc and clang, -O0 and -O3, and under UBSan) have to agree in
//! each bit and in each fault.

use std::collections::{BTreeMap, BTreeSet};
use std::thread;

use bessemer_backend::c::names::FAULTS;
use bessemer_codegen::compile::Compiled;
use bessemer_codegen::compile::Options;
use bessemer_interpret::{Interpreter, Stop};
use bessemer_ir::{Fault, FunctionId, Scalar};
use bessemer_tests::batch::{self, Outcome};
use bessemer_tests::edge_values::{self, Breadth};
use bessemer_tests::panics::caught;
use bessemer_tests::store::once;
use bessemer_tests::{compiled, compiled_with, texts, toolchain, turn};
use edges::Case;

/// A call: which case, and the words of its operands.
type Call = (usize, Vec<u64>);

fn scalar(name: &str) -> Scalar {
    Scalar::from_name(name).unwrap_or_else(|| panic!("`{name}` is no scalar"))
}

fn result_type(case: &Case) -> Scalar {
    scalar(case.types[case.types.len() - 1])
}

fn calls(cases: &[&Case]) -> Vec<Call> {
    let mut calls = Vec::new();
    for (index, case) in cases.iter().enumerate() {
        let operands = &case.types[..case.types.len() - 1];
        let breadth = match operands.len() {
            1 => Breadth::All,
            2 => Breadth::Pairs,
            _ => Breadth::Triples,
        };
        let mut rows: Vec<Vec<u64>> = vec![Vec::new()];
        for ty in operands {
            let values = edge_values::of(scalar(ty), breadth);
            let longer = rows.iter().flat_map(|row| {
                values.iter().map(|value| row.iter().copied().chain([*value]).collect())
            });
            rows = longer.collect();
        }
        calls.extend(rows.into_iter().map(|row| (index, row)));
    }
    calls
}

fn status(fault: Fault) -> u64 {
    FAULTS.iter().position(|other| *other == fault).map_or(0, |at| at as u64 + 1)
}

/// Any NaN is one.
fn settled(ty: Scalar, (status, word): Outcome) -> Outcome {
    let nan = match ty.name() {
        "f64" => f64::from_bits(word).is_nan(),
        "f32" => f32::from_bits(word as u32).is_nan(),
        _ => false,
    };
    (status, if nan { u64::MAX } else { word })
}

/// Returns the result of Rust; a panic is the fault that its message names.
fn native(case: &Case, operands: &[u64]) -> Outcome {
    let mut words = operands.iter().copied();
    match caught(|| (case.call)(&mut || words.next().unwrap_or_default())) {
        Ok(word) => (0, word),
        Err(message) => {
            let fault = match message.as_str() {
                text if text.contains("square root") || text.contains("logarithm") => {
                    Fault::Assertion
                }
                text if text.contains("zero") => Fault::DivisionByZero,
                text if text.contains("shift") => Fault::Shift,
                text if text.contains("overflow") => Fault::Overflow,
                text if text.contains("min <= max") || text.contains("min > max") => Fault::Clamp,
                _ => panic!("{} {operands:x?}: {message}", case.name),
            };
            (status(fault), 0)
        }
    }
}

fn interpreted(interpreter: &mut Interpreter<'_>, id: FunctionId, operands: &[u64]) -> Outcome {
    let mut arguments: Vec<Vec<u64>> = operands.iter().map(|word| vec![*word]).collect();
    match interpreter.call(id, &mut arguments) {
        Ok(words) => (0, words[0]),
        Err(Stop::Fault { fault, .. }) => (status(fault), 0),
        Err(stop) => panic!("{stop}"),
    }
}

/// The functions of the cases; none may be missing on either side.
fn functions(compiled: &Compiled, cases: &[&Case]) -> Vec<FunctionId> {
    let functions = compiled.module.functions.iter().enumerate();
    let by_name: BTreeMap<(&str, &str), FunctionId> = functions
        .map(|(index, it)| ((it.module.as_str(), it.name.as_str()), FunctionId(index as u32)))
        .collect();
    let wanted: BTreeSet<_> = cases.iter().map(|case| (case.module, case.name)).collect();
    let own = by_name.keys().filter(|(module, _)| module.starts_with("edges::"));
    assert!(own.eq(wanted.iter()), "the cases are not the functions of the package");
    cases.iter().map(|case| by_name[&(case.module, case.name)]).collect()
}

fn compare(leg: &str, cases: &[&Case], calls: &[Call], native: &[Outcome], found: &[Outcome]) {
    assert_eq!(found.len(), native.len(), "{leg}");
    let mut wrong: BTreeMap<String, String> = BTreeMap::new();
    for (((index, operands), native), found) in calls.iter().zip(native).zip(found) {
        let case = cases[*index];
        let found = settled(result_type(case), *found);
        if found != *native {
            let name = format!("{}::{}", case.module, case.name);
            wrong
                .entry(name)
                .or_insert_with(|| format!("{operands:x?}: native {native:x?}, here {found:x?}"));
        }
    }
    assert!(wrong.is_empty(), "{leg}: {wrong:#?}");
}

#[test]
fn every_operation_at_every_edge() {
    let compiled = compiled("edges");
    let cases: Vec<&Case> = edges::CASES.iter().copied().flatten().collect();
    let functions = functions(&compiled, &cases);
    let calls = calls(&cases);
    println!("{} functions, {} calls", cases.len(), calls.len());

    let expected: Vec<Outcome> = calls
        .iter()
        .map(|(index, operands)| {
            let case = cases[*index];
            settled(result_type(case), native(case, operands))
        })
        .collect();

    for (name, module) in [("as written", &compiled.module), ("explicit", &compiled.explicit)] {
        let mut interpreter = Interpreter::new(module);
        let found: Vec<Outcome> = calls
            .iter()
            .map(|(index, operands)| interpreted(&mut interpreter, functions[*index], operands))
            .collect();
        compare(&format!("interpreter, {name}"), &cases, &calls, &expected, &found);
    }

    // What was proved is in this one.
    let of_proofs = compiled_with("edges", &Options { keep_checks: true, ..Options::default() });
    let mut interpreter = Interpreter::new(&of_proofs.explicit);
    let found: Vec<Outcome> = calls
        .iter()
        .map(|(index, operands)| interpreted(&mut interpreter, functions[*index], operands))
        .collect();
    compare("interpreter, what was proved", &cases, &calls, &expected, &found);

    let folder = tempfile::tempdir().expect("a temporary folder");
    let input = folder.path().join("calls");
    let words = calls.iter().flat_map(|(index, operands)| {
        std::iter::once(*index as u64).chain(operands.iter().copied())
    });
    let bytes: Vec<u8> = words.flat_map(u64::to_le_bytes).collect();
    std::fs::write(&input, bytes).expect("the words are written");
    // gcc warns of its own instrumentation. What is in for what compilers document is here, too.
    let sanitized = [
        "-O1",
        "-w",
        "-DBESSEMER_PLAIN",
        "-fsanitize=undefined,float-cast-overflow",
        "-fno-sanitize-recover=all",
    ];
    let mut legs: Vec<(toolchain::Toolchain, &[&str])> = Vec::new();
    for toolchain in toolchain::host() {
        match toolchain.level {
            2 => legs.push((toolchain, &sanitized)),
            _ => legs.push((toolchain, &[])),
        }
    }
    if !turn::is_full() {
        // Of one compiler what C leaves undefined, of the other what it optimises.
        let checked = turn::one_of(vec!["gcc", "clang"]);
        legs.retain(|(it, flags)| match checked.contains(&it.compiler) {
            true => !flags.is_empty(),
            false => it.level == 3,
        });
    }
    legs.extend(toolchain::target().into_iter().filter(|it| it.level == 3).map(|it| (it, &[][..])));
    let legs = turn::one_of(legs);
    let content = (texts(&compiled.files), texts(&of_proofs.files), &calls, &expected);
    once("every operation at every edge", &content, || {
        thread::scope(|scope| {
            let kept = toolchain::host().into_iter().find(|it| it.level == 2);
            let kept = kept.into_iter().map(|toolchain| (&of_proofs, toolchain, &sanitized[..]));
            let plain =
                legs.iter().map(|(toolchain, flags)| (&compiled, toolchain.clone(), *flags));
            for (compiled, toolchain, flags) in plain.chain(kept) {
                let (functions, input) = (&functions, &input);
                let (cases, calls, expected) = (&cases, &calls, &expected);
                scope.spawn(move || {
                    let found = batch::run(compiled, functions, &toolchain, flags, input)
                        .unwrap_or_else(|error| panic!("{}: {error}", toolchain.name()));
                    let leg = format!("{} {flags:?}", toolchain.name());
                    compare(&leg, cases, calls, expected, &found);
                });
            }
        });
    });
}
