//! Conversions to and from arrays: slices as arrays, `bytes[2..6].try_into()`, `bytes.first_chunk::<4>()`;
//! matrices from arrays of their elements, `Vector3::from([x, y, z])`, by columns as nalgebra has it, and arrays from matrices.

use bessemer_ir::tree::{self, Builtin, SliceMethod};
use bessemer_ir::{Block, Expr, ExprKind, Fault, Place, Span, Step, StmtKind, StructId, Type};

use super::lowering::Lowering;
use super::value::{SMALL, Slice};
use super::words;
use super::{OUR_FAULT, Result, problem};

impl Lowering<'_, '_> {
    /// `Ok` or `Some` of the elements, if there are as many (`whole`), or no fewer.
    pub(super) fn as_array(
        &mut self,
        whole: bool,
        slice: &Slice,
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let (id, ty) = self.array_in(expr)?;
        let (there, array) = self.elements_as(whole, slice, ty, expr)?;
        let span = self.span(expr.site);
        let none = self.choice(id, 0, None, expr.site)?;
        let place = self.temporary_place("part", none);
        let (held, value) = (place.load(), self.choice(id, 1, Some(array), expr.site)?);
        let then = Block::of(StmtKind::Assign { place, value }, span);
        self.emit_if(there, then, span);
        Ok(held)
    }

    /// The same behind `unwrap`: a check, and the elements; none if `expr` is something else.
    pub(super) fn unwrapped_array(&mut self, expr: &tree::Expr) -> Result<Option<Expr>> {
        let Some((Builtin::Slice(method), arguments)) = self.builtin_call(expr) else {
            return Ok(None);
        };
        let whole = match method {
            SliceMethod::ToArray => true,
            SliceMethod::FirstChunk => false,
            _ => return Ok(None),
        };
        let slice = self.sliced(&arguments[0])?;
        let (_, ty) = self.array_in(expr)?;
        let (condition, array) = self.elements_as(whole, &slice, ty, expr)?;
        if condition.kind != ExprKind::Literal(1) {
            let span = self.span(expr.site);
            self.emit(StmtKind::Check { condition, fault: Fault::Absent }, span);
        }
        Ok(Some(array))
    }

    /// The `Option` or `Result` of a call, and the array in it.
    fn array_in(&mut self, expr: &tree::Expr) -> Result<(StructId, Type)> {
        let ty = match self.slot_of(expr)? {
            Type::Struct(id) => ["Ok", "Some"].iter().find_map(|case| {
                let field = self.case(id, case)?.1.field?;
                Some((id, self.cx.field_type(id, field)))
            }),
            _ => None,
        };
        match ty {
            Some(found @ (_, Type::Array { .. })) => Ok(found),
            _ => problem(expr.site, "a slice becomes an array in the DSL", OUR_FAULT),
        }
    }

    /// Whether there are as many elements as the array has, and these.
    fn elements_as(
        &mut self,
        whole: bool,
        slice: &Slice,
        ty: Type,
        expr: &tree::Expr,
    ) -> Result<(Expr, Expr)> {
        let span = self.span(expr.site);
        let Type::Array { len, .. } = ty else {
            return problem(expr.site, "a slice becomes an array in the DSL", OUR_FAULT);
        };
        if len > MOST {
            return problem(
                expr.site,
                format!("a slice becomes an array of at most {MOST} elements in the DSL"),
                "declare the array, and call `copy_from_slice`",
            );
        }
        Ok((slice.has(len.into(), whole, span), slice.as_array(ty, span)))
    }

