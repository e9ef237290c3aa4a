//! Software on a board in lockstep with this process over a serial line: each period is requested and answered.
//!
//! Invariant: an answer belongs to its request, or it is an error; after an error nothing continues.
//!
//! What it must not know: the meaning of a period's words. The other end is `examples/zynq/main.c`.

use std::io::{Read, Write};

use crate::serial::{self, Serial};

/// The kinds of frames, given by their first word.
mod kind {
    pub const READY: u64 = 1;
    pub const BEGIN: u64 = 2;
    pub const SETTINGS: u64 = 3;
    pub const STEP: u64 = 4;
    pub const REPORT: u64 = 5;
}

/// First word of a frame that reports an error on the board.
const WRONG: u64 = 6;

/// Returns the error that a board's words report, if any.
pub fn complaint(words: &[u64]) -> Option<String> {
    match words {
        [WRONG, text @ ..] => Some(text.iter().map(|word| char::from(*word as u8)).collect()),
        _ => None,
    }
}

/// Reason why the lockstep ended.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The line failed.
    #[error("in period {periods}: {source}")]
    Line {
        /// Number of successful periods.
        periods: u64,
        /// Error of the line.
        source: serial::Error,
    },
    /// The board reported an error.
    #[error("in period {periods} the board says: {said}")]
    Board {
        /// Number of successful periods.
        periods: u64,
        /// Message of the board.
        said: String,
    },
    /// The answer does not fit the request.
    #[error("in period {periods} the board answers something else than it was asked")]
    Other {
        /// Number of successful periods.
        periods: u64,
    },
    /// The board has other software.
    #[error("the board's firmware is of other models: build it anew and load it")]
    Models,
}

/// Use of the stack, bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stack {
    /// Stack used by calls of the entry point, including its callees, bytes.
    pub step: u64,
    /// Stack used by the whole program, bytes.
    pub all: u64,
    /// Size of the stack.
    pub size: u64,
}

/// A board in lockstep.
#[derive(Debug)]
pub struct Lockstep<L> {
    serial: Serial<L>,
    periods: u64,
}

impl<L: Read + Write> Lockstep<L> {
    /// Waits until the board at the other end of the line answers, and checks the identity of its software.
    ///
    /// # Errors
    ///
    /// It does not answer, or has other software.
    pub fn open(line: L, identity: u64) -> Result<Self, Error> {
        let mut board = Self { serial: Serial::new(line), periods: 0 };
        match board.receive()?[..] {
            [kind::READY, its] if its == identity => Ok(board),
            [kind::READY, _] => Err(Error::Models),
            _ => Err(Error::Other { periods: 0 }),
        }
    }

    /// Returns the line.
    pub fn line(&mut self) -> &mut L {
        self.serial.line()
    }

    /// Resets the software to its initial state.
    ///
    /// # Errors
    ///
    /// The error of the line or the board.
    pub fn begin(&mut self) -> Result<(), Error> {
        self.periods = 0;
        self.ask(&[kind::BEGIN]).map(drop)
    }

    /// Sends settings.
    ///
    /// # Errors
    ///
    /// The error of the line or the board.
    pub fn set(&mut self, settings: impl Iterator<Item = u64>) -> Result<(), Error> {
        self.ask(&std::iter::once(kind::SETTINGS).chain(settings).collect::<Vec<_>>()).map(drop)
    }

    /// Runs one period: sends the input words, and returns the output words.
    ///
    /// # Errors
    ///
    /// The error of the line or the board.
    pub fn step(&mut self, inputs: impl Iterator<Item = u64>) -> Result<Vec<u64>, Error> {
        let words: Vec<u64> = [kind::STEP, self.periods].into_iter().chain(inputs).collect();
        let mut outputs = self.ask(&words)?;
        if outputs.is_empty() || outputs.remove(0) != self.periods {
            return Err(Error::Other { periods: self.periods });
        }
        self.periods += 1;
        Ok(outputs)
    }

    /// Returns the use of the stack so far.
    ///
    /// # Errors
    ///
    /// The error of the line or the board.
    pub fn stack(&mut self) -> Result<Stack, Error> {
        match self.ask(&[kind::REPORT])?[..] {
            [step, all, size] => Ok(Stack { step, all, size }),
            _ => Err(Error::Other { periods: self.periods }),
        }
    }

    /// Sends a frame; returns the words of its answer after the kind, which must be equal.
    fn ask(&mut self, words: &[u64]) -> Result<Vec<u64>, Error> {
        let periods = self.periods;
        self.serial.send(words).map_err(|source| Error::Line { periods, source })?;
        let mut answer = self.receive()?;
        if answer.is_empty() || answer.remove(0) != words[0] {
            return Err(Error::Other { periods });
        }
        Ok(answer)
    }

    fn receive(&mut self) -> Result<Vec<u64>, Error> {
        let periods = self.periods;
        let words = self.serial.receive().map_err(|source| Error::Line { periods, source })?;
        match complaint(&words) {
            Some(said) => Err(Error::Board { periods, said }),
            None => Ok(words),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::net::Shutdown;
    use std::os::unix::net::UnixStream;

    /// Returns the error for a board with these answers.
    fn said(answers: &[&[u64]]) -> String {
        let (here, there) = UnixStream::pair().expect("a line");
        let mut board = Serial::new(there);
        answers.iter().for_each(|words| board.send(words).expect("room"));
        board.line().shutdown(Shutdown::Write).expect("a line");
        let flown = Lockstep::open(here, 77).and_then(|mut board| {
            board.begin()?;
            board.set([1, 2].into_iter())?;
            board.step([3].into_iter())?;
            board.step([4].into_iter())
        });
        flown.map_or_else(|error| error.to_string(), |words| format!("{words:?}"))
    }

    #[test]
    fn what_does_not_answer_what_was_asked_is_told() {
        let wrong: Vec<u64> = [6].into_iter().chain("no".bytes().map(u64::from)).collect();
        let (ready, begin, set) = (&[1_u64, 77][..], &[2_u64][..], &[3_u64][..]);
        let start = [ready, begin, set];
        let cases: [(&[&[u64]], &str); 7] = [
            (&[&[4, 0, 8], &[4, 1, 9]], "[9]"),
            (&[&[4, 0, 8], &[4, 0, 9]], "in period 1 the board answers something else"),
            (&[&[4, 0, 8], &[2]], "in period 1 the board answers something else"),
            (&[&[4, 0, 8], &wrong], "in period 1 the board says: no"),
            (&[&[4, 0, 8]], "in period 1: the line is closed: the other end is gone"),
            (&[&[4]], "in period 0 the board answers something else"),
            (&[&[]], "in period 0 the board answers something else"),
        ];
        for (answers, expected) in cases {
            let told = said(&[&start, answers].concat());
            assert!(told.starts_with(expected), "{answers:?}: {told}");
        }
        assert!(said(&[&[1, 78]]).starts_with("the board's firmware is of other models"));
    }
}
