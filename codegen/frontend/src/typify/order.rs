//! Order of evaluation: what has to be computed before what comes after it.
//!
//! An expression of the IR is evaluated where it stands, and the statements that a later operand needs
//! stand before the whole: what came earlier and could change by them goes into a local first.

use std::collections::HashSet;

use bessemer_ir::visit::{Access, Walk};
use bessemer_ir::{
    Argument, CompareOp, Expr, ExprKind, Fault, Intrinsic, LocalId, Place, Scalar, Step, Stmt,
    StmtKind, Type,
};

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

    /// Computes `value` now if the statements to come could change it.
    pub(super) fn settle(&mut self, value: &mut Expr, role: &str, later: &[Stmt]) {
        self.settle_all([(value, role)], later);
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

    /// Computes now what of the values so far, in their order, the statements to come could change. What is computed now
    /// comes before the values that are not, and so is among what could change these.
    pub(super) fn settle_all<'e>(
        &mut self,
        values: impl IntoIterator<Item = (&'e mut Expr, &'e str)>,
        later: &[Stmt],
    ) {
        if !later.is_empty() {
            let values = values.into_iter().map(|(value, role)| (value, role, false));
            self.settle_those(values.collect(), later);
        }
    }

    /// Computes now the indices that lead to what is lent to a call whose result refers to that, as far as they may change.
    pub(super) fn settle_lent(&mut self, passed: &mut [Argument]) {
        let mut values = Vec::new();
        for argument in passed {
            match argument {
                Argument::Ref(Expr { kind: ExprKind::Load(place), .. })
                | Argument::RefMut(place) => {
                    for index in indices_mut(place) {
                        let moves = self.moves(index);
                        values.push((index, words::INDEX, moves));
                    }
                }
                Argument::Value(value) | Argument::Ref(value) => {
                    values.push((value, words::ARGUMENT, false));
                }
            }
        }
        self.settle_those(values, &[]);
    }

    /// Of values in their order, computes now those that have to be, and those that this or what comes later could change.
    fn settle_those(&mut self, mut moving: Vec<(&mut Expr, &str, bool)>, later: &[Stmt]) {
        let mut later = later.to_vec();
        for at in (0..moving.len()).rev() {
            let (value, _, has_to) = &moving[at];
            if !has_to && (later.is_empty() || is_settled(value, &later)) {
                moving.remove(at);
            } else {
                let (kind, span) = (StmtKind::Expr((**value).clone()), value.span);
                later.push(Stmt::new(kind, span));
            }
        }
        for (value, role, _) in moving {
            *value = self.temporary(role, value.clone());
        }
    }

    /// Whether an index may become another: not one that is written out, or given once.
    fn moves(&self, index: &Expr) -> bool {
        match &index.kind {
            ExprKind::Literal(_) | ExprKind::Const(_) => false,
            ExprKind::Load(of) => {
                let known = |set: &HashSet<LocalId>| set.contains(&of.root);
                let stays =
                    known(&self.steady) || known(&self.held) || self.counters.contains(&of.root);
                !(of.steps.is_empty() && stays)
            }
            _ => true,
        }
    }

    /// Computes values that will stand in another order now, one after the other, where that would show.
    pub(super) fn keep_order(&mut self, values: &mut [Expr]) {
        let (mut first, mut shows) = (values.iter(), false);
        while let Some(one) = first.next() {
            shows |= first.as_slice().iter().any(|other| !may_change_places(one, other));
        }
        for value in values.iter_mut().filter(|value| shows && !value.is_literal()) {
            *value = self.temporary(words::OPERAND, value.clone());
        }
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

    /// Computes now the indices of `place` that something may change: not those that are written once.
    pub(super) fn keep_moving(&mut self, place: &mut Place) {
        for index in indices_mut(place) {
            if self.moves(index) {
                *index = self.temporary(words::INDEX, index.clone());
            }
        }
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

/// Whether it is the same, result and fault, if `value` is computed after `place`.
pub(super) fn may_follow(value: &Expr, place: &Place) -> bool {
    let simple = |place: &Place| indices(place).all(is_free);
    // An index out of bounds is the same fault, whichever of the two it is in.
    is_free(value) && !indices(place).any(has_effect)
        || is_quiet_but_for(value, simple) && simple(place)
}

/// Whether it is the same, result and fault, if `second` is computed before `first`.
pub(super) fn may_change_places(first: &Expr, second: &Expr) -> bool {
    let stays =
        |one: &Expr, other: &Expr| is_free(one) && !effects::reads(one, &effects::lent(other));
    stays(first, second) || stays(second, first)
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
