//! Finds the parameters that a function reads only before it writes its result.
//!
//! A caller may store such a result over the argument itself: `x = f(&x)` needs no copy. The function ends with one
//! `return`, whose value is made of other places; before it, nothing is in the caller's memory for the result, since
//! neither a local nor a part lives there ([`crate::built`]).
//!
//! Only for functions that cannot fault. Invariant: in doubt, the parameter is read late. Must not know: the C text.

use bessemer_ir::visit::Walk as _;
use bessemer_ir::{Expr, ExprKind, Function, LocalId, Mode, StmtKind};

/// Bits of a function's parameters, the first in the lowest; parameters beyond the 64th have none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Early(u64);

impl Early {
    /// Returns true if the parameter is read only before the result is written.
    pub(crate) fn has(self, parameter: usize) -> bool {
        parameter < 64 && self.0 & (1 << parameter) != 0
    }
}

/// Returns the parameters of a function that it reads only before it writes its result.
pub(crate) fn early(function: &Function, fallible: bool) -> Early {
    let none = Early::default();
    let mut returns = 0;
    function.body.each_stmt(|stmt| {
        returns += u32::from(matches!(stmt.kind, StmtKind::Return(_)));
    });
    let last = function.body.0.last().map(|stmt| &stmt.kind);
    let (1, Some(StmtKind::Return(Some(value))), false) = (returns, last, fallible) else {
        return none;
    };
    let is_made = matches!(
        value.kind,
        ExprKind::Call(..) | ExprKind::Routine(..) | ExprKind::Matrix(_) | ExprKind::Splat(_)
    );
    if !is_made || function.kernel.is_some() || function.attributes.external.is_some() {
        return none;
    }
    let early = |parameter: &u32| {
        let reached = names_of(function, LocalId(*parameter));
        !value.any_place(|place, _| reached.contains(&place.root))
    };
    Early((0..function.params.min(64)).filter(early).fold(0, |bits, it| bits | (1 << it)))
}

/// Returns a parameter, and the locals that may be names for a part of it.
fn names_of(function: &Function, parameter: LocalId) -> Vec<LocalId> {
    let mut names = vec![parameter];
    function.body.each_stmt(|stmt| {
        if let StmtKind::Let { local, value: Some(Expr { kind: ExprKind::Load(place), .. }) } =
            &stmt.kind
        {
            let of = function.local(*local);
            let names_it = !of.ty.is_word() || of.mode == Mode::RefMut;
            if names_it && names.contains(&place.root) {
                names.push(*local);
            }
        }
    });
    names
}
