//! Routines of linear algebra whose result is one number: scalar products in nalgebra's order, and the largest or
//! smallest magnitude.
//!
//! Must not know: how a matrix is stored into a place.

use bessemer_ir::{Expr as Ir, ExprKind, Float, Routine, Scalar, Type};

use super::super::helpers::{Helper, ONE_BLOCK};
use super::super::literal::{self, Readers};
use super::super::matrices::Layout;
use super::super::tree::{Expr, Init};
use super::Lower;
use super::place::shape;
use super::routine::{At, Column, ELEMENTS, Fused, chooser, float, number, small_dot};

/// Largest number of terms for which a scalar product is written out.
const TERMS: u32 = 8;

impl Lower<'_> {
    /// Returns the chosen element of a matrix of a few elements; a loop computes it in a variable of its own otherwise.
    pub(super) fn extreme(&mut self, routine: Routine, operand: &Ir) -> Expr {
        let (scalar, rows, cols) = shape(&operand.ty);
        if rows * cols > ELEMENTS {
            let wanted = if routine == Routine::Amin { "smallest" } else { "largest" };
            let name = self.fresh(wanted);
            self.reduce(routine, operand, &name);
            return Expr::name(name);
        }
        let magnitudes = Fused::Abs(Box::new(self.fuse_operand(operand, None)));
        let helper = chooser(routine, float(scalar));
        let each = (0..cols).flat_map(|column| (0..rows).map(move |row| At::Fixed(row, column)));
        let elements: Vec<Expr> =
            each.map(|at| self.fused_element(&magnitudes, scalar, &at)).collect();
        let chosen =
            elements.into_iter().reduce(|one, other| self.helper(helper, vec![one, other]));
        chosen.expect("matrices are not empty")
    }

    /// Returns true if a value is computed by a loop in a variable of its own.
    pub(super) fn is_reduced(&self, value: &Ir) -> Option<(Routine, Ir)> {
        match &value.kind {
            ExprKind::Routine(routine @ (Routine::Amax | Routine::Amin), operands) => {
                let (_, rows, cols) = shape(&operands[0].ty);
                (rows * cols > ELEMENTS).then(|| (*routine, operands[0].clone()))
            }
            _ => None,
        }
    }

    /// Declares a variable, and chooses among the elements in a loop.
    pub(super) fn reduce(&mut self, routine: Routine, operand: &Ir, name: &str) {
        let (scalar, rows, cols) = shape(&operand.ty);
        let magnitudes = Fused::Abs(Box::new(self.fuse_operand(operand, None)));
        let helper = chooser(routine, float(scalar));
        let first = self.fused_element(&magnitudes, scalar, &At::Fixed(0, 0));
        self.declare(&Type::Scalar(scalar), name, Some(Init::Value(first)), false);
        let step = |lower: &mut Self, at: &At<'_>| {
            let element = lower.fused_element(&magnitudes, scalar, at);
            let chosen = lower.helper(helper, vec![Expr::name(name), element]);
            lower.assign(Expr::name(name), chosen);
        };
        // Which is chosen depends on the order, if one is NaN.
        if magnitudes.is_flat() && self.context.names.layout.has_columns((rows, cols)) {
            self.few(rows * cols, 1 + magnitudes.operations());
            self.count_from("i", 1, rows * cols, |lower, i| step(lower, &At::Counted(&i)));
            return;
        }
        self.count_from("column", 0, cols, |lower, column| {
            lower.count_from("row", 0, rows, |lower, row| step(lower, &At::Cell(&row, &column)));
        });
    }

    /// Returns `a.dot(&b)`.
    pub(super) fn dot_product(&mut self, a: &Ir, b: &Ir) -> Expr {
        let (scalar, rows, cols) = shape(&a.ty);
        let (left, right) = (self.operand(a), self.operand(b));
        let shape = (rows, cols);
        if cols == 1 && (2..=4).contains(&rows) {
            let layout = self.context.names.layout;
            let column = |matrix| Column { layout, matrix, shape, index: 0 };
            return self.dot_columns(float(scalar), &column(left), &column(right));
        }
        if rows >= TERMS || rows * cols > TERMS {
            let sides = [left, right].map(|matrix| self.columns(matrix, scalar, shape));
            return self.dot_call(float(scalar), sides, shape);
        }
        let layout = self.context.names.layout;
        let each = (0..cols).flat_map(|column| (0..rows).map(move |row| (row, column)));
        let terms = each.map(|(row, column)| {
            let left = layout.element(left.clone(), shape, row, column);
            Expr::binary("*", left, layout.element(right.clone(), shape, row, column))
        });
        terms.fold(zero(float(scalar)), |sum, term| Expr::binary("+", sum, term))
    }

    /// Returns `a.norm_squared()`: the scalar products of the columns with themselves, summed from zero. These
    /// products are never −0, so adding zero is not observable.
    pub(super) fn norm_squared(&mut self, a: &Ir) -> Expr {
        let (scalar, rows, cols) = shape(&a.ty);
        let matrix = self.operand(a);
        if cols == 1 {
            let layout = self.context.names.layout;
            let column = Column { layout, matrix, shape: (rows, cols), index: 0 };
            return self.dot_columns(float(scalar), &column, &column);
        }
        let number = |value: u32| Expr::name(format!("{value}U"));
        let matrix = self.columns(matrix, scalar, (rows, cols));
        self.helper(Helper::NormSquared(float(scalar)), vec![matrix, number(rows), number(cols)])
    }

    /// Returns the scalar product of two columns.
    pub(super) fn dot_columns(&mut self, float: Float, a: &Column, b: &Column) -> Expr {
        let rows = a.shape.0;
        if rows >= TERMS {
            let starts = [a, b].map(|column| {
                if !column.layout.has_columns(column.shape) {
                    let index = number(column.index);
                    return self.column(&column.matrix, Scalar::Float(float), column.shape, &index);
                }
                match column.index {
                    0 => column.matrix.clone(),
                    _ => column.element(0).address(),
                }
            });
            return self.dot_call(float, starts, (rows, 1));
        }
        let terms = (0..rows).map(|row| Expr::binary("*", a.element(row), b.element(row)));
        if (2..=4).contains(&rows) {
            return small_dot(terms.collect());
        }
        terms.fold(zero(float), |sum, term| Expr::binary("+", sum, term))
    }

    /// Returns a matrix by columns: itself, or a copy if its layout differs.
    fn columns(&mut self, matrix: Expr, scalar: Scalar, shape: (u32, u32)) -> Expr {
        let layout = self.context.names.layout;
        if layout.has_columns(shape) {
            return matrix;
        }
        let name = self.fresh("columns");
        self.declare(&Layout::Rows.array(scalar, (shape.0 * shape.1, 1)), &name, None, false);
        self.count_from("column", 0, shape.1, |lower, column| {
            lower.count_from("row", 0, shape.0, |lower, row| {
                let to = Layout::Columns.at(Expr::name(&name), shape, row.clone(), column.clone());
                lower.assign(to, layout.at(matrix, shape, row, column));
            });
        });
        Expr::name(name)
    }

    /// Returns a copy of a column whose elements are not adjacent.
    pub(super) fn column(
        &mut self,
        matrix: &Expr,
        scalar: Scalar,
        shape: (u32, u32),
        index: &Expr,
    ) -> Expr {
        let layout = self.context.names.layout;
        let name = self.fresh("column");
        self.declare(&Layout::Rows.array(scalar, (shape.0, 1)), &name, None, false);
        self.count_from("row", 0, shape.0, |lower, row| {
            let from = layout.at(matrix.clone(), shape, row.clone(), index.clone());
            lower.assign(Expr::name(&name).at(row), from);
        });
        Expr::name(name)
    }

    pub(super) fn dot_call(
        &mut self,
        float: Float,
        [a, b]: [Expr; 2],
        (rows, cols): (u32, u32),
    ) -> Expr {
        let one_block = u8::try_from(rows).ok().filter(|rows| ONE_BLOCK.contains(rows));
        if let (Some(rows), 1) = (one_block, cols) {
            return self.helper(Helper::DotOf(float, rows), vec![a, b]);
        }
        let number = |value: u32| Expr::name(format!("{value}U"));
        self.helper(Helper::Dot(float), vec![a, b, number(rows), number(cols)])
    }
}

fn zero(float: Float) -> Expr {
    literal::number(float, 0, Readers::C)
}
