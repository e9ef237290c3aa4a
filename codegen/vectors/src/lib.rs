//! Emits functions of the explicit IR as Rust that computes eight runs at once, with the types of `bessemer-lanes`.
//!
//! A value is a vector with the value of each run, its *lanes*. A branch is executed for the lanes that take it: every
//! write has the mask of its lanes, and a branch that no lane takes is skipped. Each lane has the bits of a run alone, since each
//! operation is the IR's.
//!
//! A number that is equal in all lanes because of its form, such as the counter of a loop with literal bounds, is an `i64` of Rust;
//! see [`uniform`].
//!
//! Invariant: the emitted code does not panic, also in lanes without a meaning. Must not know: C, proofs, the author's tree.

mod body;
mod calls;
mod error;
mod expr;
mod names;
mod number;
mod place;
mod routine;
mod types;
mod uniform;

use std::collections::BTreeSet;
use std::fmt::Write as _;

use bessemer_ir::visit::Walk;
use bessemer_ir::{ExprKind, FunctionId, Module};

pub use error::Error;
use names::Names;

/// Head of the emitted text.
const HEAD: &str = "\
// Written by Bessemer. Each number is a vector with the values of eight runs.

use bessemer_lanes::{self as lanes, Byte, Lanes, Mask, Real, Single, Whole};
";

/// Emits entry points of a module of explicit IR, and all that they need.
///
/// # Errors
///
/// A function has a check that may fail, or a construct that lanes do not have.
pub fn emit(module: &Module, entries: &[FunctionId]) -> Result<String, Error> {
    let reached = reached(module, entries);
    let names = Names::new(module);
    let mut functions = String::new();
    for id in &reached {
        functions.push_str(&body::function(module, &names, *id)?);
    }
    let used = types::used(module, &reached);
    let mut out = HEAD.to_owned();
    types::definitions(module, &names, &used, &mut out)?;
    _ = write!(out, "{functions}");
    Ok(out)
}

/// Returns the functions that entry points call, and themselves, callees first.
fn reached(module: &Module, entries: &[FunctionId]) -> BTreeSet<FunctionId> {
    let mut found: BTreeSet<FunctionId> = entries.iter().copied().collect();
    // Callees have smaller indices.
    for index in (0..module.functions.len()).rev() {
        let id = FunctionId(index as u32);
        if !found.contains(&id) {
            continue;
        }
        module.functions[index].body.any_expr(|expr| {
            if let ExprKind::Call(callee, _) = &expr.kind {
                found.insert(*callee);
            }
            false
        });
    }
    found
}
