//! Calls of the library that are written out where they stand: small views of matrices, small powers.

use bessemer_ir::tree;
use bessemer_ir::{Expr, ExprKind, Step, Type};

use super::elements::SMALL;
use super::expr::Call;
use super::lowering::Lowering;
use super::{OUR_FAULT, Result, problem};

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
            None => self.small_power(path, Call { arguments, expr }),
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
        let Type::Matrix { rows, cols, .. } = ty else { return Ok(None) };
        if rows.saturating_mul(cols) > SMALL {
            return Ok(None);
        }
        match self.part_from(&arguments[0], (row, column), &ty, expr.site)? {
            Some(part) => self.submatrix_value(&part, expr.site).map(Some),
            None => Ok(None),
        }
    }
}
