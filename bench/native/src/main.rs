//! The model's own contender: the routines that a model calls, as rustc compiles them.
//!
//! Speaks the protocol of `bench/c/harness.c`, on the same numbers.

mod data;
mod large;
mod small;

use std::io::{BufRead, Write};
use std::time::Instant;

use data::{Element, Numbers};

/// Something measured.
struct Case {
    name: String,
    prepare: Box<dyn Fn() -> Box<dyn Prepared>>,
}

/// A case with its numbers at hand.
trait Prepared {
    /// Not measured, before each run.
    fn load(&mut self);
    /// Returns true if `load` must precede each run.
    fn destroys(&self) -> bool;
    /// Runs the measured work.
    fn run(&mut self);
    /// The words of the result.
    fn words(&self) -> Vec<u64>;
}

fn main() {
    let cases = cases();
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.split_first() {
        Some((verb, _)) if verb == "serve" => serve(&cases),
        Some((_, names)) if !names.is_empty() => {
            count_nothing();
            names.iter().filter_map(|name| find(&cases, name)).for_each(count);
        }
        _ => {
            count_nothing();
            cases.iter().for_each(count);
        }
    }
}

fn cases() -> Vec<Case> {
    let mut cases = large::cases();
    cases.extend(small::cases::<f64>());
    cases.extend(small::cases::<f32>());
    cases
}

fn find<'a>(cases: &'a [Case], name: &str) -> Option<&'a Case> {
    cases.iter().find(|case| case.name == name)
}

/// The two names that instructions are counted between; not the same text, or they would be one function.
#[inline(never)]
fn bench_begin(name: &str) {
    std::hint::black_box((name, "begin"));
}

#[inline(never)]
fn bench_end(name: &str) {
    std::hint::black_box((name, "end"));
}

fn count_nothing() {
    bench_begin("nothing");
    bench_end("nothing");
    println!("nothing");
}

fn count(case: &Case) {
    let mut prepared = (case.prepare)();
    prepared.load();
    bench_begin(&case.name);
    prepared.run();
    bench_end(&case.name);
    println!("{}", case.name);
}

fn serve(cases: &[Case]) {
    let mut ready: Option<(String, Box<dyn Prepared>)> = None;
    for line in std::io::stdin().lock().lines().map_while(Result::ok) {
        let words: Vec<&str> = line.split_whitespace().collect();
        let answer = match *words.as_slice() {
            ["time", name, repetitions] => match find(cases, name) {
                Some(case) => {
                    if ready.as_ref().is_none_or(|(known, _)| known != name) {
                        ready = Some((name.to_owned(), (case.prepare)()));
                    }
                    let repetitions = repetitions.parse().unwrap_or(1);
                    ready
                        .as_mut()
                        .map(|(_, prepared)| measure(prepared.as_mut(), repetitions).to_string())
                }
                None => None,
            },
            ["result", name] => find(cases, name).map(|case| {
                let mut prepared = (case.prepare)();
                prepared.load();
                prepared.run();
                let words = prepared.words();
                words.iter().map(|word| format!("{word:x} ")).collect()
            }),
            _ => None,
        };
        println!("{}", answer.as_deref().unwrap_or("unknown"));
        let _ = std::io::stdout().flush();
    }
}

/// Nanoseconds of so many runs; one before them brings the caches back. As in `harness.c`, each place of the stack counts
/// alike.
fn measure(case: &mut dyn Prepared, repetitions: u32) -> u128 {
    let mut total = 0;
    if case.destroys() {
        case.load();
        case.run();
        for _ in 0..repetitions {
            case.load();
            let start = Instant::now();
            case.run();
            total += start.elapsed().as_nanos();
        }
    } else {
        case.load();
        // From 64 bytes on rustc's frames have another form, 32 bytes less: looked up, and of no harm if it changes.
        let places = [run_lower::<16>, run_lower::<32>, run_lower::<48>, run_lower::<96>];
        for (place, run) in (0..).zip(places) {
            total += match (repetitions + place) / 4 {
                0 => 0,
                runs => run(case, runs),
            };
        }
    }
    total
}

/// Nanoseconds of so many runs with the stack so many bytes lower.
#[inline(never)]
fn run_lower<const BYTES: usize>(case: &mut dyn Prepared, repetitions: u32) -> u128 {
    std::hint::black_box(&[0_u8; BYTES]);
    case.run();
    let start = Instant::now();
    for _ in 0..repetitions {
        case.run();
    }
    start.elapsed().as_nanos()
}
