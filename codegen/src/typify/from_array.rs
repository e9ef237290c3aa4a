//! `Vector3::from([x, y, z])` and the like: matrices from arrays of their elements, by columns as nalgebra has
//! it, and arrays from matrices.

use bessemer_ir::tree;
use bessemer_ir::{Block, Expr, ExprKind, Place, Span, Step, StmtKind, Type};

use super::lowering::Lowering;
use super::{OUR_FAULT, Result, problem};

/// Up to so many elements are written out.
const WRITTEN_OUT: u32 = 16;

impl Lowering<'_, '_> {
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
            let elements = self.uniform(&elements, Some(Type::Scalar(*element)))?;
            return self.node(ExprKind::Matrix(elements), ty, expr.site);
        }
        let mut source = self.base(from)?;
        self.keep_indices(&mut source, |index| !index.is_literal());
        let (outer, inner) = match (dimensions(&ty), dimensions(&source.ty)) {
            (Some(dimensions), None) | (None, Some(dimensions)) => dimensions,
            _ => return problem(expr.site, "this is no array of a matrix' elements", OUR_FAULT),
        };
        let span = self.span(expr.site);
        if outer * inner.unwrap_or(1) <= WRITTEN_OUT {
            return self.node(written_out(&source, &ty, (outer, inner), span), ty, expr.site);
        }
        let whole = self.zero(&ty, span);
        let result = self.temporary_place("elements", whole);
        let i = self.counter(if inner.is_some() { "col" } else { "i" }, span);
        let row = inner.map(|_| self.counter("row", span));
        let counter = |local| Expr::local(local, &Type::USIZE, span);
        let at = (counter(i), row.map(counter));
        let size = |count: u32| Expr::usize(u64::from(count), span);
        let (place, value) = (cell(&result, &at, span), cell(&source, &at, span).load());
        let mut body = Block::of(StmtKind::Assign { place, value }, span);
        if let (Some(row), Some(rows)) = (row, inner) {
            body = Block::of(StmtKind::for_below(row, size(rows), body), span);
        }
        self.emit(StmtKind::for_below(i, size(outer), body), span);
        Ok(result.load())
    }

    /// Whether what is written out are elements, and not columns that have names.
    fn are_numbers(&mut self, elements: &[tree::Expr]) -> Result<bool> {
        match elements.first() {
            Some(first) => Ok(matches!(self.type_alone(first)?, Type::Scalar(_))),
            None => Ok(false),
        }
    }
}

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
