//! A program of [`counted`](crate::harness::counted) that goes on running: it counts the instructions of the calls that it
//! reads, and waits for more. So the emulator starts and translates the program once for millions of calls.
//!
//! Invariant: of each call whose words it gets, there is one count, in order. It must not know the meaning of the words.

use std::collections::VecDeque;
use std::io::{BufRead as _, BufReader, Write as _};
use std::path::Path;
use std::process::{Child, ChildStderr, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::Duration;

use wait_timeout::ChildExt as _;

use crate::toolchain::{Toolchain, line};
use crate::watch;

/// Timeout of one call.
const PATIENCE: Duration = Duration::from_secs(300);
/// Number of last lines that an error repeats.
const LINES: usize = 3;

/// The program, with the ends of its streams.
pub struct Running {
    child: Child,
    command: String,
    input: Sender<Vec<u8>>,
    lines: Receiver<String>,
}

impl Running {
    /// Starts a program of [`watch::built`] in a folder.
    ///
    /// # Errors
    /// The message of the compiler or the system.
    pub fn start(toolchain: &Toolchain, folder: &Path, program: &Path) -> Result<Running, String> {
        let plugin = watch::plugin(folder)?.display().to_string();
        let mut command = toolchain.runner_with(program, &["-plugin", &plugin]);
        if toolchain.bare {
            opened_as_words(folder)?;
        }
        command.current_dir(folder);
        command.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
        let text = line(&command);
        let mut child = command.spawn().map_err(|error| format!("{text}: {error}"))?;
        let ends = child.stdin.take().zip(child.stderr.take());
        let (mut stdin, said) = ends.ok_or_else(|| format!("{text}: it has no streams"))?;
        let (sender, lines) = channel();
        std::thread::spawn(move || pass_on(said, &sender));
        // A program that does not go on reads nothing: whoever writes to it waits, too.
        let (input, words) = channel::<Vec<u8>>();
        std::thread::spawn(move || {
            while let Ok(words) = words.recv() {
                if stdin.write_all(&words).and_then(|()| stdin.flush()).is_err() {
                    return;
                }
            }
        });
        Ok(Running { child, command: text, input, lines })
    }

    /// Passes the words of some calls to the program. Returns the instructions of each call.
    ///
    /// # Errors
    /// The program ends or waits too long, with its last lines.
    pub fn count(&mut self, input: Vec<u8>, calls: usize) -> Result<Vec<u64>, String> {
        // A program that has ended takes no words, and its lines say why.
        let _ = self.input.send(input);
        let (mut counts, mut others) = (Vec::with_capacity(calls), VecDeque::new());
        while counts.len() < calls {
            let line = match self.lines.recv_timeout(PATIENCE) {
                Ok(line) => line,
                Err(end) => {
                    let lines: Vec<String> = others.into();
                    let why = self.why(end);
                    return Err(format!("{}: {why}\n{}", self.command, lines.join("\n")));
                }
            };
            match line.parse() {
                Ok(count) => counts.push(count),
                Err(_) => {
                    others.push_back(line);
                    if others.len() > LINES {
                        others.pop_front();
                    }
                }
            }
        }
        Ok(counts)
    }

    /// Returns the reason why no line came.
    fn why(&mut self, end: RecvTimeoutError) -> String {
        // Its streams close shortly before it ends.
        let ended = match end {
            RecvTimeoutError::Disconnected => self.child.wait_timeout(PATIENCE),
            RecvTimeoutError::Timeout => self.child.try_wait(),
        };
        match ended {
            Ok(Some(status)) => status.to_string(),
            _ => "it does not go on".to_owned(),
        }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // It waits for words that do not come.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Sends each line of a program, until it or the receiver ends.
fn pass_on(said: ChildStderr, to: &Sender<String>) {
    for line in BufReader::new(said).split(b'\n') {
        let Ok(line) = line else { return };
        if to.send(String::from_utf8_lossy(&line).into_owned()).is_err() {
            return;
        }
    }
}

/// Names the emulator's standard input as the file that a program without an operating system reads.
#[cfg(unix)]
fn opened_as_words(folder: &Path) -> Result<(), String> {
    let link = folder.join("words.in");
    // A file of an earlier run.
    let _ = std::fs::remove_file(&link);
    std::os::unix::fs::symlink("/dev/stdin", link).map_err(|error| error.to_string())
}

#[cfg(not(unix))]
fn opened_as_words(_folder: &Path) -> Result<(), String> {
    Err("this system has no `/dev/stdin`, from which the emulated program reads".to_owned())
}
