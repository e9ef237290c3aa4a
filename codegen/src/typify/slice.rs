//! Slices: a part of an array that is lent, and `==` of two: as long, and the same elements in the same order.
//!
//! Within a function a slice is the array itself and which of its elements are meant; only what is passed
//! to another function becomes an address and a length. So a slice copies nothing, and an index is
//! checked against the slice once, and against the array unless it follows.

use bessemer_ir::tree::{self, BinaryOp as Op, Builtin, Site, SliceMethod, Ty};
use bessemer_ir::{
    BinaryOp, CompareOp, Expr, ExprKind, Fault, LogicOp, Mode, Place, Span, StmtKind, Type,
};

use super::comparison::Pair;
use super::lengths::{is_number, least, minus, plus, same};
use super::lowering::Lowering;
use super::syntax::{Writes, control_with_value};
use super::value::{Slice, Value};
use super::words;
use super::{Result, problem};

impl Lowering<'_, '_> {
    /// A parameter that is a slice, and the one of its length.
    pub(super) fn slice_parameter(
        &mut self,
        param: &tree::Param,
        element: &Ty,
        mutable: bool,
    ) -> Result<()> {
        if matches!(self.source.tree.role, tree::Role::Entry { .. }) {
            return problem(
                param.site,
                "an entry point takes no slice: nothing could tell whether its length is right",
                "take an array, `&[T; N]`, or a `List<T, N>`",
            );
        }
        let element = self.cx.value_type(element, param.site)?;
        if element == Type::Unit {
            return problem(param.site, super::zero_sized::EMPTY_SLICE, super::zero_sized::COUNT);
        }
        let mode = if mutable { Mode::RefMut } else { Mode::Ref };
        let span = self.span(param.site);
        self.declare(&param.name, Type::Slice(Box::new(element)), mode, span);
        self.local(format!("{}_length", param.name), Type::USIZE, span);
        Ok(())
    }

    /// `let part = &values[1..];`: another name for the elements. Where they begin is in a local if that is written again,
    /// or decided by control flow.
    pub(super) fn let_slice(
        &mut self,
        (name, slot): (&str, u32),
        value: &tree::Expr,
        site: Site,
    ) -> Result<()> {
        let decided = control_with_value(value);
        if decided || Writes::to(name, &self.source.tree.body).whole {
            let (ty, span) = (self.slot(slot, site)?, self.span(site));
            return self.naming_as(name, |inner| {
                if decided {
                    return inner.let_control(name, ty, Some(value), span);
                }
                let value = inner.value(value, Some(&ty))?;
                let local = inner.declare(name, ty, Mode::Value, span);
                inner.emit(StmtKind::Let { local, value: Some(value) }, span);
                Ok(())
            });
        }
        let slice = self.naming_as(name, |inner| inner.sliced(value))?;
        let slice = self.kept_elements(slice);
        self.bind(name, Value::Slice(Box::new(slice)));
        Ok(())
    }

    /// The slice that is lent, or all elements of an array or a list.
    pub(super) fn sliced(&mut self, expr: &tree::Expr) -> Result<Slice> {
        if let Some(slice) = self.slice(expr)? {
            return Ok(slice);
        }
        let mut place = self.base(expr)?;
        // Whether anything is asked of the elements or not.
        self.fix(&mut place);
        match self.all_of(place) {
            Some(slice) => Ok(slice),
            None => problem(
                expr.site,
                "this has no elements in a row",
                "take an array, a `List`, or `.as_slice()` of a vector",
            ),
        }
    }

    /// All elements of an array, a vector or a list.
    pub(super) fn all_of(&mut self, place: Place) -> Option<Slice> {
        if let Some((length, items)) = self.list_items(&place) {
            let Type::Array { element, len } = items.ty.clone() else { return None };
            let most = Expr::usize(u64::from(len), place.span);
            let length = super::lengths::lesser(length.load(), most);
            return Some(Slice { whole: false, ..Slice::whole(items, *element, length) });
        }
        match place.ty.clone() {
            Type::Array { element, len } => {
                let length = Expr::usize(u64::from(len), place.span);
                Some(Slice::whole(place, *element, length))
            }
            Type::Matrix { element, rows, cols } => {
                let length = Expr::usize(u64::from(rows * cols), place.span);
                Some(Slice::whole(place, Type::Scalar(element), length))
            }
            _ => None,
        }
    }

