//! The elements of a `BoundedMatrix`: one, whose row and column are checked against the size that it has, and all of
//! them, column by column, in two loops that its author wrote as one.

use bessemer_ir::tree;
use bessemer_ir::{CompareOp, Expr, Fault, LogicOp, Place, Span, Step, StmtKind, Type};

use super::each::Each;
use super::lengths::least;
use super::lowering::Lowering;
use super::value::Value;
use super::{Result, problem};

impl Lowering<'_, '_> {
    /// The type of the elements of a `BoundedMatrix`, and how many rows and columns there may be.
    pub(super) fn bounded_type(&self, ty: &Type) -> Option<(Type, u32, u32)> {
        let Type::Struct(id) = ty else { return None };
        if !self.cx.known(ty).bounded {
            return None;
        }
        match &self.cx.fields(*id).get(2)?.ty {
            Type::Array { element, len: columns } => match &**element {
                Type::Array { element, len: rows } => Some(((**element).clone(), *rows, *columns)),
                _ => None,
            },
            _ => None,
        }
    }

    /// `matrix[(row, column)]`.
    pub(super) fn bounded_element(
        &mut self,
        mut place: Place,
        index: &tree::Expr,
        span: Span,
    ) -> Result<Place> {
        let Some((element, rows, columns)) = self.bounded_type(&place.ty) else {
            return Ok(place);
        };
        let tree::ExprKind::Tuple(parts) = &index.kind else {
            return problem(
                index.site,
                "a `BoundedMatrix` takes a row and a column",
                "write `m[(row, column)]`",
            );
        };
        let remedy = "write `m[(row, column)]`";
        let [row, column] = parts.as_slice() else {
            return problem(index.site, "this takes a row and a column", remedy);
        };
        let mark = self.out.len();
        let [row, column] = self.row_and_column([row, column])?;
        let (row, column) = (self.steady("row", row), self.steady("column", column));
        self.settle_since(mark, &mut place);
        let size = |field| place.inside(Step::Field(field), Type::USIZE).load();
        let conditions = [
            // The first two hold of every matrix, and keep a damaged one from being read beyond its end.
            Expr::compare(CompareOp::Le, size(0), Expr::usize(u64::from(rows), span)).at(span),
            Expr::compare(CompareOp::Le, size(1), Expr::usize(u64::from(columns), span)).at(span),
            Expr::compare(CompareOp::Lt, row.clone(), size(0)).at(span),
            Expr::compare(CompareOp::Lt, column.clone(), size(1)).at(span),
        ];
        let condition = conditions.into_iter().reduce(|a, b| Expr::logic(LogicOp::And, a, b));
        if let Some(condition) = condition {
            self.emit(StmtKind::Check { condition, fault: Fault::Index }, span);
        }
        Ok(element_at(&place, (element, rows, columns), [row, column], span))
    }

    /// A `BoundedMatrix` that a loop goes through, if it has a name.
    pub(super) fn bounded_place(&mut self, expr: &tree::Expr) -> Option<Place> {
        // Whatever else is wrong with it is told where it is lowered.
        let place = is_named(expr).then(|| self.base(expr).ok())??;
        self.bounded_type(&place.ty).is_some().then_some(place)
    }

    /// `for` over all its elements.
    pub(super) fn each_of_bounded(
        &mut self,
        (part, matrix): (&tree::Part, Place),
        Each { site, label, body, .. }: Each,
    ) -> Result<()> {
        let span = self.span(site);
        let Some((element, rows, columns)) = self.bounded_type(&matrix.ty) else { return Ok(()) };
        let matrix = self.held_still(matrix);
        let mut size = |name, field, most: u32| {
            let size = matrix.inside(Step::Field(field), Type::USIZE).load();
            self.steady(name, least(size, Expr::usize(u64::from(most), span)))
        };
        let (end_rows, end_columns) = (size("rows", 0, rows), size("columns", 1, columns));
        let at = |root| Expr::local(root, &Type::USIZE, span);
        let outermost = self.frames.len();
        self.repeated(None, None, span, |walk| {
            let column = walk.counter("column", span);
            walk.counters.push(column);
            let through = |walk: &mut Self| {
                let row = walk.counter("row", span);
                walk.counters.push(row);
                let at = [at(row), at(column)];
                let place = element_at(&matrix, (element, rows, columns), at, span);
                let block = walk.scoped(|walk| {
                    walk.bind_pattern(&part.pattern, &Value::Place(place), site)?;
                    walk.pass_of(label, outermost, |walk| walk.statements(body))
                })?;
                walk.counters.pop();
                Ok(StmtKind::for_below(row, end_rows, block))
            };
            let block = walk.scoped(|walk| walk.repeated(None, None, span, through))?;
            walk.counters.pop();
            Ok(StmtKind::for_below(column, end_columns, block))
        })
    }
}

/// The element at a row and a column, which are known to be there.
fn element_at(
    matrix: &Place,
    (element, rows, columns): (Type, u32, u32),
    [row, column]: [Expr; 2],
    span: Span,
) -> Place {
    let of_column = Type::Array { element: Box::new(element.clone()), len: rows };
    let all = Type::Array { element: Box::new(of_column.clone()), len: columns };
    let column = matrix.inside(Step::Field(2), all).inside(Step::Index(column), of_column);
    Place { span, ..column.inside(Step::Index(row), element) }
}

/// Whether lowering an expression as a place computes nothing.
fn is_named(expr: &tree::Expr) -> bool {
    match &expr.kind {
        tree::ExprKind::Local(_) => true,
        tree::ExprKind::Field(base, _)
        | tree::ExprKind::Deref(base)
        | tree::ExprKind::Ref(_, base) => is_named(base),
        _ => false,
    }
}
