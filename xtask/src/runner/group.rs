//! Tests of one program that run in one process, one after another: those of one module at the top.
//!
//! The standard harness, told to use one thread, writes `test NAME ... ` before a test and its outcome after it. From
//! these lines each test gets its times: by the clock, and of the processors that the process and its children used.
//!
//! Invariants:
//! - each test of the group is reported once, also where the process dies within one;
//! - a test whose line does not tell its outcome, since others wrote into it, has passed if the whole process ends well.
//!
//! What it must not know: what else runs at the time.

use super::meter::Meter;
use super::{Done, Program, Times};
use crate::error::Error;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{BufRead as _, BufReader, Read as _};
use std::process::Stdio;
use std::time::Duration;

/// Tests of one program.
#[derive(Clone, Debug)]
pub(super) struct Group<'p> {
    program: &'p Program,
    names: Vec<String>,
}

impl<'p> Group<'p> {
    /// Forms the groups of these tests.
    pub(super) fn all(program: &'p Program, names: Vec<String>) -> impl Iterator<Item = Self> {
        let mut groups = BTreeMap::<String, Vec<String>>::new();
        for name in names {
            let module = name.split_once("::").map_or("", |(module, _)| module);
            groups.entry(module.to_owned()).or_default().push(name);
        }
        groups.into_values().map(move |names| Self { program, names })
    }

    /// Returns the number of tests.
    pub(super) fn len(&self) -> usize {
        self.names.len()
    }

    /// Returns the processor time that the group used in the stored run.
    pub(super) fn known(&self, times: &Times) -> Duration {
        self.names.iter().map(|name| times.of(&self.program.title_of(name))).sum()
    }

    /// Runs the tests; calls `told` with each result, and `shown` with the output of the process if a test failed.
    ///
    /// # Errors
    ///
    /// [`Error::Spawn`] if the program does not start.
    pub(super) fn run(
        &self,
        environment: &[(&str, String)],
        told: &dyn Fn(Done),
        shown: &dyn Fn(&str),
    ) -> Result<(), Error> {
        let mut command = self.program.command(environment);
        command.args(["--test-threads", "1", "--exact"]).args(&self.names);
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let program = command.get_program().to_string_lossy().into_owned();
        let failed = |source| Error::Spawn { program: program.clone(), source };
        let mut child = command.spawn().map_err(failed)?;
        let mut meter = Meter::of(child.id());
        let (out, mut err) = (child.stdout.take(), child.stderr.take());
        let (heard, complaints) = std::thread::scope(|scope| {
            let complaints = scope.spawn(|| {
                let mut text = Vec::new();
                // What cannot be read cannot be shown either.
                let _ = err.as_mut().map(|err| err.read_to_end(&mut text));
                text
            });
            let lines = out.into_iter().flat_map(|out| BufReader::new(out).split(b'\n'));
            let lines = lines.map_while(Result::ok);
            let lines = lines.map(|line| String::from_utf8_lossy(&line).into_owned());
            (self.heard(&mut meter, lines, told), complaints.join().unwrap_or_default())
        });
        let spent = meter.lap();
        let good = child.wait().map_err(failed)?.success();
        for name in &heard.open {
            told(Done { title: self.program.title_of(name), passed: good, spent });
        }
        if !good {
            let said = format!("{}{}", heard.text, String::from_utf8_lossy(&complaints));
            shown(said.trim_end());
        }
        Ok(())
    }

    /// Processes the lines that the harness writes while the tests run.
    fn heard(
        &self,
        meter: &mut Meter,
        lines: impl Iterator<Item = String>,
        told: &dyn Fn(Done),
    ) -> Heard {
        let mut heard = Heard { text: String::new(), open: self.names.iter().cloned().collect() };
        for line in lines {
            if let Some((name, passed)) = outcome(&line)
                && heard.open.remove(name)
            {
                told(Done { title: self.program.title_of(name), passed, spent: meter.lap() });
            }
            heard.text.push_str(&line);
            heard.text.push('\n');
        }
        heard
    }
}

/// Output of a process.
struct Heard {
    /// All lines of the output.
    text: String,
    /// Tests whose result is not known yet.
    open: BTreeSet<String>,
}

/// Returns the test that a line of the harness names, and whether it passed; an ignored test counts as passed.
fn outcome(line: &str) -> Option<(&str, bool)> {
    let (name, outcome) = line.strip_prefix("test ")?.split_once(" ... ")?;
    let name = name.strip_suffix(" - should panic").unwrap_or(name);
    let outcome = outcome.split(',').next()?;
    matches!(outcome, "ok" | "ignored" | "FAILED").then_some((name, outcome != "FAILED"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outcomes_are_read_from_the_lines_of_the_harness() {
        assert_eq!(outcome("test a::b ... ok"), Some(("a::b", true)));
        assert_eq!(outcome("test a::b - should panic ... ok"), Some(("a::b", true)));
        assert_eq!(outcome("test a::b ... ignored, takes hours"), Some(("a::b", true)));
        assert_eq!(outcome("test a::b ... FAILED"), Some(("a::b", false)));
        for other in ["test a::b ... a child says so", "test result: ok. 1 passed", "ok", ""] {
            assert_eq!(outcome(other), None, "{other}");
        }
    }
}
