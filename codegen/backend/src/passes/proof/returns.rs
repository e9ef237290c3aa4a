//! Function summaries of the verifier: bounds of the numbers in a result, and true if equal calls give equal results.
//!
//! Meaning: in every execution of the function that returns, for any arguments, each listed number is within its
//! bounds. A function whose body does not run lists nothing: an external function belongs to the firmware, and a
//! kernel has no body. Functions that `math.h` may replace (`c/library.rs`) return floats, which are not listed.
//!
//! A function is steady if it does not call the firmware, directly or indirectly: a second call with the same
//! arguments has the same result if nothing was written in between.

use std::collections::BTreeMap;

use bessemer_ir::visit::Walk as _;
use bessemer_ir::{ExprKind, Function, Type};

use super::knowledge::Bounds;

/// Bounds of the numbers in a result, each with the fields that lead to it. A `bool` is 1 or 0.
pub(super) type Numbers = BTreeMap<Vec<u32>, Bounds>;

/// Summary of a function.
#[derive(Clone, Debug, Default)]
pub struct Returns {
    pub(super) numbers: Numbers,
    pub(super) steady: bool,
    /// True if each execution ends in a fault.
    pub(super) never: bool,
}

impl Returns {
    /// Returns the summary of a function with these returned numbers; `shown` are the summaries before it.
    pub(super) fn of(function: &Function, numbers: Option<Numbers>, shown: &[Returns]) -> Returns {
        let own = function.attributes.external.is_none();
        let unsteady = |id: usize| !shown.get(id).is_some_and(|it| it.steady);
        let steady = own
            && !function.body.any_expr(
                |expr| matches!(expr.kind, ExprKind::Call(id, _) if unsteady(id.index())),
            );
        let whole = own && function.kernel.is_none() && function.result != Type::Unit;
        let never = whole && numbers.is_none();
        Returns { numbers: numbers.filter(|_| own).unwrap_or_default(), steady, never }
    }
}

/// Returns the bounds that include the earlier results and `now`.
pub(super) fn with(before: Option<Numbers>, now: Numbers) -> Numbers {
    let Some(mut before) = before else { return now };
    before.retain(|at, held| {
        let now = now.get(at);
        now.inspect(|now| *held = (held.0.min(now.0), held.1.max(now.1))).is_some()
    });
    before
}
