//! Runs the test programs that cargo built, a process for each group of tests.
//!
//! A group is a module of a program at the top: its tests share what they compile once, and run one after another, so
//! that each has a time of its own, which the standard harness tells only on unstable Rust. The groups of all programs
//! share the processors to the end, where cargo runs one program after another.
//!
//! Invariants:
//! - a test runs as `cargo test` would run it: in the folder of its package, with the variables that cargo sets;
//! - a group that fails is printed whole; a test that passes is a line only if it took long;
//! - groups that used most of the processors in the last stored run begin first, so that none waits for a late long one.
//!
//! What it must not know: what the tests test.

mod group;
mod meter;
mod program;
mod times;

pub use meter::{Spent, processors};
pub use program::Program;
pub use times::{Times, slowest};

use crate::error::Error;
use crate::stages::Voice;
use group::Group;
use std::collections::VecDeque;
use std::sync::Mutex;
use std::time::Duration;

/// Number of groups that run at a time for each processor. Many wait for cargo, which runs one build at a time in a
/// target folder.
const WAITING: usize = 4;

/// Duration from which a passed test is printed on its own line.
const LONG: Duration = Duration::from_secs(5);

/// A finished test.
#[derive(Clone, Debug)]
pub struct Done {
    /// Title of the test: `package/program::test`.
    pub title: String,
    /// True if it passed.
    pub passed: bool,
    /// Time that it took.
    pub spent: Spent,
}

/// Runs the tests of `programs` that `chosen` selects by their titles; `known` has the processor time of each in the
/// stored run.
///
/// # Errors
///
/// [`Error::Spawn`] if a program does not start.
pub fn run(
    programs: &[Program],
    chosen: &dyn Fn(&str) -> bool,
    known: &Times,
    environment: &[(&str, String)],
    voice: &Voice,
) -> Result<Vec<Done>, Error> {
    let mut groups = Vec::new();
    for program in programs {
        let names = program.tests(environment)?;
        let names = names.into_iter().filter(|name| chosen(&program.title_of(name))).collect();
        groups.extend(Group::all(program, names));
    }
    groups.sort_by_key(|group| std::cmp::Reverse(group.known(known)));
    let count: usize = groups.iter().map(Group::len).sum();
    let queue = Mutex::new(VecDeque::from(groups));
    let done = Mutex::new(Vec::with_capacity(count));
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let workers = WAITING * processors;
    std::thread::scope(|scope| {
        let work = || -> Result<(), Error> {
            loop {
                let next = queue.lock().map_or(None, |mut queue| queue.pop_front());
                let Some(group) = next else { return Ok(()) };
                group.run(
                    environment,
                    &|one: Done| {
                        if one.passed && one.spent.work >= LONG {
                            voice.print(&format!(
                                "{:>7.1} s  {}",
                                one.spent.work.as_secs_f64(),
                                one.title
                            ));
                        }
                        if let Ok(mut done) = done.lock() {
                            voice.say(&format!("{} of {count}: {}", done.len() + 1, one.title));
                            done.push(one);
                        }
                    },
                    &|said| voice.print(said),
                )?;
            }
        };
        let running: Vec<_> = (0..workers).map(|_| scope.spawn(work)).collect();
        running.into_iter().try_for_each(|worker| worker.join().unwrap_or(Ok(())))
    })?;
    Ok(done.into_inner().unwrap_or_default())
}
