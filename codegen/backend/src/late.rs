//! Finds the parameters that a function reads only before it writes its result.
//!
//! A caller may store such a result over the argument itself: `x = f(&x)` needs no copy. The function ends with one
//! `return`, whose value is made of other places, or is a local that was: before it is made, nothing is in the caller's
//! memory for the result, since no other local and no part lives there ([`crate::built`]). An element of the result may be
//! the argument's element at the same position, which the caller has there already.
//!
//! Only for functions that cannot fault. Invariant: in doubt, the parameter is read late. Must not know: the C text.

use bessemer_ir::visit::Walk as _;
use bessemer_ir::{Expr, ExprKind, Function, LocalId, Mode, Step, Stmt, StmtKind, Type};

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
    let stmts = function.body.0.as_slice();
    let last = stmts.last().map(|stmt| &stmt.kind);
    let (1, Some(StmtKind::Return(Some(value))), false) = (returns, last, fallible) else {
        return none;
    };
    // `value` makes the result; the statements of `rest` follow it.
    let (value, rest) = match &value.kind {
        ExprKind::Load(place) if place.steps.is_empty() => {
            let declared = stmts.iter().enumerate().find_map(|(at, stmt)| match &stmt.kind {
                StmtKind::Let { local, value: Some(value) } if *local == place.root => {
                    Some((value, &stmts[at + 1..]))
                }
                _ => None,
            });
            match declared {
                Some(declared) => declared,
                None => return none,
            }
        }
        _ => (value, &[][..]),
    };
    let is_made = matches!(
        value.kind,
        ExprKind::Call(..) | ExprKind::Routine(..) | ExprKind::Matrix(_) | ExprKind::Splat(_)
    );
    if !is_made || function.kernel.is_some() || function.attributes.external.is_some() {
        return none;
    }
    let early = |parameter: &u32| {
        let parameter = LocalId(*parameter);
        let reached = names_of(function, parameter);
        let is_read = |expr: &Expr| expr.any_place(|place, _| reached.contains(&place.root));
        let is_safe = match &value.kind {
            ExprKind::Matrix(items) if function.local(parameter).ty == value.ty => {
                let mut items = items.iter().enumerate();
                items.all(|(at, item)| !is_read(item) || is_own(item, parameter, at, &value.ty))
            }
            _ => !is_read(value),
        };
        let is_read_later = |stmt: &Stmt| stmt.any_place(|place, _| reached.contains(&place.root));
        is_safe && !rest.iter().any(is_read_later)
    };
    Early((0..function.params.min(64)).filter(early).fold(0, |bits, it| bits | (1 << it)))
}

/// Returns true for the element of a matrix at this position, by columns.
fn is_own(item: &Expr, matrix: LocalId, at: usize, ty: &Type) -> bool {
    let (ExprKind::Load(place), Type::Matrix { rows, .. }) = (&item.kind, ty) else { return false };
    let [Step::Element(row, column)] = place.steps.as_slice() else { return false };
    let (ExprKind::Literal(row), ExprKind::Literal(column)) = (&row.kind, &column.kind) else {
        return false;
    };
    place.root == matrix && row + column * u64::from(*rows) == at as u64
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
