//! Comparison and weight of expressions, and hazards of assignments part by part.

use bessemer_ir::visit::{Access, VisitMut, Walk, walk_expr_mut, walk_place_mut};
use bessemer_ir::{Argument, Expr, ExprKind, Place, Span};

use crate::late::Early;
use crate::routines::is_element_wise;
use bessemer_ir::effects::{moves, overlap, reads};

/// Visitor that sets the spans of an expression.
struct Locate<F>(F);

impl<F: Fn(Span) -> Span> VisitMut for Locate<F> {
    fn expr(&mut self, expr: &mut Expr) {
        expr.span = (self.0)(expr.span);
        walk_expr_mut(self, expr);
    }
    fn place(&mut self, place: &mut Place, _: Access) {
        place.span = (self.0)(place.span);
        walk_place_mut(self, place);
    }
}

/// Returns the expression without its spans, for comparisons.
pub(crate) fn erased(expr: &Expr) -> Expr {
    let mut expr = expr.clone();
    Locate(|_| Span::default()).expr(&mut expr);
    expr
}

/// Returns the expression with `span` in place of missing spans.
pub(crate) fn located(mut expr: Expr, span: Span) -> Expr {
    let nowhere = Span::default();
    Locate(|it| if it == nowhere { span } else { it }).expr(&mut expr);
    expr
}

/// Returns the weight of an expression's text; one that is written twice should be light.
pub(crate) fn weight(expr: &Expr) -> usize {
    let mut weight = 0;
    expr.each_expr(|expr| {
        weight += match &expr.kind {
            ExprKind::Call(..) | ExprKind::Routine(..) => 100,
            ExprKind::Intrinsic(..) => 3,
            _ => 1,
        };
    });
    weight
}

/// Returns true if assigning `value` to `destination` part by part would overwrite what is still to be read.
/// `through_pointer` is there if the call returns its result, even a word, through a pointer.
pub(crate) fn disturbs(destination: &Place, value: &Expr, through_pointer: Option<Early>) -> bool {
    let written = std::slice::from_ref(destination);
    match &value.kind {
        ExprKind::Call(_, arguments) => through_pointer.is_some_and(|early| {
            let mut arguments = arguments.iter().enumerate();
            arguments.any(|(index, it)| !early.has(index) && lends(it, destination))
        }),
        _ if value.ty.is_word() => false,
        ExprKind::Load(place) => moves(place, written),
        ExprKind::Routine(routine, operands) if is_element_wise(*routine) => {
            operands.iter().any(|operand| {
                if operand.ty.is_word() {
                    reads(operand, written)
                } else {
                    disturbs(destination, operand, through_pointer)
                }
            })
        }
        _ => reads(value, written),
    }
}

/// Returns true if an index of `destination` reads `destination` itself, and C assigns `value` part by part. The index
/// would change after the first part: `nodes[nodes[0].next] = Node { next: 3, value }`.
pub(crate) fn moves_itself(destination: &Place, value: &Expr) -> bool {
    let at_once = value.ty.is_word() || matches!(value.kind, ExprKind::Call(..));
    !at_once && moves(destination, std::slice::from_ref(destination))
}

/// Returns true if a callee may read `destination` through `argument` while it runs.
fn lends(argument: &Argument, destination: &Place) -> bool {
    let written = std::slice::from_ref(destination);
    match argument {
        Argument::Value(value) => value.ty.is_aggregate() && reads(value, written),
        Argument::Ref(value) => reads(value, written),
        Argument::RefMut(place) => overlap(place, destination) || moves(place, written),
    }
}
