//! From valid IR to explicit IR: what the C back end can write down as it stands.
//!
//! Precondition: a valid module. Postcondition, verified by [`check`]:
//! * **F1** aggregates stand only as whole values, as operands that are places or constants (of products and
//!   element-wise routines also their transposes), and as trees of constructors or of element-wise routines,
//!   a column times a row among them; nothing is written where it is still read;
//! * **F2** calls stand only as whole values, for their effect, or as all that an `if` asks or asks the opposite of, unless they
//!   give a word, take words and shared references, and cannot fault;
//! * **F3** no operation faults by itself: a [`StmtKind::Check`](bessemer_ir::StmtKind::Check) stands
//!   before each that could not be proved;
//! * **F4** the bounds of a loop do not change while it runs, unless its
//!   body ends it.
//!
//! The meaning stays: the same results, and the same fault first. Absent: optimisation. No constant is
//! folded, nothing is reordered, no local of the author's is renamed, and code that is explicit already
//! comes out as it went in.

mod analysis;
mod callees;
mod checked;
mod declare;
mod explicit;
mod faults;
mod flatten;
mod lend;
mod lowering;
mod names;
mod persistent;
mod places;
mod positions;
mod proof;
mod remaining;
mod sites;
mod sizes;
mod statements;
mod tidy;

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

/// The checks that are left.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// Checks in each function itself, without its callees, in the order of
    /// [`Module::functions`](bessemer_ir::Module::functions).
    pub functions: Vec<Vec<Remaining>>,
    /// Checks of each function that the analysis proved and the verifier did not. They stay. Such a check stands.
    pub doubted: Vec<Vec<Span>>,
}

/// Why a module could not be made explicit.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Error {
    /// An entry point claims that it has no fault left, and has one.
    #[error(
        "`{entry}` {claim}: in `{function}`, {fault:?}: {}",
        .check.reason
    )]
    Fallible {
        /// The entry point, or the external function.
        entry: String,
        /// The claim that does not hold, in words.
        claim: &'static str,
        /// The function that holds the check, the entry itself or what it calls.
        function: String,
        /// The fault, once more, for the message.
        fault: Fault,
        /// The check.
        check: Remaining,
    },
    /// The passes broke their own promise: an error of the tool.
    #[error("error of the tool: {0}")]
    Tool(#[from] Problem),
}

/// Makes a valid module explicit, and lists the checks that are left.
///
/// # Errors
/// For each check that is left in an entry point (or in what it calls) that claims to be infallible.
pub fn explicit(module: Module) -> Result<(Module, Report), Vec<Error>> {
    explicit_with(module, false)
}

/// Makes a module explicit; with `keep`, proved checks stay in the module and report [`Fault::LeftOut`].
///
/// # Errors
/// As [`explicit`].
pub fn explicit_with(module: Module, keep: bool) -> Result<(Module, Report), Vec<Error>> {
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
        if keep {
            let kept_all = statements::function(&module, before, function, &doubted, true);
            kept.push(kept_all.function);
        }
        Proved.block(&mut done.body);
        callees.push(callee(&done, &callees));
        results.push(returned);
        functions.push(done);
        report.functions.push(remaining);
        report.doubted.push(doubted.into_iter().collect());
    }
    let module = Module { functions, ..module };
    let mut errors: Vec<Error> = check(&module).into_iter().map(Error::from).collect();
    errors.extend(broken_claims(&module, &report));
    match errors.is_empty() {
        true if keep => Ok((Module { functions: kept, ..module }, report)),
        true => Ok((module, report)),
        false => Err(errors),
    }
}

/// Removes the author's checks that were proved.
struct Proved;

impl VisitMut for Proved {
    fn block(&mut self, block: &mut Block) {
        block.0.retain(|stmt| !matches!(stmt.kind, StmtKind::Check { fault: Fault::LeftOut, .. }));
        walk_block_mut(self, block);
    }
}

/// An external function must not fault: its C has no status to tell of it.
pub const STAND_IN: &str = "is external, and its stand-in may fault";

/// An error for each check that an infallible entry point can reach.
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
