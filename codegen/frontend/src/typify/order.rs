//! Order of evaluation.
//!
//! The IR evaluates an expression at its place in a statement, and statements that a later operand needs come before
//! that statement. So earlier operands that these statements could change are first held in locals.

use bessemer_ir::visit::{Access, Walk};
use bessemer_ir::{
    Argument, CompareOp, Expr, ExprKind, Fault, Intrinsic, LocalId, Place, Scalar, Step, Stmt,
    StmtKind, Type,
};

use super::call::lent;
use super::lowering::Lowering;
use super::{Result, words};
use bessemer_ir::effects;

impl Lowering<'_, '_> {
    /// Removes and returns the statements since `mark`, so that others can be emitted before them.
    pub(super) fn later(&mut self, mark: usize) -> Vec<Stmt> {
        self.out.split_off(mark)
    }

    /// Returns the result of `lower` and the statements that it emits, without emitting them.
    pub(super) fn apart<T>(
        &mut self,
        lower: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<(T, Vec<Stmt>)> {
        let outer = std::mem::take(&mut self.out);
        let done = lower(self);
        let inner = std::mem::replace(&mut self.out, outer);
        Ok((done?, inner))
    }

    /// Lowers an operand with `lower`. Before its statements, `settle` holds the earlier values that they could
    /// change.
    pub(super) fn settling<T>(
        &mut self,
        lower: impl FnOnce(&mut Self) -> Result<T>,
        settle: impl FnOnce(&mut Self, &T, &[Stmt]),
    ) -> Result<T> {
        let mark = self.out.len();
        let done = lower(self)?;
        let later = self.later(mark);
        settle(self, &done, &later);
        self.out.extend(later);
        Ok(done)
    }

    /// Computes and checks the indices of `place` before the statements to come.
    pub(super) fn settle_place(&mut self, place: &mut Place, later: &[Stmt]) {
        if !later.is_empty() {
            self.fix(place);
        }
    }

    /// Computes the arguments so far, and checks their places, before the statements to come.
    pub(super) fn settle_arguments(&mut self, passed: &mut [Argument], later: &[Stmt]) {
        if later.is_empty() {
            return;
        }
        for argument in passed {
            match value_of(argument) {
                // A slice is never a local. What it shows stays while it is borrowed; where it begins may not.
                Ok(Expr { kind: ExprKind::Load(place), ty: Type::Slice(_), .. }) | Err(place) => {
                    self.fix(place);
                }
                Ok(value) => self.atomize(words::ARGUMENT, value),
            }
        }
    }

    /// Holds the values so far, in order, before later statements.
    pub(super) fn settle_all<'e>(
        &mut self,
        values: impl IntoIterator<Item = (&'e mut Expr, &'e str)>,
        later: &[Stmt],
    ) {
        if !later.is_empty() {
            values.into_iter().for_each(|(value, role)| self.atomize(role, value));
        }
    }

    /// Returns an atom for a value: a literal, a constant, or a local that is assigned once. If nothing would have
    /// changed the value, [`fuse`](crate::fuse) substitutes it again.
    pub(super) fn atom(&mut self, role: &str, value: Expr) -> Expr {
        let known = match &value.kind {
            ExprKind::Literal(_) | ExprKind::Const(_) => true,
            ExprKind::Load(place) => place.steps.is_empty() && self.atoms.contains(&place.root),
            _ => false,
        };
        // What is zero-sized is no value of the IR, and a slice is no local.
        if known || matches!(value.ty, Type::Unit | Type::Slice(_)) {
            return value;
        }
        self.atom_place(role, value).load()
    }

    /// Returns the place of a new local that holds a value and is assigned once.
    pub(super) fn atom_place(&mut self, role: &str, value: Expr) -> Place {
        let place = self.temporary_place(role, value);
        self.atoms.insert(place.root);
        place
    }

    fn atomize(&mut self, role: &str, value: &mut Expr) {
        *value = self.atom(role, value.clone());
    }

    /// Makes a temporary the author's: it may be renamed and written. Returns true if it was a temporary.
    pub(super) fn release(&mut self, local: LocalId) -> bool {
        self.atoms.remove(&local);
        self.held.remove(&local)
    }

    /// Holds the indices of the places that a call borrows, if its result refers to one of them, and all earlier
    /// arguments.
    pub(super) fn settle_lent(&mut self, passed: &mut [Argument]) {
        let places =
            |argument: &Argument| lent(argument).is_some_and(|(it, _)| !it.steps.is_empty());
        let count = passed.iter().rposition(places).map_or(0, |last| last + 1);
        for argument in &mut passed[..count] {
            match argument {
                Argument::Ref(Expr { kind: ExprKind::Load(place), .. })
                | Argument::RefMut(place) => self.keep_moving(place),
                Argument::Value(value) | Argument::Ref(value) => {
                    self.atomize(words::ARGUMENT, value);
                }
            }
        }
    }

    /// Holds values that later appear in another order, in their present order.
    pub(super) fn keep_order(&mut self, values: &mut [Expr]) {
        values.iter_mut().for_each(|value| self.atomize(words::OPERAND, value));
    }

