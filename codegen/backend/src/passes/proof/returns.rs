//! Function summaries of the verifier: bounds of the numbers in a function's result, and whether two calls give the same.
//!
//! The meaning: in every execution of the function that returns, whatever its arguments, each number that is listed lies
//! within its bounds. A body that is not the one that runs lists nothing: an external function's, which the firmware brings,
//! and a kernel's, which is none. What `math.h` may represent (`c/library.rs`) gives floats, which are not listed.
//!
//! A function is steady if it calls nothing of the firmware's, at no remove: called again with the same arguments, it gives
//! the same while nothing is written.

use std::collections::BTreeMap;

use bessemer_ir::visit::Walk as _;
use bessemer_ir::{ExprKind, Function, Type};

use super::knowledge::Bounds;

/// Bounds of the numbers in a result, each with the fields that lead to it. A truth that is one or the other is 1 or 0.
pub(super) type Numbers = BTreeMap<Vec<u32>, Bounds>;

/// The summary of a function.
#[derive(Clone, Debug, Default)]
pub struct Returns {
    pub(super) numbers: Numbers,
    pub(super) steady: bool,
    /// True if each execution ends in a fault.
    pub(super) never: bool,
}

impl Returns {
    /// Returns the summary of a function that returns such numbers, with the summaries of those before it.
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

/// The bounds that hold both of the results seen before and of `now`.
pub(super) fn with(before: Option<Numbers>, now: Numbers) -> Numbers {
    let Some(mut before) = before else { return now };
    before.retain(|at, held| {
        let now = now.get(at);
        now.inspect(|now| *held = (held.0.min(now.0), held.1.max(now.1))).is_some()
    });
    before
}
