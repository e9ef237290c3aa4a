//! Slices: borrowed parts of arrays, and `==` of two slices: equal lengths, and equal elements in order.
//!
//! Within a function a slice is its array with two indices; only an argument of a call becomes an address and a
//! length. So a slice copies nothing. An index is checked against the slice once, and against the array unless that
//! follows.

use bessemer_ir::tree::{self, BinaryOp as Op, Builtin, Site, SliceMethod, Ty};
use bessemer_ir::{
    BinaryOp, CompareOp, Expr, ExprKind, Fault, LocalId, LogicOp, Mode, Place, Span, StmtKind, Type,
};

use super::expr::Call;
use super::lengths::{compared, divided, is_number, lesser, minus, plus, same, size};
use super::lowering::Lowering;
use super::pair::Pair;
use super::refusals::Reason;
use super::slots::{result_of, slice_of};
use super::syntax::{bare, control_with_value};
use super::value::{Slice, Value};
use super::words;
use super::{Needed, Result, refusals, refused};

impl Lowering<'_, '_> {
    /// Declares a slice parameter.
    pub(super) fn slice_parameter(
        &mut self,
        param: &tree::Param,
        element: &Ty,
        mutable: bool,
    ) -> Result<()> {
        if matches!(self.source.tree.role, tree::Role::Entry { .. }) {
            return refused(param.site, refusals::ENTRY_SLICE);
        }
        let (element, span) = (self.cx.element_type(element, param.site)?, self.span(param.site));
        let local = self.slice_local(&param.name, element, mutable, span);
        if mutable {
            self.note_changing(local, param.slot);
        }
        self.bind(&param.name, Value::Local(local));
        Ok(())
    }

    /// Declares a slice parameter and the parameter of its length.
    pub(super) fn slice_local(
        &mut self,
        name: &str,
        element: Type,
        mutable: bool,
        span: Span,
    ) -> LocalId {
        let local = self.local(name, Type::Slice(Box::new(element)), span);
        self.locals[local.index()].mode = if mutable { Mode::RefMut } else { Mode::Ref };
        self.local(format!("{name}_length"), Type::USIZE, span);
        local
    }

    /// Lowers `let part = &values[1..];`: the name is an alias of the elements. If it is assigned again, or control
    /// flow selects the slice, a local holds its first index.
    pub(super) fn let_slice(
        &mut self,
        (name, slot): (&str, u32),
        mutable: bool,
        value: &tree::Expr,
        site: Site,
    ) -> Result<()> {
        let decided = control_with_value(value);
        if decided || mutable {
            let (ty, span) = (self.slot(slot, site)?, self.span(site));
            return self.naming_as(name, |inner| {
                if decided {
                    return inner.let_control(name, ty, Some(value), span);
                }
                let value = inner.value(value, Some(&ty))?;
                inner.let_named(name, value, span);
                Ok(())
            });
        }
        let slice = self.slice_for(name, value)?;
        self.bind(name, slice);
        Ok(())
    }

    /// Returns the meaning of a name for a slice.
    pub(super) fn slice_for(&mut self, name: &str, value: &tree::Expr) -> Result<Value> {
        let slice = self.naming_as(name, |inner| inner.sliced(value))?;
        Ok(Value::Slice(Box::new(self.kept_elements(slice))))
    }

    /// The slice that an expression denotes, or all elements of an array or a list.
    pub(super) fn sliced(&mut self, expr: &tree::Expr) -> Result<Slice> {
        self.all_elements(expr, |inner, ty| match inner.cx.is_name(ty) {
            true => refusals::PART_OF_A_NAME,
            false => refusals::IN_A_ROW,
        })
    }

    /// Returns all elements of an expression; `why` returns the refusal for a type without elements.
    pub(super) fn all_elements(
        &mut self,
        expr: &tree::Expr,
        why: impl FnOnce(&Self, &Type) -> Reason,
    ) -> Result<Slice> {
        if let Some(slice) = self.slice(expr)? {
            return Ok(slice);
        }
        let place = self.base(expr)?;
        let reason = why(self, &place.ty);
        self.all_of(place).or_refused(expr.site, reason)
    }

    /// Returns all elements of an array, a vector, a list, or a slice parameter.
    pub(super) fn all_of(&mut self, place: Place) -> Option<Slice> {
        if let (Type::Slice(element), []) = (&place.ty, place.steps.as_slice()) {
            let all = Slice::parameter(place.root, (**element).clone(), place.span);
            return Some(Slice { base: place, ..all });
        }
        if let Some((length, items)) = self.list_items(&place) {
            let Type::Array { element, len } = items.ty.clone() else { return None };
            let length = lesser(length.load(), size(len, place.span));
            return Some(Slice { whole: false, ..Slice::whole(items, *element, length) });
        }
        let (element, len) = match &place.ty {
            Type::Array { element, len } => ((**element).clone(), *len),
            Type::Matrix { element, rows, cols } => (Type::Scalar(*element), rows * cols),
            _ => return None,
        };
        let length = size(len, place.span);
        Some(Slice::whole(place, element, length))
    }

