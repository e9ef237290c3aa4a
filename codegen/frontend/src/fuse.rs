//! Substitutes temporaries into the expressions that read them: the one place that reasons about evaluation order.
//!
//! Lowering holds an operand in a local wherever a statement may come between the operand and its reader. Here the
//! local is removed again if nobody can observe it: no statement in between writes what the operand reads, reads what
//! it writes, or ends the function where either is visible.
//!
//! Invariants: at each end of the function each place has the same value, and the same fault comes first. The time is
//! linear: one walk from the last statement to the first decides, knowing the next access to each local; one walk
//! from the first to the last substitutes.
//!
//! Must not know: why lowering made a local; the tree; C, which does not order operands (the passes take care of
//! that).

mod checks;
mod decide;
mod joined;
mod known;
mod put;

use bessemer_ir::{Block, Function, Local, LocalId, Module};
use decide::decided;
pub(crate) use joined::{Before, joined, may_go};

/// Substitutes those temporaries for which `made` holds that are only read and whose removal does not change the program. Removes checks
/// of indices that a use of the index repeats.
///
/// Other locals may get new handles; parameters keep theirs.
///
/// Precondition: the function is valid in `module`; `made` holds for no parameter, and no local is an alias of a place.
/// Postcondition: it is valid, and equivalent.
pub fn fuse(module: &Module, function: &mut Function, made: &dyn Fn(LocalId) -> bool) {
    let decided = decided(module, &function.locals, (made, &|_| false), &function.body);
    if decided.is_any() {
        put::put(&mut function.body, &decided, false);
        put::close_ranks(function, &decided.gone);
    }
}

/// Returns a loop's body as [`fuse`] will leave it, but with unchanged indices of statements and handles of locals.
pub(crate) fn view(
    module: &Module,
    locals: &[Local],
    made: &dyn Fn(LocalId) -> bool,
    body: &Block,
) -> Block {
    let (decided, mut body) = (decided(module, locals, (made, &|_| false), body), body.clone());
    if decided.is_any() {
        put::put(&mut body, &decided, true);
    }
    body
}
