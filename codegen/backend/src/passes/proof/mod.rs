//! Verifier of F3: no operation of explicit IR faults by itself.
//!
//! It shares neither facts nor conditions nor rules with the analysis that removed the checks. It reasons about
//! **values**, not places. Each computed value is a *linear form* over *symbols*, such as `3 + 2 a - b`. A symbol is
//! one number in one execution, and never changes, so facts about symbols need not be dropped; a write only changes
//! which value a place holds.
//!
//! A [`Knowledge`](knowledge::Knowledge) means: in every execution at this point, each symbol is within its bounds,
//! each form in `forms` is at least 0, and one alternative of each clause is true. A goal `form >= 0` is proved by
//! arithmetic: by the bounds of its symbols after subtracting forms that are known to be at least 0; or from each
//! alternative of a clause.
//!
//! The condition of an operation is stated in exact numbers ([`values`]): a sum is within its type, an index is at
//! least 0 and less than the length. A loop ([`walk`]) is analysed twice: bounds and [`orders`] are *guessed* from a pass, and kept
//! if a pass that begins with them ends with them. The result of a call is within its function's summary, which is
//! known since callees precede callers; nothing is known of an external function's result.
//!
//! Must not know: which checks could have been removed, `analysis`, `faults`.

mod facts;
mod floats;
mod knowledge;
mod limits;
mod linear;
mod moved;
mod operations;
mod orders;
mod persistent;
mod returns;
mod tracked;
mod values;
mod walk;
pub(super) mod written;

use bessemer_ir::{Function, Module};

use super::sites::Site;

pub(super) use returns::Returns;

/// Returns the operations of a function that may fault according to this proof, and its summary. `shown` are the
/// summaries of the functions before it.
pub(super) fn open(
    module: &Module,
    function: &Function,
    shown: &[Returns],
) -> (Vec<Site>, Returns) {
    walk::Walk::new(module, function, shown).run()
}

/// Returns the least and greatest number assigned to each local of a function, at its declaration or as a whole; none
/// if there is none.
pub(super) fn held(module: &Module, function: &Function) -> Vec<Option<(i128, i128)>> {
    walk::Walk::new(module, function, &[]).held()
}