    /// Returns the slice that an expression is; none for another value.
    pub(super) fn slice(&mut self, expr: &tree::Expr) -> Result<Option<Slice>> {
        let expr = bare(expr);
        let span = self.span(expr.site);
        let place = match &expr.kind {
            tree::ExprKind::Slice(base, from, to, inclusive) => {
                let base = self.sliced(base)?;
                let ends = (from.as_deref(), to.as_deref());
                return self.narrowed(base, ends, *inclusive, span).map(Some);
            }
            tree::ExprKind::Index(base, index) if let Some(range) = self.numbers_of(index) => {
                let base = self.sliced(base)?;
                let ends = (Some(&range.from), range.to.as_ref());
                return self.narrowed(base, ends, range.inclusive, span).map(Some);
            }
            tree::ExprKind::Call(callee, arguments)
                if self.builtin_of(*callee) == Some(Builtin::Slice(SliceMethod::Whole)) =>
            {
                return self.sliced(&arguments[0]).map(Some);
            }
            tree::ExprKind::Local(name) => match self.lookup(name, expr.site)? {
                Value::Slice(slice) => return Ok(Some(*slice)),
                Value::Local(root) if let Type::Slice(element) = &self.locals[root.index()].ty => {
                    return Ok(Some(Slice::parameter(root, (**element).clone(), span)));
                }
                meaning => self.place_of(&meaning, span),
            },
            tree::ExprKind::Field(..) | tree::ExprKind::Index(..) => {
                let is_slice = !self.cx.types.borrowed.is_empty()
                    && self.place_type(expr).is_ok_and(|ty| self.cx.as_borrowed(&ty).is_some());
                if is_slice { Some(self.base(expr)?) } else { None }
            }
            _ if self.gives_slice(expr) => Some(self.held(expr)?),
            _ => None,
        };
        place.map_or(Ok(None), |place| self.slice_at(place, expr.site))
    }

    /// Returns true if the value of a call, or of control flow, is a slice.
    fn gives_slice(&self, expr: &tree::Expr) -> bool {
        let of_slot = self.seen_as(expr).and_then(slice_of).is_some();
        match &expr.kind {
            tree::ExprKind::Call(..) => {
                let called = self.called(expr).and_then(|(it, _)| result_of(it));
                of_slot || called.and_then(slice_of).is_some()
            }
            tree::ExprKind::Try(..) | tree::ExprKind::Apply(..) => of_slot,
            _ => of_slot && control_with_value(expr),
        }
    }

    /// Lowers `slice[from..to]` with Rust's checks.
    fn narrowed(
        &mut self,
        slice: Slice,
        (from, to): (Option<&tree::Expr>, Option<&tree::Expr>),
        inclusive: bool,
        span: Span,
    ) -> Result<Slice> {
        let written = match from {
            Some(from) => self.value(from, Some(&Type::USIZE))?,
            None => Expr::usize(0, span),
        };
        let from = self.atom("start", written.clone());
        let mark = self.out.len();
        let open = to.is_none();
        let mut to = match to {
            Some(to) => self.value(to, Some(&Type::USIZE))?,
            None => slice.length.clone(),
        };
        // `i + 4` behind `i..` is so many more than what was kept of `i`.
        if let (true, ExprKind::Binary(_, _, more)) = (is_further(&written, &to), &to.kind)
            && self.out.len() == mark
        {
            to = plus(from.clone(), (**more).clone());
        }
        if inclusive {
            // The last one has to be there before the one behind it can be named.
            to = self.atom("last", to);
            self.check_index(&to, CompareOp::Lt, &slice.length, span);
            to = plus(to, Expr::usize(1, span));
        } else if !open && !is_further(&from, &to) {
            to = self.atom("end", to);
        }
        let ordered = !is_number(&from, 0) && !is_further(&from, &to);
        let ordered = ordered.then(|| compared(CompareOp::Le, &from, &to, span));
        let inside = !open && !inclusive;
        let inside = inside.then(|| compared(CompareOp::Le, &to, &slice.length, span));
        let all = |one, other| Expr::logic(LogicOp::And, one, other);
        if let Some(condition) = ordered.into_iter().chain(inside).reduce(all) {
            self.check(condition, Fault::Index, span);
        }
        let whole = slice.whole && open && is_number(&from, 0);
        Ok(Slice { whole, ..slice.between(from, to) })
    }

    /// Emits the check of an index or a length: its comparison `op` with `most` must hold.
    pub(super) fn check_index(&mut self, index: &Expr, op: CompareOp, most: &Expr, span: Span) {
        self.check(compared(op, index, most, span), Fault::Index, span);
    }

    /// Lowers `slice[index]` with its check.
    pub(super) fn slice_element(
        &mut self,
        slice: &Slice,
        index: &tree::Expr,
        span: Span,
    ) -> Result<Place> {
        let index = self.value(index, Some(&Type::USIZE))?;
        if slice.whole {
            return Ok(self.indexed(Place { span, ..slice.at(index) }));
        }
        let index = self.atom(words::INDEX, index);
        self.check_index(&index, CompareOp::Lt, &slice.length, span);
        Ok(Place { span, ..slice.nth(index) })
    }