    /// Makes a place independent of later writes: its indices are evaluated and checked now.
    pub(super) fn fix(&mut self, place: &mut Place) {
        self.keep_moving(place);
        // What is referred to was looked at where that was chosen.
        if self.stands(place.root) {
            return;
        }
        for (at, step) in place.steps.iter().enumerate() {
            let lengths = match (step, self.type_of(place.root, &place.steps[..at])) {
                (Step::Field(_), Type::Struct(_)) => Vec::new(),
                (Step::Index(_), Type::Array { len, .. }) => vec![len],
                (Step::Index(_), Type::Matrix { rows, cols, .. }) => vec![rows * cols],
                (Step::Element(..), Type::Matrix { rows, cols, .. }) => vec![rows, cols],
                // A slice has looked already.
                _ => return,
            };
            let moving = |(index, _): &(&Expr, u32)| !matches!(index.kind, ExprKind::Literal(_));
            for (index, len) in step.indices().zip(lengths).filter(moving) {
                let len = Expr::literal_like(u64::from(len), index);
                let condition = Expr::compare(CompareOp::Lt, index.clone(), len);
                self.emit(StmtKind::Check { condition, fault: Fault::Index }, index.span);
            }
        }
    }

    /// Holds the indices of `place`.
    pub(super) fn keep_moving(&mut self, place: &mut Place) {
        indices_mut(place).for_each(|index| self.atomize(words::INDEX, index));
    }

    /// Holds those indices of `place` for which `keep` is true.
    pub(super) fn keep_indices(&mut self, place: &mut Place, keep: impl Fn(&Expr) -> bool) {
        place.steps.iter_mut().for_each(|step| self.keep_indices_of(step, &keep));
    }

    /// Holds those indices of one step for which `keep` is true.
    pub(super) fn keep_indices_of(&mut self, step: &mut Step, keep: impl Fn(&Expr) -> bool) {
        for index in step.indices_mut() {
            if keep(index) {
                *index = self.temporary(words::INDEX, index.clone());
            }
        }
    }
}

/// Returns true if `later` neither changes `value` nor moves its faults.
pub(super) fn is_settled(value: &Expr, later: &[Stmt]) -> bool {
    if effects::calls(value) {
        return false;
    }
    let fixed = match &value.kind {
        ExprKind::Literal(_) | ExprKind::Const(_) => true,
        ExprKind::Load(place) => place.steps.iter().all(is_fixed),
        _ => false,
    };
    (fixed || later.iter().all(is_quiet))
        && !later.iter().any(|stmt| writes_what_is_read(stmt, value))
}

/// Returns true if a statement only computes a value without effect or fault.
fn is_quiet(stmt: &Stmt) -> bool {
    match &stmt.kind {
        StmtKind::Let { value, .. } => value.as_ref().is_none_or(is_free),
        StmtKind::Expr(value) => is_free(value),
        _ => false,
    }
}

/// Returns true if a statement writes a local that an expression reads.
fn writes_what_is_read(stmt: &Stmt, expr: &Expr) -> bool {
    stmt.any_place(|place, access| access != Access::Read && effects::mentions(expr, place.root))
}

/// Returns true if an expression writes anything.
pub(super) fn has_effect(expr: &Expr) -> bool {
    !effects::lent(expr).is_empty()
}

/// Returns true if a value may be evaluated earlier or later: it writes nothing, and cannot fault. A call may do
/// either.
pub(super) fn is_free(expr: &Expr) -> bool {
    is_quiet_but_for(expr, |place| place.steps.iter().all(is_fixed))
}

/// Returns true if an expression does not write, call or fault, except by loads that `allowed` judges.
fn is_quiet_but_for(expr: &Expr, allowed: impl Fn(&Place) -> bool) -> bool {
    !expr.any_expr(|expr| {
        let float = matches!(expr.ty, Type::Scalar(Scalar::Float(_) | Scalar::Bool));
        let quiet = match &expr.kind {
            ExprKind::Call(..) => false,
            ExprKind::Intrinsic(which, _) => float && *which != Intrinsic::Clamp,
            ExprKind::Unary(..) | ExprKind::Binary(..) => float,
            ExprKind::Load(place) => allowed(place),
            _ => true,
        };
        !quiet
    })
}

/// Returns the indices that lead to a place.
pub(super) fn indices(place: &Place) -> impl Iterator<Item = &Expr> {
    place.steps.iter().flat_map(Step::indices)
}

fn indices_mut(place: &mut Place) -> impl Iterator<Item = &mut Expr> {
    place.steps.iter_mut().flat_map(Step::indices_mut)
}

/// Returns the value of an argument, or the place of a mutable borrow.
pub(super) fn value_of(argument: &mut Argument) -> Result<&mut Expr, &mut Place> {
    match argument {
        Argument::Value(value) | Argument::Ref(value) => Ok(value),
        Argument::RefMut(place) => Err(place),
    }
}

/// Returns true if a value may be read more than once: it is a literal, or a place with fields only.
pub(super) fn is_light(value: &Expr) -> bool {
    let fields = |place: &Place| place.steps.iter().all(|step| matches!(step, Step::Field(_)));
    value.is_literal() || matches!(&value.kind, ExprKind::Load(place) if fields(place))
}

/// Returns true if a step has only literal indices.
pub(super) fn is_fixed(step: &Step) -> bool {
    step.indices().all(Expr::is_literal)
}
