//! Stages with a name, a progress line while they run, and their duration at the end.
//!
//! Invariants:
//!
//! * everything is printed on standard error; standard output is for results;
//! * without a terminal a stage is two plain lines, its start and its end;
//! * the output of a captured program is shown completely if it fails, and not at all if it succeeds;
//! * while an attached program uses the terminal, there is no progress line.
//!
//! What it must not know: which stages there are.

use crate::error::Error;
use anstyle::{AnsiColor, Style};
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{BufRead, BufReader, IsTerminal, Read};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver, Sender};
use std::time::{Duration, Instant};

const GREEN: Style = Style::new().bold().fg_color(Some(anstyle::Color::Ansi(AnsiColor::Green)));

/// Runs stages and remembers how long each took.
#[derive(Debug)]
pub struct Progress {
    moving: bool,
    silent: bool,
    done: Vec<(String, Duration)>,
}

impl Default for Progress {
    fn default() -> Self {
        Self { moving: std::io::stderr().is_terminal(), silent: false, done: Vec::new() }
    }
}

impl Progress {
    /// For concurrent work: only failures are reported.
    #[must_use]
    pub fn silent() -> Self {
        Self { moving: false, silent: true, done: Vec::new() }
    }

    /// Prints the durations of the stages that finished concurrently.
    pub fn done_beside(&self, other: &Self) {
        for (name, time) in other.done() {
            anstream::eprintln!("{GREEN}{name}{GREEN:#} ok, {} beside the build", seconds(*time));
        }
    }

    /// Runs a stage whose programs' output is captured; `work` gets a handle for the progress line.
    ///
    /// # Errors
    ///
    /// Those of `work`.
    pub fn closed<T>(
        &mut self,
        name: &str,
        work: impl FnOnce(&Voice) -> Result<T, Error>,
    ) -> Result<T, Error> {
        let start = Instant::now();
        let outcome = self.moving(name, work);
        self.end(name, start, outcome.is_ok());
        outcome
    }

    /// Runs work that reports its own end.
    ///
    /// # Errors
    ///
    /// Those of `work`.
    pub fn moving<T>(
        &self,
        name: &str,
        work: impl FnOnce(&Voice) -> Result<T, Error>,
    ) -> Result<T, Error> {
        let voice = match self.silent {
            true => Voice::hidden(),
            false => Voice::new(name, self.moving),
        };
        let outcome = work(&voice);
        voice.bar.finish_and_clear();
        outcome
    }

    /// Runs a stage whose programs use the terminal directly.
    ///
    /// # Errors
    ///
    /// Those of `work`.
    pub fn open<T>(
        &mut self,
        name: &str,
        work: impl FnOnce() -> Result<T, Error>,
    ) -> Result<T, Error> {
        anstream::eprintln!("{GREEN}{name}{GREEN:#} ...");
        let start = Instant::now();
        let outcome = work();
        self.end(name, start, outcome.is_ok());
        outcome
    }

    /// Returns the finished stages with their durations.
    #[must_use]
    pub fn done(&self) -> &[(String, Duration)] {
        &self.done
    }

    fn end(&mut self, name: &str, start: Instant, good: bool) {
        if good {
            let time = start.elapsed();
            if !self.silent {
                anstream::eprintln!("{GREEN}{name}{GREEN:#} ok, {}", seconds(time));
            }
            self.done.push((name.to_owned(), time));
        }
    }
}

/// Handle for the progress line of a stage.
#[derive(Debug)]
pub struct Voice {
    bar: ProgressBar,
}

impl Voice {
    fn new(name: &str, moving: bool) -> Self {
        if !moving {
            anstream::eprintln!("{name} ...");
            return Self::hidden();
        }
        let bar = ProgressBar::new_spinner().with_prefix(name.to_owned());
        if let Ok(style) =
            ProgressStyle::with_template("{spinner} {prefix:.bold} {elapsed:.dim} {wide_msg:.dim}")
        {
            bar.set_style(style);
        }
        bar.enable_steady_tick(Duration::from_millis(100));
        Self { bar }
    }

    /// A handle without output.
    #[must_use]
    pub fn hidden() -> Self {
        Self { bar: ProgressBar::hidden() }
    }

    /// Shows a line on the progress line.
    pub fn say(&self, line: &str) {
        let plain = anstream::adapter::strip_str(line).to_string();
        self.bar.set_message(plain.trim().to_owned());
    }

    /// Prints permanent lines above the progress line.
    pub fn print(&self, lines: &str) {
        self.bar.suspend(|| anstream::eprintln!("{lines}"));
    }
}

/// Runs a program that uses the terminal directly.
///
/// # Errors
///
/// [`Error::Spawn`] if it does not start.
pub fn attached(command: &mut Command) -> Result<ExitStatus, Error> {
    command.status().map_err(|source| spawn_error(command, source))
}