    /// A matrix from an array, or an array from a matrix.
    pub(super) fn exchanged_with_array(
        &mut self,
        from: &tree::Expr,
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let ty = self.slot_of(expr)?;
        if let (Type::Matrix { element, .. }, Some(elements)) = (&ty, leaves(from))
            && self.are_numbers(&elements)?
        {
            let elements = self.alike(&elements, Some(Type::Scalar(*element)), &words::OPERANDS)?;
            return self.node(ExprKind::Matrix(elements), ty, expr.site);
        }
        let mut source = self.base(from)?;
        self.keep_indices(&mut source, |index| !index.is_literal());
        let (outer, inner) = match (dimensions(&ty), dimensions(&source.ty)) {
            (Some(dimensions), None) | (None, Some(dimensions)) => dimensions,
            _ => return problem(expr.site, "this is no array of a matrix' elements", OUR_FAULT),
        };
        let span = self.span(expr.site);
        if outer * inner.unwrap_or(1) <= SMALL {
            return self.node(written_out(&source, &ty, (outer, inner), span), ty, expr.site);
        }
        let whole = self.zero(&ty, span);
        let result = self.temporary_place("elements", whole);
        let i = self.counter(if inner.is_some() { "col" } else { "i" }, span);
        let row = inner.map(|_| self.counter("row", span));
        let local = |root| Expr::local(root, &Type::USIZE, span);
        let at = (local(i), row.map(local));
        let (place, value) = (cell(&result, &at, span), cell(&source, &at, span).load());
        let mut body = Block::of(StmtKind::Assign { place, value }, span);
        let count = |count: u32| Expr::usize(u64::from(count), span);
        if let (Some(row), Some(rows)) = (row, inner) {
            body = Block::of(StmtKind::for_below(row, count(rows), body), span);
        }
        self.emit(StmtKind::for_below(i, count(outer), body), span);
        Ok(result.load())
    }

    /// True if the items of an array literal are scalars; else they are the names of columns.
    fn are_numbers(&mut self, elements: &[tree::Expr]) -> Result<bool> {
        match elements.first() {
            Some(first) => Ok(matches!(self.type_alone(first)?, Type::Scalar(_))),
            None => Ok(false),
        }
    }
}

/// How many elements are written out at most.
const MOST: u32 = 32;

/// The elements of an array that is written out, or of one of such arrays.
fn leaves(array: &tree::Expr) -> Option<Vec<tree::Expr>> {
    let tree::ExprKind::Array(items) = &array.kind else { return None };
    let nested: Vec<_> = items.iter().map(leaves).collect();
    match nested.iter().all(Option::is_none) {
        true => Some(items.clone()),
        false => nested.into_iter().collect::<Option<Vec<_>>>().map(|lists| lists.concat()),
    }
}

/// The length of an array, and of the arrays in it.
fn dimensions(ty: &Type) -> Option<(u32, Option<u32>)> {
    match ty {
        Type::Array { element, len } => match &**element {
            Type::Array { len: inner, .. } => Some((*len, Some(*inner))),
            _ => Some((*len, None)),
        },
        _ => None,
    }
}

/// The part of an array or a matrix at a column and a row, or at an index.
fn cell(whole: &Place, (outer, inner): &(Expr, Option<Expr>), span: Span) -> Place {
    match (&whole.ty, inner) {
        (Type::Matrix { element, rows, .. }, inner) => {
            let (row, col) = match inner {
                Some(row) => (row.clone(), outer.clone()),
                None if *rows == 1 => (Expr::usize(0, span), outer.clone()),
                None => (outer.clone(), Expr::usize(0, span)),
            };
            whole.inside(Step::Element(row, col), Type::Scalar(*element))
        }
        (Type::Array { element, .. }, inner) => {
            let part = whole.inside(Step::Index(outer.clone()), (**element).clone());
            match (&part.ty, inner) {
                (Type::Array { element, .. }, Some(row)) => {
                    let element = (**element).clone();
                    part.inside(Step::Index(row.clone()), element)
                }
                _ => part,
            }
        }
        _ => whole.clone(),
    }
}

/// The value of few elements.
fn written_out(
    source: &Place,
    ty: &Type,
    (outer, inner): (u32, Option<u32>),
    span: Span,
) -> ExprKind {
    let index = |index: u32| Expr::usize(u64::from(index), span);
    let column = |col: u32| -> Vec<Expr> {
        let rows = inner.map_or(vec![None], |rows| (0..rows).map(|row| Some(index(row))).collect());
        rows.into_iter().map(|row| cell(source, &(index(col), row), span).load()).collect()
    };
    match (ty, inner) {
        (Type::Array { element, .. }, Some(_)) => {
            let array =
                |col| Expr { kind: ExprKind::Array(column(col)), ty: (**element).clone(), span };
            ExprKind::Array((0..outer).map(array).collect())
        }
        (Type::Array { .. }, None) => ExprKind::Array((0..outer).flat_map(column).collect()),
        _ => ExprKind::Matrix((0..outer).flat_map(column).collect()),
    }
}
