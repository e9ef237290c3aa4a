//! The verifier of F3: that no operation of explicit IR faults by itself.
//!
//! It shares nothing with the analysis that left the checks out: no facts, no conditions, no rules. It looks at
//! **values**, not at places. Each value that is computed is a *linear form* over *symbols*, `3 + 2 a - b`, and a
//! symbol represents one number in one execution, for ever. So what is known of symbols never has to be forgotten; a
//! write changes only which value a place holds.
//!
//! The meaning of a [`Knowledge`](knowledge::Knowledge): in every execution that is at this point, each symbol lies
//! within its bounds, each form in `forms` is 0 or more, and one alternative of each clause is true.
//! A goal `form >= 0` is shown by arithmetic alone: bounds of its symbols, after forms that are known to be 0 or more
//! are subtracted; or from each alternative of a clause.
//!
//! The condition of an operation is stated in exact numbers ([`values`]): a sum lies within its type, an index is 0 or more
//! and less than the length. A loop ([`walk`]) is looked at twice: bounds are *guessed* from a pass, and kept if a pass
//! that begins with them ends with them. What a call gives lies within what its function, which precedes, was seen
//! to return; of an external one nothing is known.
//!
//! Must not know: which checks could have been left out, `analysis`, `faults`.

mod facts;
mod knowledge;
mod linear;
mod operations;
mod returns;
mod values;
mod walk;
pub(super) mod written;

use bessemer_ir::{Function, Module};

use super::sites::Site;

pub(super) use returns::Returns;

/// The operations of a function that may fault, as far as this shows, and what it returns. The functions before it return
/// what is `shown` of them.
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
