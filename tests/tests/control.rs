//! Control and structure: each program of `tests/control` natively, in the interpreter and as C, over
//! the same inputs: the same words, the same state, and a fault where the Rust panics.

use std::sync::OnceLock;

use bessemer::Plain;
use bessemer_codegen::c::names::FAULTS;
use bessemer_codegen::compile::{self, Compiled};
use bessemer_codegen::interpret::Stop;
use bessemer_codegen::source::Sources;
use bessemer_codegen::{diagnostic, generate};
use bessemer_ir::Fault;
use bessemer_tests::interpreter::Interpreted;
use bessemer_tests::panics::caught;
use bessemer_tests::pilot::entry;
use bessemer_tests::process::Process;
use bessemer_tests::toolchain::{self, Toolchain};
use bessemer_tests::{root, value, words};
use control::{choice, each, leaving, parts, passes, rates};

fn programs() -> &'static Compiled {
    static COMPILED: OnceLock<Compiled> = OnceLock::new();
    COMPILED.get_or_init(|| {
        let sources = Sources::new(root());
        let package = generate::tree(&root(), "control").unwrap_or_else(|error| panic!("{error}"));
        let compiled = compile::compile(&package, &sources, &compile::Options::default())
            .unwrap_or_else(|errors| panic!("{}", diagnostic::render(&errors, &sources, false)));
        if let Some(folder) = std::env::var_os("BESSEMER_SHOW") {
            for file in &compiled.files {
                let path = std::path::Path::new(&folder).join(&file.name);
                std::fs::write(path, &file.text).expect("a folder to show the C in");
            }
        }
        compiled
    })
}

/// What one call came to: the words of the result and of the state, or nothing after a panic.
type Outcome = Option<Vec<u64>>;

/// A component with its native entry point.
struct Program<T> {
    name: &'static str,
    run: fn(&mut T, &[u64]) -> Vec<u64>,
}

/// Runs every leg over `calls`, each a list of arguments of one word; after a fault, from the initial
/// state. Gives the faults that came.
fn compare<T: Plain + Default>(program: &Program<T>, calls: &[Vec<u64>]) -> Vec<Fault> {
    let compiled = programs();
    let entry = entry(compiled, program.name, "run").expect("an entry point");
    let mut native = T::default();
    let outcomes: Vec<Outcome> = calls
        .iter()
        .map(|arguments| match caught(|| (program.run)(&mut native, arguments)) {
            Ok(mut result) => {
                result.extend(words(&native));
                Some(result)
            }
            Err(_) => {
                native = T::default();
                None
            }
        })
        .collect();

    let mut faults = Vec::new();
    for module in [&compiled.module, &compiled.explicit] {
        let mut leg = Interpreted::new(module, entry);
        faults.clear();
        for (arguments, outcome) in calls.iter().zip(&outcomes) {
            let apart: Vec<_> = arguments.iter().map(|word| vec![*word]).collect();
            let called = match leg.step(&apart) {
                Ok(result) => Some(result),
                Err(Stop::Fault { fault, .. }) => {
                    faults.push(fault);
                    leg = Interpreted::new(module, entry);
                    None
                }
                Err(stop) => panic!("{}: the interpreter stopped: {stop}", program.name),
            };
            assert_eq!(called, *outcome, "{}, interpreter: {arguments:?}", program.name);
        }
    }

    for toolchain in toolchains() {
        let mut leg = Process::start(compiled, entry, &toolchain)
            .unwrap_or_else(|error| panic!("{}: {error}", toolchain.name()));
        let mut told = faults.iter();
        for (arguments, outcome) in calls.iter().zip(&outcomes) {
            let results = leg.step(arguments).expect("the C runs");
            let place = format!("{}, {}: {arguments:?}", program.name, toolchain.name());
            match outcome {
                Some(outcome) => {
                    assert_eq!(results[0], 0, "{place}");
                    assert_eq!(&results[1..], outcome.as_slice(), "{place}");
                }
                None => {
                    let fault = told.next().expect("the interpreter told it");
                    let number = FAULTS.iter().position(|other| other == fault).map(|n| n + 1);
                    assert_eq!(Some(results[0] as usize), number, "{place}");
                    leg.restart(&toolchain).expect("the C runs again");
                }
            }
        }
    }
    faults
}

/// As far as they are there: without optimisation and with all of it.
fn toolchains() -> Vec<Toolchain> {
    let wanted = [("gcc", 0), ("gcc", 3), ("clang", 3)];
    let mut all = toolchain::host();
    all.retain(|toolchain| wanted.contains(&(toolchain.compiler, toolchain.level)));
    all
}

/// Every combination of one word from each list.
fn combinations(lists: &[&[u64]]) -> Vec<Vec<u64>> {
    lists.iter().fold(vec![Vec::new()], |all, list| {
        let longer = all.iter().flat_map(|one| {
            list.iter().map(|word| {
                let mut longer = one.clone();
                longer.push(*word);
                longer
            })
        });
        longer.collect()
    })
}

