//! Order of evaluation.
//!
//! Operands, arguments and indices are held in locals where Rust evaluates them, and [`fuse`] substitutes them again.
//!
//! Invariant: the indices that lead to a place are atoms, and are checked where Rust evaluates the place.

use std::cell::RefCell;
use std::collections::HashSet;

use bessemer_ir::visit::{Access, Walk};
use bessemer_ir::{
    CompareOp, Expr, ExprKind, Fault, Form, Intrinsic, LocalId, Place, Routine, Scalar, Step, Stmt,
    StmtKind, Type,
};

use super::borrowed::Lenders;
use super::lowering::Lowering;
use super::value::Named;
use super::{Result, words};
use crate::fuse;
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

    /// Substitutes the statements before a value into it, if [`fuse`](crate::fuse) leaves none of them. Later code also uses
    /// `named`.
    pub(super) fn joined(
        &self,
        value: Expr,
        stmts: Vec<Stmt>,
        named: &[Named],
    ) -> (Expr, Vec<Stmt>) {
        if stmts.is_empty() || !read_later(&self.lenders, &stmts, named).is_empty() {
            return (value, stmts);
        }
        match fuse::alone(&self.cx.module, &self.locals, &self.atoms, &stmts, &value) {
            Some(value) => (value, Vec::new()),
            None => (value, stmts),
        }
    }

    /// Substitutes the statements since `mark` into a place that is read and then written, if none is left. A place that calls
    /// is evaluated once.
    pub(super) fn joined_place(&mut self, mark: usize, place: Place) -> Place {
        let other = self.out[mark..].iter().rposition(|stmt| !fuse::may_go(stmt, &self.atoms));
        let stmts = self.later(other.map_or(mark, |at| mark + at + 1));
        match self.joined(place.load(), stmts.clone(), &[]) {
            (Expr { kind: ExprKind::Load(joined), .. }, left)
                if left.is_empty() && !effects::calls(&joined.load()) =>
            {
                joined
            }
            _ => {
                self.out.extend(stmts);
                place
            }
        }
    }

    /// Returns an atom for a value: a literal, a constant, or a local that is assigned once. If nothing would have
    /// changed the value, [`fuse`](crate::fuse) substitutes it again.
    pub(super) fn atom(&mut self, role: &str, value: Expr) -> Expr {
        self.atomic(role, value).unwrap_or_else(|value| self.atom_place(role, value).load())
    }

    /// Returns the value if its form is needed and its parts can be atoms; otherwise the value as an error.
    pub(super) fn atomic(&mut self, role: &str, value: Expr) -> Result<Expr, Expr> {
        // A zero-sized value is no value of the IR, and a slice is no local.
        if self.is_atom(&value) || matches!(value.ty, Type::Unit | Type::Slice(_)) {
            return Ok(value);
        }
        match (value.kind, &value.ty) {
            (ExprKind::Struct(parts), Type::Struct(id))
                if matches!(self.cx.module.structs[id.index()].form, Form::Choice(_)) =>
            {
                let parts = parts.into_iter().map(|part| self.atom(role, part)).collect();
                Ok(Expr { kind: ExprKind::Struct(parts), ..value })
            }
            // A product reads a factor untransposed.
            (ExprKind::Routine(Routine::Transpose, of), _) => {
                let of = of.into_iter().map(|of| self.atom(role, of)).collect();
                Ok(Expr { kind: ExprKind::Routine(Routine::Transpose, of), ..value })
            }
            (kind, _) => Err(Expr { kind, ..value }),
        }
    }

    fn is_atom(&self, value: &Expr) -> bool {
        match &value.kind {
            ExprKind::Literal(_) | ExprKind::Const(_) => true,
            ExprKind::Load(place) => {
                let once = self.atoms.contains(&place.root) || self.steady.contains(&place.root);
                place.steps.is_empty() && once
            }
            ExprKind::Struct(parts) | ExprKind::Array(parts) => {
                parts.iter().all(|part| self.is_atom(part))
            }
            _ => false,
        }
    }

    /// Returns the place of a new local that holds a value and is assigned once.
    pub(super) fn atom_place(&mut self, role: &str, value: Expr) -> Place {
        let place = self.assigned(role, value);
        self.atoms.insert(place.root);
        place
    }

    /// Makes a temporary the author's: it may be renamed and written. Returns true if it was a temporary.
    pub(super) fn release(&mut self, local: LocalId) -> bool {
        self.atoms.remove(&local);
        self.held.remove(&local)
    }

    /// Evaluates and checks the indices of the last step to a place, as Rust does where the step is written. So no later
    /// write moves the place.
    pub(super) fn indexed(&mut self, mut place: Place) -> Place {
        let Some(mut last) = place.steps.pop() else { return place };
        for index in last.indices_mut() {
            *index = self.atom(words::INDEX, index.clone());
        }
        let lengths = match self.type_of(place.root, &place.steps) {
            // The place of a reference was checked where the reference was chosen.
            _ if self.stands(place.root) => Vec::new(),
            Type::Array { len, .. } => vec![len],
            Type::Matrix { rows, cols, .. } => match last {
                Step::Element(..) => vec![rows, cols],
                _ => vec![rows * cols],
            },
            // A slice has looked already.
            _ => Vec::new(),
        };
        let moving = |(index, _): &(&Expr, u32)| !matches!(index.kind, ExprKind::Literal(_));
        for (index, len) in last.indices().zip(lengths).filter(moving) {
            let len = Expr::literal_like(u64::from(len), index);
            let condition = Expr::compare(CompareOp::Lt, index.clone(), len);
            self.emit(StmtKind::Check { condition, fault: Fault::Index }, index.span);
        }
        place.steps.push(last);
        place
    }
}

/// Returns the locals that statements declare and that `named` or a lender mentions.
pub(super) fn read_later(lenders: &Lenders, stmts: &[Stmt], named: &[Named]) -> HashSet<LocalId> {
    let declared = stmts.iter().filter_map(|stmt| match stmt.kind {
        StmtKind::Let { local, .. } => Some(local),
        _ => None,
    });
    let declared: HashSet<LocalId> = declared.collect();
    let found = RefCell::new(HashSet::new());
    let note = |local: LocalId| {
        if declared.contains(&local) {
            found.borrow_mut().insert(local);
        }
        false
    };
    if !declared.is_empty() {
        named.iter().for_each(|named| _ = named.stands.any_local(&note));
        lenders.mention(&note);
    }
    found.into_inner()
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

/// Returns true if a value may be read more than once: it is a literal, or a place with fields only.
pub(super) fn is_light(value: &Expr) -> bool {
    let fields = |place: &Place| place.steps.iter().all(|step| matches!(step, Step::Field(_)));
    value.is_literal() || matches!(&value.kind, ExprKind::Load(place) if fields(place))
}

/// Returns true if a step has only literal indices.
pub(super) fn is_fixed(step: &Step) -> bool {
    step.indices().all(Expr::is_literal)
}
