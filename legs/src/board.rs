//! Emitted C on a board, called over a serial line. This module has the sources to add to the board's own startup and
//! port, and the host's end of the line.
//!
//! A request is a frame: the index of an entry point, and the words of the component and of the arguments. The answer
//! has a mark and the status; unless that is a fault, it also has the words of the result, of the component, and of
//! each argument that the call may change. A special index requests the board's identity.
//!
//! Invariant: an answer comes from exactly this C, or it is an error. What it must not know: the meaning of the
//! words.

use std::collections::BTreeSet;
use std::io::{Read, Write};

use bessemer_backend::c::Options;
use bessemer_codegen::compile::Compiled;
use bessemer_ir::FunctionId;

use crate::lockstep::complaint;
use crate::serial::{self, Serial};
use crate::{digest, harness};

/// Sources of the serial protocol in C, for every board.
const LINK: [(&str, &str); 5] = [
    ("link.c", include_str!("../c/link/link.c")),
    ("link.h", include_str!("../c/link/link.h")),
    ("uart.h", include_str!("../c/link/uart.h")),
    ("wrong.c", include_str!("../c/link/wrong.c")),
    ("wrong.h", include_str!("../c/link/wrong.h")),
];

/// File name of the program.
const PROGRAM: &str = "verify_main.c";

/// Index that requests the board's identity instead of a call.
const WHO: u64 = u64::MAX;

/// Number of times that a board is asked for its identity, since it may be starting.
const ASKED: usize = 3;

/// Reason why a board cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The line failed.
    #[error("{0}")]
    Line(#[from] serial::Error),
    /// The board reported an error.
    #[error("the board says: {0}")]
    Said(String),
    /// The board has other C.
    #[error("the board's firmware is of other C")]
    Other,
    /// Two files would have the same name.
    #[error(
        "`{0}` is a file of the emitted C and one of the program around it; a prefix in bessemer.toml parts them"
    )]
    Twice(String),
}

/// Returns the sources of the firmware by their names: the program, the serial protocol, and the emitted C.
///
/// # Errors
///
/// [`Error::Twice`].
pub fn sources(
    compiled: &Compiled,
    entries: &[(FunctionId, u32)],
    options: &Options,
) -> Result<Vec<(String, String)>, Error> {
    let program = harness::answers(&compiled.explicit, entries, options, identity(compiled));
    let own = LINK.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned()));
    let emitted = compiled.files.iter().filter(|it| it.name.ends_with(['c', 'h']));
    let emitted = emitted.map(|it| (it.name.clone(), it.text.clone()));
    let all: Vec<_> = own.chain([(PROGRAM.to_owned(), program)]).chain(emitted).collect();
    let mut names = BTreeSet::new();
    match all.iter().find(|(name, _)| !names.insert(name)) {
        Some((name, _)) => Err(Error::Twice(name.clone())),
        None => Ok(all),
    }
}

/// Returns the identity that distinguishes this C from other C.
pub fn identity(compiled: &Compiled) -> u64 {
    let texts = compiled.files.iter().flat_map(|it| it.name.bytes().chain(it.text.bytes()));
    digest(&texts.map(u64::from).collect::<Vec<_>>())
}

/// A board that has answered.
#[derive(Debug)]
pub struct Board<L> {
    serial: Serial<L>,
    identity: u64,
    /// Number of identity queries whose answer may still come: the board was slow, not absent.
    late: usize,
}

impl<L: Read + Write> Board<L> {
    /// Requests the board's identity and checks it.
    ///
    /// # Errors
    ///
    /// The board does not answer, or has other C.
    pub fn open(line: L, identity: u64) -> Result<Self, Error> {
        let mut board = Self { serial: Serial::new(line), identity, late: 0 };
        let mut last = None;
        for _ in 0..ASKED {
            let answer = board.ask(&[WHO]);
            if matches!(answer, Err(Error::Line(serial::Error::Silent))) {
                board.late += 1;
            }
            match answer {
                Ok(words) if words == [identity] => return Ok(board),
                Ok(_) => return Err(Error::Other),
                Err(Error::Line(serial::Error::Closed)) => {
                    return Err(Error::Line(serial::Error::Closed));
                }
                // It may have heard the end of a frame, or nothing yet.
                Err(error) => last = Some(error),
            }
        }
        Err(last.unwrap_or(Error::Other))
    }

    /// Calls an entry point by its index with input words; returns the output words.
    ///
    /// # Errors
    ///
    /// The error of the line or the board.
    pub fn call(
        &mut self,
        place: usize,
        words: impl Iterator<Item = u64>,
    ) -> Result<Vec<u64>, Error> {
        let frame: Vec<u64> = std::iter::once(place as u64).chain(words).collect();
        let mut answer = self.ask(&frame)?;
        // An answer of one word is a fault, whose number is no identity.
        while self.late > 0 && answer == [self.identity] {
            self.late -= 1;
            answer = self.answer()?;
        }
        Ok(answer)
    }

    fn ask(&mut self, frame: &[u64]) -> Result<Vec<u64>, Error> {
        self.serial.send(frame)?;
        self.answer()
    }

    fn answer(&mut self) -> Result<Vec<u64>, Error> {
        let mut words = self.serial.receive()?;
        if let Some(said) = complaint(&words) {
            return Err(Error::Said(said));
        }
        match words.first() {
            Some(&harness::ANSWER) => Ok(words.split_off(1)),
            _ => Err(Error::Line(serial::Error::Garbled("it is no answer"))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::net::Shutdown;
    use std::os::unix::net::UnixStream;

    /// Returns the error for a board with these answers to the identity query and one call.
    fn said(answers: &[&[u64]]) -> String {
        let (here, there) = UnixStream::pair().expect("a line");
        let mut board = Serial::new(there);
        answers.iter().for_each(|words| board.send(words).expect("room"));
        board.line().shutdown(Shutdown::Write).expect("a line");
        let called = Board::open(here, 77).and_then(|mut board| board.call(0, [5].into_iter()));
        called.map_or_else(|error| error.to_string(), |words| format!("{words:?}"))
    }

    #[test]
    fn what_is_no_answer_is_told() {
        let wrong: Vec<u64> = [6].into_iter().chain("no".bytes().map(u64::from)).collect();
        let who = &[harness::ANSWER, 77][..];
        assert_eq!(said(&[who, &[harness::ANSWER, 0, 9]]), "[0, 9]");
        // It had heard half a frame before.
        assert_eq!(said(&[&wrong, who, &[harness::ANSWER, 3]]), "[3]");
        assert_eq!(said(&[&[harness::ANSWER, 78]]), "the board's firmware is of other C");
        assert_eq!(said(&[who, &wrong]), "the board says: no");
        assert!(said(&[who, &[7]]).ends_with("garbled: it is no answer"));
        assert_eq!(said(&[who]), "the line is closed: the other end is gone");
    }

    /// An identity that comes after the query's timeout is not taken for the answer to a call.
    #[test]
    fn a_late_identity_is_no_answer_to_a_call() {
        let (here, there) = UnixStream::pair().expect("a line");
        let mut slow = Serial::new(there);
        let who = [harness::ANSWER, 77];
        for answer in [&who[..], &[harness::ANSWER, 0, 9], &[harness::ANSWER, 77]] {
            slow.send(answer).expect("room");
        }
        let mut board = Board { serial: Serial::new(here), identity: 77, late: 1 };
        assert_eq!(board.call(0, [5].into_iter()).expect("an answer"), [0, 9]);
        assert_eq!(board.call(0, [5].into_iter()).expect("an answer"), [77], "once for each query");
    }
}
