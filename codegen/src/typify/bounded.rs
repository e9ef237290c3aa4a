//! An element of a `BoundedMatrix`: its row and column are checked against the size that it has.

use bessemer_ir::tree;
use bessemer_ir::{CompareOp, Expr, ExprKind, Fault, LogicOp, Place, Span, Step, StmtKind, Type};

use super::equal::number;
use super::expr::{Operand, two};
use super::function::Lowering;
use super::pattern::{inside, load, logic};
use super::{Result, problem};

impl Lowering<'_, '_> {
    /// The type of the elements of a `BoundedMatrix`, and how many rows and columns there may be.
    pub(super) fn bounded_type(&self, ty: &Type) -> Option<(Type, u32, u32)> {
        let Type::Struct(id) = ty else { return None };
        if !self.cx.bounded.contains(id) {
            return None;
        }
        match &self.cx.module.structs[id.index()].fields.get(2)?.ty {
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
        let [row, column] = parts.as_slice() else {
            return problem(
                index.site,
                "this takes a row and a column",
                "write `m[(row, column)]`",
            );
        };
        let mark = self.out.len();
        let usize = Some(Type::USIZE);
        let indices = self.operands(&[
            Operand { expr: row, expected: usize.clone(), role: "row" },
            Operand { expr: column, expected: usize, role: "column" },
        ])?;
        let [row, column] = two(indices, index.site)?;
        let (row, column) = (self.steady("row", row), self.steady("column", column));
        let later = self.later(mark);
        self.settle_place(&mut place, &later);
        self.out.extend(later);
        let size = |field| load(&inside(&place, Step::Field(field), Type::USIZE));
        let conditions = [
            // The first two hold of every matrix, and keep a damaged one from being read beyond its end.
            compare(CompareOp::Le, size(0), number(u64::from(rows), span), span),
            compare(CompareOp::Le, size(1), number(u64::from(columns), span), span),
            compare(CompareOp::Lt, row.clone(), size(0), span),
            compare(CompareOp::Lt, column.clone(), size(1), span),
        ];
        let condition = conditions.into_iter().reduce(|a, b| logic(LogicOp::And, a, b));
        if let Some(condition) = condition {
            self.emit(StmtKind::Check { condition, fault: Fault::Index }, span);
        }
        let of_column = Type::Array { element: Box::new(element.clone()), len: rows };
        let all = Type::Array { element: Box::new(of_column.clone()), len: columns };
        let elements = inside(&place, Step::Field(2), all);
        let column = inside(&elements, Step::Index(column), of_column);
        Ok(Place { span, ..inside(&column, Step::Index(row), element) })
    }
}

fn compare(op: CompareOp, left: Expr, right: Expr, span: Span) -> Expr {
    let kind = ExprKind::Compare(op, Box::new(left), Box::new(right));
    Expr { kind, ty: Type::BOOL, span }
}
