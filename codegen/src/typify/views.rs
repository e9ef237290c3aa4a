//! Calls of the library that are written out where they stand: small views of matrices, small powers.

use bessemer_ir::tree;
use bessemer_ir::{CompareOp, Expr, ExprKind, Fault, Step, StmtKind, Type};

use super::lengths::plus;
use super::lowering::Lowering;
use super::{OUR_FAULT, Result, problem};

/// Views of up to so many elements are written out.
const SMALL: u32 = 16;

impl Lowering<'_, '_> {
    /// The inlined form of a call of the library; none if it stays a call.
    pub(super) fn shorter(
        &mut self,
        path: &str,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Option<Expr>> {
        let view = path.strip_prefix("bessemer::linear::views::");
        match view.and_then(|view| view.split('<').next()) {
            Some(name) => self.view(name, arguments, expr),
            None => self.small_power(path, arguments, expr),
        }
    }

    /// `v.zyx()`: the components of a vector, by their names.
    pub(super) fn swizzle(
        &mut self,
        axes: &[u8],
        vector: &tree::Expr,
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let ty = self.slot_of(expr)?;
        let span = self.span(expr.site);
        let place = self.base(vector)?;
        let Type::Matrix { element, .. } = place.ty else {
            return problem(expr.site, "this takes a vector", OUR_FAULT);
        };
        let component = |axis: &u8| {
            let step = Step::Element(Expr::usize(u64::from(*axis), span), Expr::usize(0, span));
            place.inside(step, Type::Scalar(element)).load()
        };
        self.node(ExprKind::Matrix(axes.iter().map(component).collect()), ty, expr.site)
    }

    fn view(
        &mut self,
        name: &str,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Option<Expr>> {
        let (row, column) = match (name, arguments) {
            ("row" | "fixed_rows", [_, row]) => (Some(row), None),
            ("column" | "fixed_columns", [_, column]) => (None, Some(column)),
            ("fixed_view", [_, row, column]) => (Some(row), Some(column)),
            _ => return Ok(None),
        };
        if expr.slot.is_none() {
            return Ok(None);
        }
        let ty = self.slot_of(expr)?;
        let Type::Matrix { element, rows, cols } = ty else { return Ok(None) };
        if rows.saturating_mul(cols) > SMALL {
            return Ok(None);
        }
        let span = self.span(expr.site);
        let mut place = self.base(&arguments[0])?;
        let Type::Matrix { rows: most_rows, cols: most_columns, .. } = place.ty else {
            return Ok(None);
        };
        self.keep_indices(&mut place, |index| !index.is_literal());
        let mut first = |index: Option<&tree::Expr>, role| match index {
            Some(index) => {
                let index = self.value(index, Some(&Type::USIZE))?;
                Ok(self.steady(role, index))
            }
            None => Ok(Expr::usize(0, span)),
        };
        let (row, column) = (first(row, "row")?, first(column, "column")?);
        // As nalgebra has it: the end of the view is that of the matrix at most.
        for (first, count, most) in [(&row, rows, most_rows), (&column, cols, most_columns)] {
            let end = plus(first.clone(), Expr::usize(u64::from(count), span));
            let most = Expr::usize(u64::from(most), span);
            let condition = Expr::compare(CompareOp::Le, end, most).at(span);
            self.emit(StmtKind::Check { condition, fault: Fault::Index }, span);
        }
        let mut elements = Vec::new();
        for j in 0..cols {
            for i in 0..rows {
                let at = |first: &Expr, more: u32| {
                    plus(first.clone(), Expr::usize(u64::from(more), span))
                };
                let step = Step::Element(at(&row, i), at(&column, j));
                elements.push(place.inside(step, Type::Scalar(element)).load());
            }
        }
        let ty = Type::Matrix { element, rows, cols };
        self.node(ExprKind::Matrix(elements), ty, expr.site).map(Some)
    }
}