    /// The slice that an expression is, if its syntax or its name shows that it is one.
    pub(super) fn slice(&mut self, expr: &tree::Expr) -> Result<Option<Slice>> {
        match &expr.kind {
            tree::ExprKind::Local(name) => Ok(match self.lookup(name, expr.site)? {
                Value::Slice(slice) => Some(*slice),
                Value::Local(root) => match self.locals[root.index()].ty.clone() {
                    Type::Slice(element) => {
                        Some(Slice::parameter(root, *element, self.span(expr.site)))
                    }
                    ty => {
                        let span = self.span(expr.site);
                        self.slice_at(Place::local(root, ty, span), expr.site)?
                    }
                },
                Value::Place(place) => self.slice_at(place, expr.site)?,
                _ => None,
            }),
            tree::ExprKind::Ref(_, inner) | tree::ExprKind::Deref(inner) => self.slice(inner),
            tree::ExprKind::Slice(base, from, to, inclusive) => {
                let base = self.sliced(base)?;
                let span = self.span(expr.site);
                self.narrowed(base, (from.as_deref(), to.as_deref()), *inclusive, span).map(Some)
            }
            tree::ExprKind::Cut(base, cut) => {
                let base = match self.submatrix(base)? {
                    Some(part) => part.elements(),
                    None => self.sliced(base)?,
                };
                let count = self.value(&cut.count, Some(&Type::USIZE))?;
                let count = least(count, base.length.clone());
                let count = self.steady("count", count);
                Ok(Some(match cut.skip {
                    true => base.behind(count),
                    false => base.part(Expr::usize(0, base.base.span), count),
                }))
            }
            tree::ExprKind::Call(callee, arguments)
                if self.builtin_of(*callee) == Some(Builtin::Slice(SliceMethod::Whole)) =>
            {
                self.sliced(&arguments[0]).map(Some)
            }
            _ => self.computed_slice(expr),
        }
    }