/// Runs a program with captured output, whose last line is on the progress line. If it fails, prints its output.
///
/// # Errors
///
/// [`Error::Spawn`] if it does not start.
pub fn captured(command: &mut Command, voice: &Voice) -> Result<ExitStatus, Error> {
    let (status, heard) = heard(command, voice)?;
    if !status.success() {
        voice.print(&heard.join("\n"));
    }
    Ok(status)
}

/// Runs a program with its errors on the progress line; returns its standard output. If it fails, prints its errors.
///
/// # Errors
///
/// [`Error::Spawn`] if it does not start.
pub fn answered(command: &mut Command, voice: &Voice) -> Result<(ExitStatus, String), Error> {
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().map_err(|source| spawn_error(command, source))?;
    let (sender, lines) = mpsc::channel();
    listen(child.stderr.take(), sender);
    let output = child.stdout.take();
    let reader = std::thread::spawn(move || {
        let mut bytes = Vec::new();
        let read = output.map(|mut output| output.read_to_end(&mut bytes));
        read.transpose().map(|_| String::from_utf8_lossy(&bytes).into_owned())
    });
    let heard: Vec<String> = lines.iter().inspect(|line| voice.say(line)).collect();
    let status = child.wait().map_err(|source| spawn_error(command, source))?;
    if !status.success() {
        voice.print(&heard.join("\n"));
    }
    let text = reader.join().unwrap_or_else(|_| Ok(String::new()));
    Ok((status, text.map_err(|source| spawn_error(command, source))?))
}

/// Runs a program whose errors go to the terminal; returns its standard output.
///
/// # Errors
///
/// [`Error::Spawn`] if it does not start.
pub fn answered_beside(command: &mut Command) -> Result<(ExitStatus, String), Error> {
    command.stderr(Stdio::inherit());
    let output = command.output().map_err(|source| spawn_error(command, source))?;
    Ok((output.status, String::from_utf8_lossy(&output.stdout).into_owned()))
}

fn heard(command: &mut Command, voice: &Voice) -> Result<(ExitStatus, Vec<String>), Error> {
    if anstream::AutoStream::choice(&std::io::stderr()) != anstream::ColorChoice::Never {
        command.env("CARGO_TERM_COLOR", "always");
    }
    let (mut child, lines) = started(command)?;
    let mut heard = Vec::new();
    for line in lines {
        voice.say(&line);
        heard.push(line);
    }
    let status = child.wait().map_err(|source| spawn_error(command, source))?;
    Ok((status, heard))
}

/// Starts a program; returns a receiver of the lines of both its outputs, which ends when the program closes them.
///
/// # Errors
///
/// [`Error::Spawn`] if it does not start.
pub fn started(command: &mut Command) -> Result<(Child, Receiver<String>), Error> {
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().map_err(|source| spawn_error(command, source))?;
    let (sender, lines) = mpsc::channel();
    listen(child.stdout.take(), sender.clone());
    listen(child.stderr.take(), sender);
    Ok((child, lines))
}

/// Sends the stream's lines from a thread until the stream ends.
fn listen(stream: Option<impl Read + Send + 'static>, sender: Sender<String>) {
    let Some(stream) = stream else { return };
    std::thread::spawn(move || {
        let mut reader = BufReader::new(stream);
        let mut bytes = Vec::new();
        while reader.read_until(b'\n', &mut bytes).is_ok_and(|count| count > 0) {
            let line = String::from_utf8_lossy(&bytes).trim_end().to_owned();
            bytes.clear();
            if sender.send(line).is_err() {
                break;
            }
        }
    });
}

/// The error for a program that could not be started, or whose output could not be read.
#[must_use]
pub fn spawn_error(command: &Command, source: std::io::Error) -> Error {
    Error::Spawn { program: command.get_program().to_string_lossy().into_owned(), source }
}

fn seconds(time: Duration) -> String {
    format!("{:.1} s", time.as_secs_f64())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_that_does_not_start_is_named() {
        let outcome = captured(&mut Command::new("no-such-program-anywhere"), &Voice::hidden());
        assert!(
            matches!(outcome, Err(Error::Spawn { program, .. }) if program == "no-such-program-anywhere")
        );
    }

    #[test]
    fn both_outputs_are_read_to_the_end() -> Result<(), Error> {
        // More than a pipe holds, on both: a reader that minds only one of them would hang.
        let script = "i=0; while [ $i -lt 20000 ]; do echo out; echo err >&2; i=$((i+1)); done";
        let status = captured(Command::new("sh").args(["-c", script]), &Voice::hidden())?;
        assert!(status.success());
        Ok(())
    }

    #[test]
    fn only_stages_that_went_through_are_done() {
        let mut progress = Progress::silent();
        let good = progress.closed("format", |_| Ok(()));
        let bad: Result<(), Error> =
            progress.closed("lints", |_| Err(Error::StillMissing { tools: vec![] }));
        assert!(good.is_ok() && bad.is_err());
        let names: Vec<_> = progress.done().iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["format"]);
    }
}
