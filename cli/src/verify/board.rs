//! The C on the user's own board, over a serial line: the sources of its firmware, and the board's answers.
//!
//! Invariant: the firmware contains every entry point that can be called with words, in the order of the module, so
//! that one firmware can answer any request.

use std::path::Path;

use bessemer_codegen::compile::{Compiled, Options};
use bessemer_ir::Fault;
use bessemer_legs::board::{self, Board};
use bessemer_legs::entries::callable;
use bessemer_legs::outcome::Outcome;
use bessemer_legs::port::Port;

use super::{Case, fault};
use crate::error::Error;

/// Writes the sources of the firmware into a folder, and says how to build them.
///
/// # Errors
/// Two files have one name; the folder cannot be written.
pub fn write(compiled: &Compiled, options: &Options, folder: &Path) -> Result<String, Error> {
    let sources = board::sources(compiled, &callable(compiled), options)
        .map_err(|why| Error::Board { port: folder.to_owned(), why })?;
    let failed = |source| Error::File { path: folder.to_owned(), source };
    std::fs::create_dir_all(folder).map_err(failed)?;
    for (name, text) in &sources {
        let path = folder.join(name);
        std::fs::create_dir_all(path.parent().unwrap_or(folder)).map_err(failed)?;
        std::fs::write(path, text).map_err(failed)?;
    }
    Ok(format!(
        "{} files in {}\n\nBuild them into firmware with your board's start, the three functions of uart.h and, where memory is short,\n\
         -DLINK_MOST=1024; load it, and ask it: cargo bessemer verify --serial PORT --baud SPEED\n",
        sources.len(),
        folder.display()
    ))
}

/// Calls each case on the board at a port.
///
/// # Errors
/// The failure of port, line or board.
pub fn outcomes(
    compiled: &Compiled,
    cases: &[Case],
    port: &Path,
    baud: u32,
) -> Result<Vec<Vec<Outcome>>, Error> {
    let failed = |why| Error::Board { port: port.to_owned(), why };
    let line =
        Port::open(port, baud).map_err(|source| Error::File { path: port.to_owned(), source })?;
    let mut board = Board::open(line, board::identity(compiled)).map_err(failed)?;
    let places = callable(compiled);
    let mut outcomes = Vec::new();
    for case in cases {
        let place = places.iter().position(|(id, _)| *id == case.id).unwrap_or(usize::MAX);
        let one = |call: &Vec<Vec<u64>>| {
            let words = board.call(place, call.iter().flatten().copied()).map_err(failed)?;
            Ok(match words.split_first() {
                Some((0, words)) => Ok(words.to_vec()),
                Some((status, _)) => Err(fault(*status)),
                None => Err(Fault::LeftOut),
            })
        };
        outcomes.push(case.calls.iter().map(one).collect::<Result<_, Error>>()?);
    }
    Ok(outcomes)
}
