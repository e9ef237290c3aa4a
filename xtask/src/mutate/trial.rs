//! Runs one test command in the copy, and finds its result in the output of cargo and the test runner.
//!
//! Invariants:
//!
//! * the first failure ends the command and all processes that it started;
//! * so does silence: a mutant may make the C, or the compiler itself, run for ever.
//!
//! What it must not know: mutants.

use std::process::{Child, Command};
use std::sync::mpsc::RecvTimeoutError;
use std::time::Duration;

use crate::error::Error;
use crate::stages::{self, Voice};

/// Longest time without output of a command. The slowest test, or the longest compilation, takes less on a busy
/// machine.
const SILENCE: Duration = Duration::from_secs(600);

/// Result of a command.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Found {
    /// No failure.
    Nothing,
    /// A test failed: its name.
    Test(String),
    /// A package does not compile: its name.
    Broken(String),
    /// The command failed without naming a test.
    Failure,
    /// The command could not be executed: the last line of its output.
    Unrun(String),
    /// The command printed nothing for too long.
    Silence,
}

/// Runs a command to its end or to its first failure.
///
/// # Errors
///
/// The command does not start.
pub fn run(command: &mut Command, voice: &Voice) -> Result<Found, Error> {
    let tests = command.get_args().next().is_some_and(|word| word == "test");
    let (mut child, lines) = stages::started(command)?;
    let mut last = String::new();
    let found = loop {
        match lines.recv_timeout(SILENCE) {
            Ok(line) => {
                voice.say(&line);
                if let Some(found) = failure(&line) {
                    break found;
                }
                last = line;
            }
            Err(RecvTimeoutError::Timeout) => break Found::Silence,
            Err(RecvTimeoutError::Disconnected) => {
                let status = child.wait().map_err(|source| stages::spawn_error(command, source))?;
                return Ok(match status.success() {
                    true => Found::Nothing,
                    // Of tests that fail cargo says so.
                    false if tests => Found::Unrun(last),
                    false => Found::Failure,
                });
            }
        }
    };
    end(&mut child);
    Ok(found)
}

/// Returns the failure that a line reports.
fn failure(line: &str) -> Option<Found> {
    if let Some(rest) = line.strip_prefix("error: could not compile `") {
        return Some(Found::Broken(rest.split('`').next()?.to_owned()));
    }
    // A program of tests that ends before it has told.
    if line.starts_with("error: test failed") || line.starts_with("error: doctest failed") {
        return Some(Found::Failure);
    }
    let name = line.strip_prefix("test ")?.strip_suffix(" ... FAILED")?;
    Some(Found::Test(name.trim_end_matches(" - should panic").to_owned()))
}

/// Ends a program and its descendants: ending cargo alone would leave the tests running.
fn end(child: &mut Child) {
    let listed = Command::new("ps").args(["-A", "-o", "pid=,ppid="]).output();
    let listed = listed.map(|output| String::from_utf8_lossy(&output.stdout).into_owned());
    let all = descendants(child.id(), &listed.unwrap_or_default());
    // What has ended by now is no failure.
    let ids = all.iter().map(u32::to_string);
    let _ = Command::new("kill").arg("-KILL").args(ids).output();
    let _ = child.wait();
}

/// Returns a process and its descendants, from a list of processes and their parents.
fn descendants(process: u32, listed: &str) -> Vec<u32> {
    let mut found = vec![process];
    let pairs = listed.lines().filter_map(|line| {
        let mut words = line.split_whitespace().map(str::parse);
        Some((words.next()?.ok()?, words.next()?.ok()?))
    });
    let pairs: Vec<(u32, u32)> = pairs.collect();
    let mut at = 0;
    while let Some(&parent) = found.get(at) {
        found.extend(pairs.iter().filter(|(_, its)| *its == parent).map(|(id, _)| id));
        at += 1;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn failures_are_read_off_the_lines() {
        let test = |name: &str| Some(Found::Test(name.to_owned()));
        assert_eq!(failure("test corpus::the_c_agrees ... FAILED"), test("corpus::the_c_agrees"));
        assert_eq!(failure("test it_stops - should panic ... FAILED"), test("it_stops"));
        assert_eq!(failure("test corpus::the_c_agrees ... ok"), None);
        assert_eq!(failure("test result: FAILED. 1 passed; 1 failed"), None);
        let crashed = "error: test failed, to rerun pass `-p bessemer-codegen --lib`";
        assert_eq!(failure(crashed), Some(Found::Failure));
        let broken = "error: could not compile `bessemer-codegen` (lib) due to 1 previous error";
        assert_eq!(failure(broken), Some(Found::Broken("bessemer-codegen".to_owned())));
    }

    #[test]
    fn a_command_is_ended_with_all_that_it_started() -> Result<(), Error> {
        let voice = Voice::hidden();
        // The inner program would keep the pipe open for an hour.
        let script = "sh -c 'echo test a::b ... FAILED; sleep 3600; true'; true";
        let found = run(Command::new("sh").args(["-c", script]), &voice)?;
        assert_eq!(found, Found::Test("a::b".to_owned()));
        let ends = |script: &str| run(Command::new("sh").args(["-c", script]), &voice);
        assert_eq!(ends("echo test a ... ok")?, Found::Nothing);
        assert_eq!(ends("echo no; exit 1")?, Found::Failure);
        // The first word is what tells tests from others; `sh` takes it for a file that is not there.
        let unrun = run(Command::new("sh").args(["test", "--package", "none"]), &voice)?;
        assert!(matches!(unrun, Found::Unrun(_)), "{unrun:?}");
        Ok(())
    }

    #[test]
    fn descendants_are_found_at_any_depth() {
        let listed = "  1 0\n 20 1\n 30 20\n 40 30\n 50 1\n 31 20\n";
        assert_eq!(descendants(20, listed), [20, 30, 31, 40]);
        assert_eq!(descendants(50, listed), [50]);
    }
}
