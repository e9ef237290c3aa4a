//! The calls that a dossier knows: made ones, those that covered something new, and those that tests recorded.

use bessemer_codegen::compile::Compiled;
use bessemer_ir::FunctionId;
use tempfile::TempDir;

use crate::error::Error;
use crate::verify::covered::each_of_tests;
use crate::verify::search::{Life, Search};

/// The calls.
pub struct Known<'k> {
    /// The search, which changes them.
    pub search: Search<'k>,
    /// The functions; the target of a life is its place among them.
    pub functions: Vec<FunctionId>,
    /// Made lives, and the beginnings of those that covered something new.
    pub lives: Vec<Life>,
    /// Number of rounds of a search.
    pub rounds: u64,
    tests: Option<&'k TempDir>,
}

impl<'k> Known<'k> {
    /// Returns the calls of a search that measured the coverage, and of the tests in a folder.
    pub fn of(mut search: Search<'k>, tests: Option<&'k TempDir>, rounds: u64) -> Known<'k> {
        let functions = search.targets.iter().map(|it| it.id).collect();
        let mut lives = search.first();
        lives.extend(search.targets.iter().flat_map(|it| it.known.iter().cloned()));
        Known { search, functions, lives, rounds, tests }
    }

    /// Calls `done` with the calls of each recording of a test.
    ///
    /// # Errors
    /// A recording cannot be read, or an error of `done`.
    pub fn of_tests(
        &self,
        compiled: &Compiled,
        mut done: impl FnMut(Life) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let Some(folder) = self.tests else { return Ok(()) };
        each_of_tests(compiled, folder.path(), |entry, calls| {
            match self.functions.iter().position(|it| *it == entry) {
                Some(target) => done(Life { target, calls }),
                None => Ok(()),
            }
        })
    }
}