    /// `slice[from..to]`, checked as Rust does.
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
        let mark = self.out.len();
        let from = self.steady("start", written.clone());
        let kept = self.later(mark);
        let open = to.is_none();
        let mut to = match to {
            Some(to) => self.value(to, Some(&Type::USIZE))?,
            None => slice.length.clone(),
        };
        let between = self.later(mark);
        let undisturbed = between.is_empty();
        self.out.extend(kept);
        self.out.extend(between);
        // `i + 4` behind `i..` is so many more than what was kept of `i`.
        if let (true, ExprKind::Binary(_, _, more)) = (is_further(&written, &to), &to.kind)
            && undisturbed
        {
            to = plus(from.clone(), (**more).clone());
        }
        if inclusive {
            // The last one has to be there before the one behind it can be named.
            to = self.steady("last", to);
            let there = Expr::compare(CompareOp::Lt, to.clone(), slice.length.clone()).at(span);
            self.emit(StmtKind::Check { condition: there, fault: Fault::Index }, span);
            to = plus(to, Expr::usize(1, span));
        } else if !open && !is_further(&from, &to) {
            to = self.steady("end", to);
        }
        let mut conditions = Vec::new();
        if !is_number(&from, 0) && !is_further(&from, &to) {
            conditions.push(Expr::compare(CompareOp::Le, from.clone(), to.clone()).at(span));
        }
        if !open && !inclusive {
            conditions
                .push(Expr::compare(CompareOp::Le, to.clone(), slice.length.clone()).at(span));
        }
        let condition = conditions.into_iter().reduce(|a, b| Expr::logic(LogicOp::And, a, b));
        if let Some(condition) = condition {
            self.emit(StmtKind::Check { condition, fault: Fault::Index }, span);
        }
        let whole = slice.whole && open && is_number(&from, 0);
        Ok(Slice { whole, ..slice.between(from, to) })
    }

    /// A value that is computed once, and written down again as it is where nothing changes it.
    pub(super) fn steady(&mut self, role: &str, value: Expr) -> Expr {
        match self.is_steady(&value) {
            true => value,
            false => self.temporary(role, value),
        }
    }

    /// Whether nothing writes to what a value is read from.
    pub(super) fn is_steady(&self, value: &Expr) -> bool {
        match &value.kind {
            ExprKind::Load(place) => {
                let known = self.steady.contains(&place.root) || self.held.contains(&place.root);
                place.steps.is_empty() && known
            }
            _ => value.is_literal(),
        }
    }

    /// `slice[index]`.
    pub(super) fn slice_element(
        &mut self,
        slice: &Slice,
        index: &tree::Expr,
        span: Span,
    ) -> Result<Place> {
        let index = self.value(index, Some(&Type::USIZE))?;
        let place = self.element_of(slice, index, span);
        Ok(Place { span, ..place })
    }

    /// An element, its index checked.
    fn element_of(&mut self, slice: &Slice, index: Expr, span: Span) -> Place {
        if slice.whole {
            return slice.at(index);
        }
        let index = match super::order::is_free(&index) {
            true => index,
            false => self.temporary(words::INDEX, index),
        };
        let there = Expr::compare(CompareOp::Lt, index.clone(), slice.length.clone()).at(span);
        self.emit(StmtKind::Check { condition: there, fault: Fault::Index }, span);
        slice.at(plus(slice.from.clone(), index))
    }

    /// The value of a method of slices that has one; none if `name` is no such method.
    pub(super) fn slice_method(
        &mut self,
        method: SliceMethod,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Expr> {
        use SliceMethod as M;
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
            (M::IsEmpty, _) => Ok(Expr::compare(CompareOp::Eq, slice.length, zero).at(span)),
            (M::ToArray, _) => self.as_array(true, &slice, expr),
            (M::FirstChunk, _) => self.as_array(false, &slice, expr),
            (M::CopyFrom | M::Reverse, _) => {
                problem(expr.site, "this has no value", "write it as a statement")
            }
            _ => {
                problem(expr.site, super::borrowed_slices::LENT, super::borrowed_slices::TAKE_APART)
            }
        }
    }

    /// A loop over the indices of the base.
    fn each_index(
        &mut self,
        slice: &Slice,
        span: Span,
        body: impl FnOnce(&mut Self, Expr) -> Result<()>,
    ) -> Result<()> {
        let variable = self.counter("i", span);
        let index = Place::local(variable, Type::USIZE, span);
        let body = self.scoped(|inner| body(inner, index.load()))?;
        let (from, to) = (slice.from.clone(), slice.to.clone());
        self.emit(StmtKind::for_range(variable, from, to, body), span);
        Ok(())
    }

    /// A method of slices for its effect; false if it is none.
    pub(super) fn slice_effect(&mut self, expr: &tree::Expr) -> Result<bool> {
        let Some((Builtin::Slice(method), arguments)) = self.builtin_call(expr) else {
            return Ok(false);
        };
        let span = self.span(expr.site);
        match (method, arguments) {
            (SliceMethod::Reverse, [array]) => {
                let slice = self.sliced(array)?;
                let half = Expr::binary(BinaryOp::Div, slice.length.clone(), Expr::usize(2, span));
                let half = match slice.length.kind {
                    ExprKind::Literal(length) => Expr::usize(length / 2, span),
                    _ => half,
                };
                let start = Slice { to: half, from: Expr::usize(0, span), ..slice.clone() };
                self.each_index(&start, span, |inner, index| {
                    let last = minus(minus(slice.to.clone(), Expr::usize(1, span)), index.clone());
                    let first = slice.at(plus(slice.from.clone(), index));
                    inner.exchange(first, slice.at(last), span);
                    Ok(())
                })?;
            }
            (SliceMethod::CopyFrom, [array, from]) => {
                let (to, from) = (self.sliced(array)?, self.sliced(from)?);
                let same =
                    Expr::compare(CompareOp::Eq, to.length.clone(), from.length.clone()).at(span);
                if !to.length.is_literal() || !from.length.is_literal() {
                    self.emit(StmtKind::Check { condition: same, fault: Fault::Index }, span);
                } else if to.length.kind != from.length.kind {
                    return problem(
                        expr.site,
                        "these are never of one length",
                        "name as many elements on both sides",
                    );
                }
                let all = Slice { from: Expr::usize(0, span), to: to.length.clone(), ..to.clone() };
                self.each_index(&all, span, |inner, index| {
                    let place = to.at(plus(to.from.clone(), index.clone()));
                    let value = from.at(plus(from.from.clone(), index)).load();
                    inner.emit(StmtKind::Assign { place, value }, span);
                    Ok(())
                })?;
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn exchange(&mut self, one: Place, other: Place, span: Span) {
        let before = self.temporary("before", one.load());
        self.emit(StmtKind::Assign { place: one, value: other.load() }, span);
        self.emit(StmtKind::Assign { place: other, value: before }, span);
    }

    /// `left == right` or `left != right`, if one of the two is a slice.
    pub(super) fn slices_compared(
        &mut self,
        op: Op,
        (left, right): (&tree::Expr, &tree::Expr),
        site: Site,
    ) -> Result<Option<Expr>> {
        if !matches!(op, Op::Eq | Op::Ne) {
            return Ok(None);
        }
        let (one, other) = match (self.slice(left)?, self.slice(right)?) {
            (None, None) => return Ok(None),
            (Some(one), None) => (one, self.sliced(right)?),
            (None, Some(other)) => (self.sliced(left)?, other),
            (Some(one), Some(other)) => (one, other),
        };
        let span = self.span(site);
        let (length, as_many) = (one.length.clone(), other.length.clone());
        let each = |inner: &mut Self| {
            inner.all_equal(one.length.clone(), span, |inner, index| {
                let at = |of: &Slice| of.at(plus(of.from.clone(), index.clone()));
                inner.equal(&Pair { sides: [at(&one), at(&other)], site, span })
            })
        };
        let equal = match same(&length, &as_many) {
            true => each(self)?,
            false => {
                let as_long = Expr::compare(CompareOp::Eq, length, as_many).at(span);
                self.and_then(as_long, each)?
            }
        };
        Ok(Some(if op == Op::Ne { equal.negated() } else { equal }))
    }
}

/// Whether `to` is a number more than `from`, so that it is never before it.
fn is_further(from: &Expr, to: &Expr) -> bool {
    match (&from.kind, &to.kind) {
        (ExprKind::Literal(from), ExprKind::Literal(to)) => from <= to,
        (_, ExprKind::Binary(BinaryOp::Add, base, more)) => {
            same(base, from) && matches!(more.kind, ExprKind::Literal(_) | ExprKind::Const(_))
        }
        _ => false,
    }
}
