//! Order of evaluation: what has to be computed before what comes after it.
//!
//! An expression of the IR is evaluated where it stands, and the statements that a later operand needs
//! stand before the whole: what came earlier and could change by them goes into a local first.

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
    /// The statements since `mark`, taken out; what comes before them can still be emitted.
    pub(super) fn later(&mut self, mark: usize) -> Vec<Stmt> {
        self.out.split_off(mark)
    }

    /// What `lower` gives, and the statements that it emits, which are not emitted here.
    pub(super) fn apart<T>(
        &mut self,
        lower: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<(T, Vec<Stmt>)> {
        let outer = std::mem::take(&mut self.out);
        let done = lower(self);
        let inner = std::mem::replace(&mut self.out, outer);
        Ok((done?, inner))
    }

    /// Lowers what comes behind something; `settle` computes before it what its statements could change.
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

    /// Computes the indices of `place` now that the statements to come could change.
    pub(super) fn settle_place(&mut self, place: &mut Place, later: &[Stmt]) {
        self.settle_all(indices_mut(place).map(|index| (index, words::INDEX)), later);
    }

    /// Computes now what of the arguments so far the statements to come could change.
    pub(super) fn settle_arguments(&mut self, passed: &mut [Argument], later: &[Stmt]) {
        let mut values = Vec::new();
        for argument in passed {
            match value_of(argument) {
                // A slice is never a local. What it shows stays while it is borrowed; where it begins may not.
                Ok(Expr { kind: ExprKind::Load(place), ty: Type::Slice(_), .. }) | Err(place) => {
                    values.extend(indices_mut(place).map(|index| (index, words::INDEX)));
                }
                Ok(value) => values.push((value, words::ARGUMENT)),
            }
        }
        self.settle_all(values, later);
    }

    /// Computes the values so far, in their order, before the statements to come.
    pub(super) fn settle_all<'e>(
        &mut self,
        values: impl IntoIterator<Item = (&'e mut Expr, &'e str)>,
        later: &[Stmt],
    ) {
        if !later.is_empty() {
            values.into_iter().for_each(|(value, role)| self.atomize(role, value));
        }
    }

    /// Returns an atom: a literal, a constant, or a local that is assigned once, into which the value goes. Where nothing would
    /// have changed the value, [`fuse`](crate::fuse) puts it back.
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

    /// Returns the place of a value that goes into a local which is assigned once.
    pub(super) fn atom_place(&mut self, role: &str, value: Expr) -> Place {
        let place = self.temporary_place(role, value);
        self.atoms.insert(place.root);
        place
    }

    fn atomize(&mut self, role: &str, value: &mut Expr) {
        *value = self.atom(role, value.clone());
    }

    /// Makes a local the author's, who may name it and write it.
    pub(super) fn release(&mut self, local: LocalId) -> bool {
        self.atoms.remove(&local);
        self.held.remove(&local)
    }

    /// Computes now the indices that lead to what is lent to a call whose result refers to that, and what comes before them.
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

    /// Computes values that will stand in another order now, one after the other.
    pub(super) fn keep_order(&mut self, values: &mut [Expr]) {
        values.iter_mut().for_each(|value| self.atomize(words::OPERAND, value));
    }

    /// Makes a place one that stays the same: its indices are computed and checked now.
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

    /// Computes now the indices of `place`.
    pub(super) fn keep_moving(&mut self, place: &mut Place) {
        indices_mut(place).for_each(|index| self.atomize(words::INDEX, index));
    }

    /// Computes now the indices of `place` that are to be kept.
    pub(super) fn keep_indices(&mut self, place: &mut Place, keep: impl Fn(&Expr) -> bool) {
        place.steps.iter_mut().for_each(|step| self.keep_indices_of(step, &keep));
    }

    /// The same of one step.
    pub(super) fn keep_indices_of(&mut self, step: &mut Step, keep: impl Fn(&Expr) -> bool) {
        for index in step.indices_mut() {
            if keep(index) {
                *index = self.temporary(words::INDEX, index.clone());
            }
        }
    }
}

/// Whether `value` is the same before and after `later`, and its faults come as they would.
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

/// Whether a statement does nothing but compute what can be had without effect or fault.
fn is_quiet(stmt: &Stmt) -> bool {
    match &stmt.kind {
        StmtKind::Let { value, .. } => value.as_ref().is_none_or(is_free),
        StmtKind::Expr(value) => is_free(value),
        _ => false,
    }
}

/// Whether a statement writes a part of a local that an expression reads.
fn writes_what_is_read(stmt: &Stmt, expr: &Expr) -> bool {
    stmt.any_place(|place, access| access != Access::Read && effects::mentions(expr, place.root))
}

/// Whether an expression writes anything.
pub(super) fn has_effect(expr: &Expr) -> bool {
    !effects::lent(expr).is_empty()
}

/// Whether a value may be computed before or after others: it writes nothing, and cannot fault. A
/// call may, whatever it is.
pub(super) fn is_free(expr: &Expr) -> bool {
    is_quiet_but_for(expr, |place| place.steps.iter().all(is_fixed))
}

/// Whether nothing in an expression writes, calls or faults, save for loads that `allowed` judges.
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

/// The indices that lead to a place.
pub(super) fn indices(place: &Place) -> impl Iterator<Item = &Expr> {
    place.steps.iter().flat_map(Step::indices)
}

fn indices_mut(place: &mut Place) -> impl Iterator<Item = &mut Expr> {
    place.steps.iter_mut().flat_map(Step::indices_mut)
}

/// The value of an argument that is not lent.
pub(super) fn value_of(argument: &mut Argument) -> Result<&mut Expr, &mut Place> {
    match argument {
        Argument::Value(value) | Argument::Ref(value) => Ok(value),
        Argument::RefMut(place) => Err(place),
    }
}

/// Whether a value may be written more than once: it is a literal, or lies where only fields lead.
pub(super) fn is_light(value: &Expr) -> bool {
    let fields = |place: &Place| place.steps.iter().all(|step| matches!(step, Step::Field(_)));
    value.is_literal() || matches!(&value.kind, ExprKind::Load(place) if fields(place))
}

/// Whether a step never depends on a value that is computed.
pub(super) fn is_fixed(step: &Step) -> bool {
    step.indices().all(Expr::is_literal)
}