    /// Lowers a method of slices that returns a value.
    pub(super) fn slice_method(&mut self, method: SliceMethod, call: Call<'_>) -> Result<Expr> {
        use SliceMethod as M;
        let Call { arguments, expr } = call;
        let span = self.span(expr.site);
        let copied = matches!(method, M::First | M::Last | M::Get);
        let ty = if copied { Some(self.slot_of(expr)?) } else { self.borrowing_type(expr) };
        if let Some(ty) = ty
            && let Some(lent) = self.lent(expr)?
        {
            return self.lent_value(lent, &ty, expr.site);
        }
        let slice = self.sliced(&arguments[0])?;
        let zero = Expr::usize(0, span);
        match (method, arguments) {
            (M::Len, _) => Ok(slice.length),
            (M::IsEmpty, _) => Ok(compared(CompareOp::Eq, &slice.length, &zero, span)),
            (M::ToArray, _) => self.as_array(true, &slice, expr),
            (M::FirstChunk, _) => self.as_array(false, &slice, expr),
            (M::CopyFrom | M::Reverse, _) => refused(expr.site, refusals::STATEMENT),
            _ => refused(expr.site, refusals::LENT),
        }
    }

    /// Lowers a method of slices that is called for its effect; returns false for another expression.
    pub(super) fn slice_effect(&mut self, expr: &tree::Expr) -> Result<bool> {
        let Some((Builtin::Slice(method), arguments)) = self.builtin_call(expr) else {
            return Ok(false);
        };
        let span = self.span(expr.site);
        match (method, arguments) {
            (SliceMethod::Reverse, [array]) => {
                let slice = self.sliced(array)?;
                let half = match slice.length.kind {
                    ExprKind::Literal(length) => Expr::usize(length / 2, span),
                    _ => divided(slice.length.clone(), Expr::usize(2, span)),
                };
                let last = minus(slice.to.clone(), Expr::usize(1, span));
                self.below("i", half, span, |inner, index| {
                    let other = slice.at(minus(last, index.clone()));
                    let one = slice.nth(index);
                    let (value, before) = (other.load(), inner.atom("before", one.load()));
                    inner.emit(StmtKind::Assign { place: one, value }, span);
                    inner.emit(StmtKind::Assign { place: other, value: before }, span);
                    Ok(())
                })?;
            }
            (SliceMethod::CopyFrom, [array, from]) => {
                let (to, from) = (self.sliced(array)?, self.sliced(from)?);
                if !to.length.is_literal() || !from.length.is_literal() {
                    self.check_index(&to.length, CompareOp::Eq, &from.length, span);
                } else if to.length.kind != from.length.kind {
                    return refused(expr.site, refusals::TWO_LENGTHS);
                }
                self.below("i", to.length.clone(), span, |inner, index| {
                    let (place, value) = (to.nth(index.clone()), from.nth(index).load());
                    inner.emit(StmtKind::Assign { place, value }, span);
                    Ok(())
                })?;
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Lowers `left == right` or `left != right`, if one of the two is a slice.
    pub(super) fn slices_compared(
        &mut self,
        op: Op,
        (left, right): (&tree::Expr, &tree::Expr),
        site: Site,
    ) -> Result<Option<Expr>> {
        if !matches!(op, Op::Eq | Op::Ne) {
            return Ok(None);
        }
        let (one, other) = (self.slice(left)?, self.slice(right)?);
        if one.is_none() && other.is_none() {
            return Ok(None);
        }
        let one = one.map_or_else(|| self.sliced(left), Ok)?;
        let other = other.map_or_else(|| self.sliced(right), Ok)?;
        let span = self.span(site);
        let equal = |inner: &mut Self| {
            inner.all_equal(one.length.clone(), span, |inner, index| {
                let sides = [one.nth(index.clone()), other.nth(index)];
                inner.equal(&Pair { sides, site, span })
            })
        };
        let equal = match same(&one.length, &other.length) {
            true => equal(self)?,
            false => {
                let as_long = compared(CompareOp::Eq, &one.length, &other.length, span);
                self.logic_and(as_long, &mut Vec::new(), |inner, _| equal(inner))?
            }
        };
        Ok(Some(if op == Op::Ne { equal.negated() } else { equal }))
    }
}

/// Returns true if `to` is `from` plus a constant, so that it cannot be less.
fn is_further(from: &Expr, to: &Expr) -> bool {
    match (&from.kind, &to.kind) {
        (ExprKind::Literal(from), ExprKind::Literal(to)) => from <= to,
        (_, ExprKind::Binary(BinaryOp::Add, base, more)) => {
            same(base, from) && matches!(more.kind, ExprKind::Literal(_) | ExprKind::Const(_))
        }
        _ => false,
    }
}