fn int(value: i64) -> u64 {
    value as u64
}

/// `program!(choice::Level: i32)`: the entry point `run` with these arguments.
macro_rules! program {
    ($module:ident::$component:ident: $($argument:ty),*) => {
        Program::<$module::$component> {
            name: stringify!($component),
            run: |component, arguments| {
                let mut next = arguments.iter();
                words(&component.run($(value::<$argument>(&[*next.next().expect("a word")])),*))
            },
        }
    };
}

#[test]
fn a_match_takes_ranges() {
    let calls: Vec<_> = [-5, 0, 1, 4, 5, 6, 7, 8, 79, 80, 81, i32::MAX, i32::MIN]
        .map(|celsius| vec![int(i64::from(celsius))])
        .into();
    assert_eq!(compare(&program!(choice::Level: i32), &calls), []);
}

#[test]
fn a_match_takes_guards_and_names() {
    let values = [0, 1, 5, 9, 10, 19, 20, 30, 39, 40, 200, 255];
    let calls = combinations(&[&values, &[0, 3, 11, 19, 100, 250], &[0, 1]]);
    let faults = compare(&program!(choice::Guarded: u8, u8, bool), &calls);
    assert!(faults.contains(&Fault::DivisionByZero) && faults.contains(&Fault::Overflow));
}

#[test]
fn a_name_is_the_value_before_the_arm_changes_it() {
    let calls = combinations(&[&[0, 1, 2, 3], &[0, 1]]);
    let calls = [calls.clone(), calls.into_iter().rev().collect()].concat();
    let _ = compare(&program!(choice::Pressed: choice::Press, bool), &calls);
}

#[test]
fn few_values_are_a_list_of_cases() {
    let kinds: Vec<u64> = (-4..14).map(int).collect();
    let _ = compare(&program!(choice::Listed: i16, bool), &combinations(&[&kinds, &[0, 1]]));
}

#[test]
fn labels_name_the_loop_that_is_left() {
    let wanted: Vec<u64> = [1, 2, 4, 5, 7, 9, 2, 11, 50, 2].map(int).into();
    let calls = combinations(&[&wanted, &[7, int(-3)]]);
    let _ = compare(&program!(leaving::Search: i32, i32), &calls);
    let calls = combinations(&[&[0, 1, 2, 3, 4, 5, 6, 7], &[0, 1, 2, 3, 4, 5, 6, 7]]);
    let _ = compare(&program!(leaving::Deep: u8, u8), &calls);
}

#[test]
fn a_loop_ends_within_its_bound_or_faults() {
    let float = |value: f64| value.to_bits();
    let values = [0.5, 1.0, 100.0, 255.0, 256.0, 257.0, 512.0, 1e9, f64::NAN, f64::INFINITY];
    let calls = combinations(&[&values.map(float), &[float(1.0), float(0.0), float(300.0)]]);
    let faults = compare(&program!(passes::Halving: f64, f64), &calls);
    assert!(!faults.is_empty() && faults.iter().all(|fault| *fault == Fault::Bound));

    let values = [0, 1, 2, 3, 4, 15, 16, 17, 99, 65_535, 65_536, 4_294_967_295];
    assert_eq!(compare(&program!(passes::Root: u32), &combinations(&[&values])), []);

    let starts: Vec<u64> = (0..60).collect();
    let calls = combinations(&[&starts, &[10, 100, 100_000]]);
    let faults = compare(&program!(passes::Collatz: u32, u32), &calls);
    assert!(faults.contains(&Fault::Bound));
}

#[test]
fn values_are_taken_apart_and_put_together() {
    let values = [0.0, -1.5, 3.0].map(f64::to_bits);
    let calls = combinations(&[&values, &values[1..], &[0, 1, 2, 4, 100, 201]]);
    let faults = compare(&program!(parts::Counter: u8), &combinations(&[&[0, 0, 1]]));
    assert_eq!(faults, [Fault::DivisionByZero, Fault::DivisionByZero, Fault::Overflow]);
    let faults = compare(&program!(parts::Parts: f64, f64, u8), &calls);
    assert!(faults.len() == 18 && faults.iter().all(|fault| *fault == Fault::Assertion));
}

#[test]
fn loops_go_through_elements() {
    let gains = [0.0, -1.5, 1e300].map(f64::to_bits);
    let calls = combinations(&[&gains, &[0, 1, 2], &[0, int(-4), 5, 100]]);
    let faults = compare(&program!(each::Each: f64, usize, i32), &calls);
    assert!(faults.contains(&Fault::Index));
}

#[test]
fn components_are_made_of_components_at_their_own_rates() {
    let values = [0.0, -1.5, 3.0, 1e-3].map(f64::to_bits);
    let calls = combinations(&[&values, &values, &[0, 1]]);
    assert_eq!(compare(&program!(rates::Rates: f64, f64, bool), &calls), []);
}
