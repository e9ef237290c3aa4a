//! Leaves out what the facts decide: operands of a condition, and the assignment of a word that its place has.
//!
//! Meaning: where the statement begins, an operand that is left out of `&&` is true, and one of `||` is false; a place
//! that is not assigned has the value. Each is a [`Fault::LeftOut`] check, so the [verifier](super::proof) proves it
//! again, and what it doubts stays. A condition that is decided as a whole stays, too: it is the author's branch.

use bessemer_ir::visit::Walk;
use bessemer_ir::{
    CompareOp, Expr, ExprKind, Fault, Intrinsic, LogicOp, Place, Scalar, Span, Step, StmtKind,
    Type, UnaryOp,
};

use super::lowering::Lowering;

impl Lowering<'_> {
    /// Returns a condition without the operands that are decided before it is evaluated.
    pub(super) fn undecided(&mut self, condition: Expr) -> Expr {
        let Expr { kind, ty, span } = condition;
        let ExprKind::Logic(op, a, b) = kind else { return Expr { kind, ty, span } };
        let (a, b) = (self.undecided(*a), self.undecided(*b));
        if self.left_out(op, &a) {
            return b;
        }
        if self.left_out(op, &b) {
            return a;
        }
        Expr { kind: ExprKind::Logic(op, Box::new(a), Box::new(b)), ty, span }
    }

    /// Returns true if an operand changes nothing, and emits its check.
    fn left_out(&mut self, op: LogicOp, operand: &Expr) -> bool {
        let condition = match op {
            LogicOp::And => operand.clone(),
            LogicOp::Or => operand.clone().negated(),
        };
        self.is_decided(condition, operand.span)
    }

    /// Returns true if a place has the value already, and emits its check.
    pub(super) fn has(&mut self, place: &Place, value: &Expr) -> bool {
        let ExprKind::Literal(word) = value.kind else { return false };
        let own = place.load();
        let condition = match &value.ty {
            Type::Scalar(Scalar::Bool) if word == 0 => own.negated(),
            Type::Scalar(Scalar::Bool) => own,
            _ => {
                let kind = ExprKind::Compare(CompareOp::Eq, Box::new(own), Box::new(value.clone()));
                Expr { kind, ty: Type::BOOL, span: value.span }
            }
        };
        self.is_decided(condition, place.span)
    }

    fn is_decided(&mut self, condition: Expr, span: Span) -> bool {
        if !is_plain(&condition) || self.doubts(span) || !self.facts.proves(&condition) {
            return false;
        }
        self.emit(StmtKind::Check { condition, fault: Fault::LeftOut }, span);
        true
    }
}

/// Returns true if a condition compares words that are no floats, at places that fields lead to, and cannot fault.
fn is_plain(condition: &Expr) -> bool {
    let part = |expr: &Expr| match &expr.kind {
        ExprKind::Literal(_)
        | ExprKind::Const(_)
        | ExprKind::Cast(_)
        | ExprKind::Compare(..)
        | ExprKind::Logic(..)
        | ExprKind::Unary(UnaryOp::Not, _)
        | ExprKind::Intrinsic(Intrinsic::Min | Intrinsic::Max | Intrinsic::Variant, _) => {
            expr.ty.as_float().is_none()
        }
        ExprKind::Load(place) => {
            let fields = place.steps.iter().all(|step| matches!(step, Step::Field(_)));
            fields && expr.ty.is_word() && expr.ty.as_float().is_none()
        }
        _ => false,
    };
    !condition.any_expr(|expr| !part(expr))
}
