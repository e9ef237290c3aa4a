//! The model itself as a contender: the routines that a model calls, compiled by rustc.
//!
//! Uses the protocol and the numbers of `bench/c/harness.c`.

mod data;
mod large;
mod small;

use std::io::{BufRead, Write};
use std::time::Instant;

use data::{Element, Numbers};

/// A named case.
struct Case {
    name: String,
    prepare: Box<dyn Fn() -> Box<dyn Prepared>>,
}

/// A case with its numbers.
trait Prepared {
    /// Restores the inputs; this is not measured.
    fn load(&mut self);
    /// Returns true if `load` must precede each run.
    fn destroys(&self) -> bool;
    /// Runs the measured work.
    fn run(&mut self);
    /// Returns the result as words.
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

/// Marks the start of counted instructions. Its text differs from the end's, since rustc would merge equal functions.
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

/// Returns the nanoseconds of `repetitions` runs, after one that fills the caches. As in `harness.c`, several
/// positions of the stack count equally.
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

/// Returns the nanoseconds of some runs with the stack `BYTES` bytes lower.
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
