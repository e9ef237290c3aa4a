//! Lowers valid IR to explicit IR, which the C back end can write without further statements.
//!
//! Precondition: a valid module. Postcondition, verified by [`check`]:
//!
//! * **F1** aggregates are whole values; or operands that are places or constants (in products and element-wise
//!   routines also transposes); or trees of constructors or element-wise routines, including the product of a column
//!   and a row. No place is written while it is still read;
//! * **F2** calls are whole values, statements, or the whole condition of an `if`, perhaps negated; unless they
//!   return a word, take words and shared references, and cannot fault;
//! * **F3** no operation faults by itself: a [`StmtKind::Check`](bessemer_ir::StmtKind::Check) precedes each
//!   operation without a proof;
//! * **F4** the bounds of a loop do not change while it runs, unless its body ends it.
//!
//! The meaning is preserved: equal results, and the same fault first. There is no constant folding, and no renaming
//! of the author's locals. Two optimisations are here, so that interpreter and proofs see them: passes of an outer loop that
//! share their loads run side by side, each number in its own order ([`tiles`]); statements over the elements of vectors move
//! next to each other if the C computes them in one loop ([`gather`]). Nothing else is reordered. The part of a condition that no
//! execution decides otherwise is left out ([`decided`]).

mod analysis;
mod callees;
mod checked;
mod decided;
mod declare;
mod explicit;
mod faults;
mod flatten;
mod gather;
mod identities;
mod lend;
mod lowering;
mod names;
mod places;
mod positions;
mod proof;
mod remaining;
mod sites;
mod sizes;
mod statements;
mod tidy;
mod tiles;

pub use callees::{fallible, reached};
pub use explicit::{Problem, Rule, check};
pub use lend::lend;
pub use remaining::Remaining;
pub(crate) use sizes::{sizes, wide};

use bessemer_ir::visit::{VisitMut, walk_block_mut};
use bessemer_ir::{Block, Fault, Module, Role, Span, StmtKind};
use thiserror::Error;

use bessemer_ir::used;
use callees::callee;
use explicit::verified;
use remaining::Doubted;
use statements::{Before, Explicit};

/// Remaining checks.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// Checks in each function itself, without its callees, in the order of
    /// [`Module::functions`](bessemer_ir::Module::functions).
    pub functions: Vec<Vec<Remaining>>,
    /// Spans of each function's checks that the analysis proved and the verifier did not. These checks are kept.
    pub doubted: Vec<Vec<Span>>,
}

/// Errors of making a module explicit.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Error {
    /// An infallible entry point or an external function may fault.
    #[error(
        "`{entry}` {claim}: in `{function}`, {fault:?}: {}",
        .check.reason
    )]
    Fallible {
        /// Entry point, or external function.
        entry: String,
        /// The claim, as text.
        claim: &'static str,
        /// Function with the check: the entry point itself or a callee.
        function: String,
        /// Fault of the check, for the message.
        fault: Fault,
        /// The check.
        check: Remaining,
    },
    /// The passes violate their postcondition, which is a bug of the compiler.
    #[error("error of the tool: {0}")]
    Tool(#[from] Problem),
}

/// Makes a valid module explicit, and lists the remaining checks.
///
/// # Errors
///
/// For each remaining check in an entry point that is declared infallible, or in its callees.
pub fn explicit(module: Module) -> Result<(Module, Report), Vec<Error>> {
    explicit_with(module, Choices::default())
}

/// Choices that change the explicit form of a module, and not its meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choices {
    /// True if proved checks stay in the module and report [`Fault::LeftOut`].
    pub keep: bool,
    /// True if passes of a loop run at once where they share their loads.
    pub tiles: bool,
}

impl Choices {
    /// The default, with the proved checks.
    pub const KEPT: Choices = Choices { keep: true, tiles: true };
}

impl Default for Choices {
    fn default() -> Choices {
        Choices { keep: false, tiles: true }
    }
}

/// Makes a module explicit, by these choices.
///
/// # Errors
/// As [`explicit`].
pub fn explicit_with(module: Module, choices: Choices) -> Result<(Module, Report), Vec<Error>> {
    let mut report = Report::default();
    let (mut callees, mut results, mut shown) = (Vec::new(), Vec::new(), Vec::new());
    let (mut functions, mut kept) = (Vec::new(), Vec::new());
    for function in &module.functions {
        let mut doubted = Doubted::default();
        let before = Before { callees: &callees, results: &results };
        let Explicit { function: mut done, remaining, results: returned } = loop {
            let done = statements::function(&module, before, function, &doubted, false);
            let (open, returns) = verified(&module, &done.function, &shown);
            // The first alone: behind its check, others may not be open any more.
            match open.into_iter().find(|site| !doubted.contains(&site.span)) {
                Some(first) => {
                    used::Rule::Doubted.used();
                    doubted.insert(first.span)
                }
                None => {
                    shown.push(returns);
                    break done;
                }
            };
        };
        if choices.keep {
            let kept_all = statements::function(&module, before, function, &doubted, true);
            kept.push(kept_all.function);
        }
        Proved.block(&mut done.body);
        if choices.tiles
            && let Some(tiled) = tiles::tiled(&module, &callees, &done)
            && verified(&module, &tiled, &shown).0.is_empty()
        {
            done = tiled;
        }
        callees.push(callee(&done, &callees));
        results.push(returned);
        functions.push(done);
        report.functions.push(remaining);
        report.doubted.push(doubted.into_iter().collect());
    }
    let module = Module { functions, ..module };
    let mut errors: Vec<Error> = check(&module).into_iter().map(Error::from).collect();
    errors.extend(broken_claims(&module, &report));
    if !errors.is_empty() {
        return Err(errors);
    }
    let mut module = if choices.keep { Module { functions: kept, ..module } } else { module };
    identities::name(&mut module);
    Ok((module, report))
}

/// Removes the author's checks that were proved.
struct Proved;

impl VisitMut for Proved {
    fn block(&mut self, block: &mut Block) {
        block.0.retain(|stmt| !matches!(stmt.kind, StmtKind::Check { fault: Fault::LeftOut, .. }));
        walk_block_mut(self, block);
    }
}

/// Message about an external function that may fault: its C has no status.
pub const STAND_IN: &str = "is external, and its stand-in may fault";

/// Returns an error for each check that an infallible entry point can reach.
fn broken_claims(module: &Module, report: &Report) -> Vec<Error> {
    let mut errors = Vec::new();
    for (index, entry) in module.functions.iter().enumerate() {
        let external = entry.attributes.external.is_some();
        if entry.role != (Role::Entry { infallible: true }) && !external {
            continue;
        }
        for reached in reached(module, index) {
            let (function, checks) = (&module.functions[reached], &report.functions[reached]);
            errors.extend(checks.iter().map(|check| Error::Fallible {
                entry: entry.name.clone(),
                claim: if external { STAND_IN } else { "is not infallible" },
                function: function.name.clone(),
                fault: check.fault,
                check: check.clone(),
            }));
        }
    }
    errors
}
