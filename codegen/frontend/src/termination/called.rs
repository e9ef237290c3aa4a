//! Functions that move a compared number: `values.remove(i)` decreases the length in every pass that calls it.
//!
//! Invariant: the function is followed as a pass of the loop is. It never returns before its end.

use bessemer_ir::effects::{self, overlap, same_place};
use bessemer_ir::visit::Walk;
use bessemer_ir::{Argument, Expr, ExprKind, FunctionId, LocalId, Place, Step, StmtKind};

use super::{Looked, Path, Side};

impl Looked<'_> {
    /// Follows the only call in an expression that may write a number. Returns true if the function moves it on every path;
    /// none if the function may move it back.
    pub(super) fn by_call(&self, side: Side, expr: &Expr, path: &Path) -> Option<bool> {
        let ours = self.place(side)?;
        let (function, arguments) = only_call(expr, ours)?;
        let function = self.module.functions.get(function.index())?;
        let mut theirs = arguments.iter().enumerate().filter_map(|(at, argument)| match argument {
            Argument::RefMut(place) if overlap(place, ours) => Some((at, place)),
            _ => None,
        });
        let (Some((at, passed)), None) = (theirs.next(), theirs.next()) else { return None };
        let (outer, inner) = ours.steps.split_at_checked(passed.steps.len())?;
        let is_part = same_place(&Place { steps: outer.to_vec(), ..ours.clone() }, passed)
            && inner.iter().all(|step| matches!(step, Step::Field(_)));
        let (last, before) = function.body.0.split_last().filter(|_| is_part)?;
        let body = match last.kind {
            StmtKind::Return(_) => before,
            _ => &function.body.0,
        };
        let returns = |kind: &StmtKind| matches!(kind, StmtKind::Return(_));
        if body.iter().any(|stmt| stmt.any_branch(&returns)) {
            return None;
        }
        let number =
            Place { root: LocalId(at as u32), steps: inner.to_vec(), ..ours.clone() }.load();
        // Nothing in the function is the other number.
        let other = Expr::literal_like(0, &number);
        let (low, high) = if side == 0 { (&number, &other) } else { (&other, &number) };
        let inside = Looked {
            module: self.module,
            low,
            high,
            inclusive: true,
            least: None,
            name: self.name,
            moving: vec![side],
        };
        let above = side == 1 && self.is_above(path);
        let begin = Path { written: [true, true], above, ..Path::default() };
        inside.block(body, begin, false).ok()?.map(|end| end.moved)
    }
}

/// Returns the only call in an expression that may write a place; none if it need not be evaluated.
fn only_call(expr: &Expr, place: &Place) -> Option<(FunctionId, Vec<Argument>)> {
    let (mut found, mut others) = (None, 0);
    expr.each_expr(|it| match &it.kind {
        ExprKind::Call(function, arguments)
            if effects::lent(it).iter().any(|it| overlap(it, place)) =>
        {
            others += usize::from(found.is_some());
            found = Some((*function, arguments.clone()));
        }
        ExprKind::Logic(..) => others += 1,
        _ => {}
    });
    found.filter(|_| others == 0)
}
