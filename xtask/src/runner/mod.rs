//! Runs the test programs that cargo built, a process for each test.
//!
//! A process of its own gives each test a time of its own, which the standard harness tells only on unstable Rust;
//! and the tests of all programs share the processors to the end, where cargo runs one program after another.
//!
//! Invariants:
//! - a test runs as `cargo test` would run it: in the folder of its package, with the variables that cargo sets;
//! - a test that fails is printed whole; one that passes is a line only if it took long;
//! - tests that took longest in the last stored run begin first, so that no processor waits for a late long one.
//!
//! What it must not know: what the tests test.

mod program;
mod times;

pub use program::Program;
pub use times::{Times, slowest};

use crate::error::Error;
use crate::stages::Voice;
use std::collections::VecDeque;
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Tests at a time for each processor: many wait for cargo, which builds one thing at a time in a target folder.
const WAITING: usize = 2;

/// A passing test is a line of its own from here on.
const LONG: Duration = Duration::from_secs(5);

/// One test of one program.
#[derive(Clone, Debug)]
struct Test<'p> {
    program: &'p Program,
    name: String,
}

impl Test<'_> {
    /// `package/program::test`, as it is listed.
    fn title(&self) -> String {
        format!("{}::{}", self.program.title(), self.name)
    }
}

/// A test that has run.
#[derive(Clone, Debug)]
pub struct Done {
    /// `package/program::test`.
    pub title: String,
    /// Whether it passed.
    pub passed: bool,
    /// How long it took.
    pub time: Duration,
}

/// Runs the tests of `programs` that are `chosen` by their titles; `known` says how long each took before.
///
/// # Errors
/// [`Error::Spawn`] if a program does not start.
pub fn run(
    programs: &[Program],
    chosen: &dyn Fn(&str) -> bool,
    known: &Times,
    environment: &[(&str, String)],
    voice: &Voice,
) -> Result<Vec<Done>, Error> {
    let mut tests = Vec::new();
    for program in programs {
        let names = program.tests(environment)?;
        tests.extend(names.into_iter().map(|name| Test { program, name }));
    }
    tests.retain(|test| chosen(&test.title()));
    tests.sort_by_key(|test| std::cmp::Reverse(known.of(&test.title())));
    let count = tests.len();
    let queue = Mutex::new(VecDeque::from(tests));
    let done = Mutex::new(Vec::with_capacity(count));
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let workers = WAITING * processors;
    std::thread::scope(|scope| {
        let work = || -> Result<(), Error> {
            loop {
                let next = queue.lock().map_or(None, |mut queue| queue.pop_front());
                let Some(test) = next else { return Ok(()) };
                let one = one(&test, environment, voice)?;
                if let Ok(mut done) = done.lock() {
                    done.push(one);
                    voice.say(&format!("{} of {count}: {}", done.len(), test.title()));
                }
            }
        };
        let running: Vec<_> = (0..workers).map(|_| scope.spawn(work)).collect();
        running.into_iter().try_for_each(|worker| worker.join().unwrap_or(Ok(())))
    })?;
    Ok(done.into_inner().unwrap_or_default())
}

fn one(test: &Test<'_>, environment: &[(&str, String)], voice: &Voice) -> Result<Done, Error> {
    let start = Instant::now();
    let mut command = test.program.command(environment);
    command.args(["--exact", &test.name]);
    let output =
        command.stdin(Stdio::null()).output().map_err(|source| spawn_error(&command, source))?;
    let (time, passed) = (start.elapsed(), output.status.success());
    let title = test.title();
    if !passed {
        let said = [output.stdout, output.stderr].concat();
        voice.print(&format!("{}\nFAILED {title}", String::from_utf8_lossy(&said).trim_end()));
    } else if time >= LONG {
        voice.print(&format!("{:>7.1} s  {title}", time.as_secs_f64()));
    }
    Ok(Done { title, passed, time })
}

fn spawn_error(command: &Command, source: std::io::Error) -> Error {
    Error::Spawn { program: command.get_program().to_string_lossy().into_owned(), source }
}
