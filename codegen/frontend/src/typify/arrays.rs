//! Conversions to and from arrays: of slices, `bytes[2..6].try_into()`, `bytes.first_chunk::<4>()`; and of matrices,
//! `Vector3::from([x, y, z])`. The elements of a matrix are in nalgebra's order, by columns.

use bessemer_ir::tree::{self, Builtin, SliceMethod};
use bessemer_ir::{Expr, ExprKind, Fault, Place, Span, Step, StmtKind, StructId, Type};

use super::lengths::size;
use super::lowering::Lowering;
use super::value::{SMALL, Slice, step_to};
use super::words;
use super::{OUR_FAULT, Result, problem};

impl Lowering<'_, '_> {
    /// Lowers a slice to `Ok` or `Some` of an array. With `whole` it needs exactly as many elements as the array,
    /// else at least as many.
    pub(super) fn as_array(
        &mut self,
        whole: bool,
        slice: &Slice,
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let (id, ty, len) = self.array_in(expr)?;
        let span = self.span(expr.site);
        let (there, array) = (slice.has(len.into(), whole, span), slice.as_array(ty, span));
        let none = self.choice(id, 0, None, expr.site)?;
        let some = self.choice(id, 1, Some(array), expr.site)?;
        Ok(self.either("part", none, (there, some), span))
    }

    /// Lowers `unwrap` of such a conversion, a check and the elements, or of one of a number to a float, which always exists.
    /// Returns none for any other expression.
    pub(super) fn unwrapped_whole(&mut self, expr: &tree::Expr) -> Result<Option<Expr>> {
        let Some((builtin, arguments)) = self.builtin_call(expr) else { return Ok(None) };
        if builtin == Builtin::TryFrom {
            let Type::Struct(id) = self.slot_of(expr)? else { return Ok(None) };
            let target = self.going_on(id).and_then(|name| self.payload_type(id, name));
            let Some(target) = target.filter(|ty| ty.as_float().is_some()) else { return Ok(None) };
            let value = self.value(&arguments[0], None)?;
            return self.as_float(value, target, expr.site).map(Some);
        }
        let Builtin::Slice(method) = builtin else { return Ok(None) };
        let whole = match method {
            SliceMethod::ToArray => true,
            SliceMethod::FirstChunk => false,
            _ => return Ok(None),
        };
        let slice = self.sliced(&arguments[0])?;
        let (_, ty, len) = self.array_in(expr)?;
        let span = self.span(expr.site);
        let condition = slice.has(len.into(), whole, span);
        if condition.kind != ExprKind::Literal(1) {
            self.check(condition, Fault::Absent, span);
        }
        Ok(Some(slice.as_array(ty, span)))
    }

    /// Returns the `Option` or `Result` type of a call, its array type, and the length of the array.
    fn array_in(&mut self, expr: &tree::Expr) -> Result<(StructId, Type, u32)> {
        let ty = match self.slot_of(expr)? {
            Type::Struct(id) => {
                let held = self.going_on(id).and_then(|case| self.payload_type(id, case));
                held.map(|ty| (id, ty))
            }
            _ => None,
        };
        match ty {
            Some((id, ty @ Type::Array { len, .. })) if len <= MOST => Ok((id, ty, len)),
            Some((_, Type::Array { .. })) => problem(
                expr.site,
                format!("a slice converts to an array of at most {MOST} elements"),
                "declare the array, and call `copy_from_slice`",
            ),
            _ => problem(expr.site, "this conversion of a slice requires an array", OUR_FAULT),
        }
    }

