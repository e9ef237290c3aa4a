//! Leaves out what the facts decide: operands of a condition, and the assignment of a word that its place has.
//!
//! Meaning: where the statement begins, an operand that is left out of `&&` is true, and one of `||` is false; a place
//! that is not assigned has the value. Each is a [`Fault::LeftOut`] check, so the [verifier](super::proof) proves it
//! again, and what it doubts stays. A condition that is decided as a whole stays, too: it is the author's branch.
//!
//! Invariant: a check that is kept reads no field of a [`Choice`](Form::Choice) that may not be selected there. The operand
//! was behind a test of the variant, and the check is not.

use bessemer_ir::visit::Walk;
use bessemer_ir::{
    CompareOp, Expr, ExprKind, Fault, Form, Intrinsic, LogicOp, Place, Scalar, Span, Step,
    StmtKind, Struct, Type, UnaryOp,
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
        let condition = is_word(place.load(), word, value.span);
        self.is_decided(condition, place.span)
    }

    /// Returns true if the facts prove that each choice on the way to a place selects the field that leads there.
    fn is_selected(&self, place: &Place) -> bool {
        let ty = self.function.locals[place.root.index()].ty.clone();
        let mut at = Place { ty, steps: Vec::new(), ..place.clone() };
        for step in &place.steps {
            if let (Type::Struct(id), Step::Field(field @ 1..)) = (&at.ty, step)
                && let Struct { form: Form::Choice(chosen), fields, .. } =
                    &self.module.structs[id.index()]
            {
                let (mut first, ty) = (at.clone(), fields[0].ty.clone());
                first.steps.push(Step::Field(0));
                first.ty = ty;
                let words = (0_u64..).zip(chosen).filter(|it| *it.1 == Some(*field));
                let is_word = |(word, _)| is_word(first.load(), word, place.span);
                if !words.map(is_word).any(|condition| self.facts.proves(&condition)) {
                    return false;
                }
            }
            let Some(ty) = self.module.step_type(&at.ty, step) else { return false };
            at.ty = ty;
            at.steps.push(step.clone());
        }
        true
    }

    fn is_decided(&mut self, condition: Expr, span: Span) -> bool {
        if !is_plain(&condition) || self.doubts(span) || !self.facts.proves(&condition) {
            return false;
        }
        if condition.any_place(|place, _| !self.is_selected(place)) {
            return false;
        }
        self.emit(StmtKind::Check { condition, fault: Fault::LeftOut }, span);
        true
    }
}

/// Returns the condition that a value is a word.
fn is_word(value: Expr, word: u64, span: Span) -> Expr {
    match &value.ty {
        Type::Scalar(Scalar::Bool) if word == 0 => value.negated(),
        Type::Scalar(Scalar::Bool) => value,
        ty => {
            let word = Expr::literal(word, ty.clone(), span);
            let kind = ExprKind::Compare(CompareOp::Eq, Box::new(value), Box::new(word));
            Expr { kind, ty: Type::BOOL, span }
        }
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