    /// Lowers a matrix made from an array, or an array made from a matrix.
    pub(super) fn exchanged_with_array(
        &mut self,
        from: &tree::Expr,
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let ty = self.slot_of(expr)?;
        if let (Type::Matrix { element, .. }, Some(elements)) = (&ty, leaves(from))
            // Else they are the names of columns.
            && let Some(first) = elements.first()
            && matches!(self.type_of_value(first)?, Type::Scalar(_))
        {
            let elements = self.alike(&elements, Some(Type::Scalar(*element)), &words::OPERANDS)?;
            return self.node(ExprKind::Matrix(elements), ty, expr.site);
        }
        let source = self.base(from)?;
        let (outer, inner) = match (dimensions(&ty), dimensions(&source.ty)) {
            (Some(dimensions), None) | (None, Some(dimensions)) => dimensions,
            _ => return problem(expr.site, "this is no array of a matrix' elements", OUR_FAULT),
        };
        let span = self.span(expr.site);
        if outer * inner.unwrap_or(1) <= SMALL {
            return self.node(written_out(&source, &ty, (outer, inner), span), ty, expr.site);
        }
        let whole = self.zero(&ty, span);
        let result = self.assigned("elements", whole);
        let copy = |walk: &mut Self, at: &[Expr]| {
            let (place, value) = (cell(&result, at, span), cell(&source, at, span).load());
            walk.emit(StmtKind::Assign { place, value }, span);
            Ok(())
        };
        match inner {
            None => self.below("i", size(outer, span), span, |walk, i| copy(walk, &[i]))?,
            Some(rows) => self.below("col", size(outer, span), span, |walk, col| {
                walk.below("row", size(rows, span), span, |walk, row| copy(walk, &[col, row]))
            })?,
        }
        Ok(result.load())
    }
}

/// Largest number of elements that is written out without a loop.
const MOST: u32 = 32;

/// Returns the elements of an array literal, also of nested literals, in order.
fn leaves(array: &tree::Expr) -> Option<Vec<tree::Expr>> {
    let tree::ExprKind::Array(items) = &array.kind else { return None };
    let nested: Vec<_> = items.iter().map(leaves).collect();
    match nested.iter().all(Option::is_none) {
        true => Some(items.clone()),
        false => nested.into_iter().collect::<Option<Vec<_>>>().map(|lists| lists.concat()),
    }
}

/// Returns the length of an array, and of its inner arrays if it has any.
fn dimensions(ty: &Type) -> Option<(u32, Option<u32>)> {
    match ty {
        Type::Array { element, len } => match &**element {
            Type::Array { len: inner, .. } => Some((*len, Some(*inner))),
            _ => Some((*len, None)),
        },
        _ => None,
    }
}

/// Returns the element of an array or a matrix at a column and a row, or at one index.
fn cell(whole: &Place, at: &[Expr], span: Span) -> Place {
    match (&whole.ty, at) {
        (Type::Matrix { element, .. }, [first, rest @ ..]) => {
            let step = match rest {
                [row, ..] => Step::Element(row.clone(), first.clone()),
                [] => step_to(&whole.ty, first.clone(), span),
            };
            whole.inside(step, Type::Scalar(*element))
        }
        (Type::Array { element, .. }, [first, rest @ ..]) => {
            cell(&whole.inside(Step::Index(first.clone()), (**element).clone()), rest, span)
        }
        _ => whole.clone(),
    }
}

/// Returns an aggregate of at most [`MOST`] elements, each read by its own expression.
fn written_out(
    source: &Place,
    ty: &Type,
    (outer, inner): (u32, Option<u32>),
    span: Span,
) -> ExprKind {
    let index = |index: u32| Expr::usize(u64::from(index), span);
    let load = |at: &[Expr]| cell(source, at, span).load();
    let columns = (0..outer).map(|col| match inner {
        Some(rows) => (0..rows).map(|row| load(&[index(col), index(row)])).collect(),
        None => vec![load(&[index(col)])],
    });
    match (ty, inner) {
        (Type::Array { element: ty, .. }, Some(_)) => {
            let array = |of| Expr { kind: ExprKind::Array(of), ty: (**ty).clone(), span };
            ExprKind::Array(columns.map(array).collect())
        }
        (Type::Array { .. }, None) => ExprKind::Array(columns.flatten().collect()),
        _ => ExprKind::Matrix(columns.flatten().collect()),
    }
}
