//! Routines of linear algebra, each in nalgebra's order of operations.
//!
//! Small results are written out, a line per element; larger ones are loops. Nested element-wise routines share one
//! loop.

use bessemer_ir::kernel::{DOTS_WRITTEN_OUT, WRITTEN_OUT};
use bessemer_ir::{BinaryOp, Expr as Ir, ExprKind, Float, Place, Routine, Scalar, Type};

use super::super::helpers::Helper;
use super::super::literal::{self, Readers};
use super::super::matrices::Layout;
use super::super::tree::{Expr, Init, Lines, StmtKind};
use super::Lower;
use super::place::shape;
use crate::routines::{is_element_wise, outer};
use bessemer_ir::effects::reads_place;

/// Largest number of elements for which an element-wise routine is written out.
pub(super) const ELEMENTS: u32 = 4;
/// Largest number of elements of a product that are all computed before one is stored.
const BESIDE: u32 = 16;
/// Largest number of elements for which a transposition is written out.
const MOVES: u32 = 16;

/// A stored matrix, used as it is or transposed.
#[derive(Clone)]
pub(super) struct Stored {
    layout: Layout,
    matrix: Expr,
    shape: (u32, u32),
    transposed: bool,
}

impl Stored {
    /// Returns the element at a row and a column of the matrix, transposed if that is meant.
    fn at(&self, row: Expr, column: Expr) -> Expr {
        let (row, column) = if self.transposed { (column, row) } else { (row, column) };
        self.layout.at(self.matrix.clone(), self.shape, row, column)
    }

    /// Returns true if one index addresses the elements in the order of their use.
    fn is_flat(&self) -> bool {
        self.layout.is_flat(self.shape)
            && (!self.transposed || self.shape.0 == 1 || self.shape.1 == 1)
    }
}

/// Nested element-wise routines as one expression per element.
pub(super) enum Fused {
    Matrix(Stored),
    /// The elements of a few rows, by columns.
    Elements(Vec<Expr>, u32),
    /// Product of a column and a row.
    Outer(Stored, Stored),
    /// A scalar, equal for all elements.
    Scalar(Expr),
    Binary(BinaryOp, Box<Fused>, Box<Fused>),
    Neg(Box<Fused>),
    Abs(Box<Fused>),
    /// One of two elements, by a helper.
    Chosen(Helper, Box<Fused>, Box<Fused>),
}

/// Selection of an element.
pub(super) enum At<'e> {
    Fixed(u32, u32),
    /// By its index in memory.
    Counted(&'e Expr),
    Cell(&'e Expr, &'e Expr),
}

/// A column of a matrix.
#[derive(Clone)]
pub(super) struct Column {
    pub layout: Layout,
    pub matrix: Expr,
    pub shape: (u32, u32),
    pub index: u32,
}

impl Column {
    pub(super) fn element(&self, row: u32) -> Expr {
        self.layout.element(self.matrix.clone(), self.shape, row, self.index)
    }
}

impl Lower<'_> {
    /// Returns true if a routine's result is written out element by element.
    pub(super) fn is_straight(&self, routine: Routine, operands: &[Ir], ty: &Type) -> bool {
        let (_, rows, cols) = shape(ty);
        match routine {
            Routine::Product => rows * cols * shape(&operands[0].ty).2 <= WRITTEN_OUT,
            Routine::TrMul => rows * cols * shape(&operands[0].ty).1 <= DOTS_WRITTEN_OUT,
            Routine::Transpose => rows * cols <= MOVES,
            Routine::Cross => true,
            _ => rows * cols <= ELEMENTS,
        }
    }

    /// Returns the elements of a written-out result by columns, and the layout of their list.
    pub(super) fn straight(
        &mut self,
        routine: Routine,
        operands: &[Ir],
        ty: &Type,
        place: Option<&Place>,
    ) -> (Vec<Expr>, Lines) {
        let (scalar, rows, cols) = shape(ty);
        let each = (0..cols).flat_map(|column| (0..rows).map(move |row| (row, column)));
        match routine {
            Routine::Product => {
                let depth = shape(&operands[0].ty).2;
                let factors = [self.stored(&operands[0]), self.stored(&operands[1])];
                let elements = each.map(|(row, column)| {
                    self.product_element(scalar, &factors, depth, (row, column))
                });
                (elements.collect(), Lines::Each)
            }
            Routine::TrMul | Routine::Transpose | Routine::Cross => {
                let list: Vec<(Expr, (u32, u32))> = operands
                    .iter()
                    .map(|operand| {
                        let (_, rows, cols) = shape(&operand.ty);
                        (self.operand(operand), (rows, cols))
                    })
                    .collect();
                let layout = self.context.names.layout;
                let elements = each.map(|(row, column)| match routine {
                    Routine::TrMul => {
                        let (matrix, shape) = list[0].clone();
                        let a = Column { layout, matrix, shape, index: row };
                        let (matrix, shape) = list[1].clone();
                        let b = Column { layout, matrix, shape, index: column };
                        self.dot_columns(float(scalar), &a, &b)
                    }
                    Routine::Transpose => layout.element(list[0].0.clone(), list[0].1, column, row),
                    _ => self.cross_element(scalar, &list, row + column),
                });
                let elements: Vec<Expr> = elements.collect();
                let group = Lines::Groups(rows as usize);
                let moved = routine == Routine::Transpose && rows > 1 && cols > 1;
                (elements, if moved { group } else { Lines::Each })
            }
            _ => {
                let fused = self.fuse(routine, operands, place);
                let elements = each.map(|(row, column)| {
                    self.fused_element(&fused, scalar, &At::Fixed(row, column))
                });
                (elements.collect(), Lines::Each)
            }
        }
    }

    /// Emits the assignment of a routine's result to `dest`.
    pub(super) fn store_routine(
        &mut self,
        dest: Expr,
        place: Option<&Place>,
        (routine, operands): (Routine, &[Ir]),
        value: &Ir,
    ) {
        let (scalar, rows, cols) = shape(&value.ty);
        let terms = match routine {
            Routine::Product => shape(&operands[0].ty).2,
            Routine::TrMul => shape(&operands[0].ty).1,
            _ => 1,
        };
        // As many elements as registers hold, each of several terms.
        let again = rows > 1 && cols > 1 && terms > 1 && rows * cols <= BESIDE;
        if again && self.is_straight(routine, operands, &value.ty) {
            self.store_beside(&dest, value);
            return;
        }
        if !is_element_wise(routine) && place.is_some_and(|place| reads_place(value, place)) {
            self.store_through_copy(dest, value);
            return;
        }
        if self.is_straight(routine, operands, &value.ty) {
            let (elements, _) = self.straight(routine, operands, &value.ty, place);
            for (index, value) in elements.into_iter().enumerate() {
                let layout = self.context.names.layout;
                self.assign(layout.by_columns(dest.clone(), (rows, cols), index as u32), value);
            }
            return;
        }
        match routine {
            Routine::Product if terms > 1 => {
                self.product_loops(&dest, scalar, operands, (rows, cols))
            }
            Routine::TrMul => self.tr_mul_loops(&dest, scalar, operands, (rows, cols)),
            Routine::Transpose => {
                let from = self.operand(&operands[0]);
                let layout = self.context.names.layout;
                self.count_from("column", 0, cols, |lower, column| {
                    lower.count_from("row", 0, rows, |lower, row| {
                        let value = layout.at(from, (cols, rows), column.clone(), row.clone());
                        lower.assign(layout.at(dest, (rows, cols), row, column), value);
                    });
                });
            }
            _ => {
                let fused = self.fuse(routine, operands, place);
                self.store_each(&dest, &fused, scalar, (rows, cols));
            }
        }
    }

    /// Emits one loop over the elements, or two if the matrices differ in layout.
    fn store_each(&mut self, dest: &Expr, fused: &Fused, scalar: Scalar, shape: (u32, u32)) {
        let layout = self.context.names.layout;
        let operations = fused.operations();
        if fused.is_flat() && layout.is_flat(shape) {
            self.few(shape.0 * shape.1, operations);
            self.count_up(shape.0 * shape.1, dest, |lower, index| {
                let value = lower.fused_element(fused, scalar, &At::Counted(&index));
                lower.assign(dest.clone().at(index), value);
            });
            return;
        }
        let cell = |lower: &mut Self, row: Expr, column: Expr| {
            let value = lower.fused_element(fused, scalar, &At::Cell(&row, &column));
            lower.assign(layout.at(dest.clone(), shape, row, column), value);
        };
        let rows = |lower: &mut Self, column: Expr| match shape.0 {
            1 => cell(lower, Expr::name("0"), column),
            rows => {
                lower.few(rows, operations);
                lower.count_from("row", 0, rows, |lower, row| cell(lower, row, column));
            }
        };
        match shape.1 {
            1 => rows(self, Expr::name("0")),
            columns => self.count_from("column", 0, columns, rows),
        }
    }

    /// Writes an unrolled product to `dest` after all of it is computed. A compiler cannot know that no operand is in
    /// `dest`, and would reload each after every element.
    fn store_beside(&mut self, dest: &Expr, value: &Ir) {
        let (_, rows, cols) = shape(&value.ty);
        let block = self.scope(|lower| {
            let name = lower.fresh("product");
            lower.define(&value.ty, &name, value, true);
            let layout = lower.context.names.layout;
            let part = |whole: Expr, index: u32| match layout {
                Layout::Array => Layout::Array.by_columns(whole, (rows, cols), index),
                _ => whole.at(number(index)),
            };
            for index in 0..rows * cols {
                lower.assign(part(dest.clone(), index), part(Expr::name(&name), index));
            }
        });
        self.emit(StmtKind::Block(block));
    }

    fn fuse(&mut self, routine: Routine, operands: &[Ir], place: Option<&Place>) -> Fused {
        let op = match routine {
            Routine::Add => BinaryOp::Add,
            Routine::Sub => BinaryOp::Sub,
            Routine::Scale | Routine::ComponentMul => BinaryOp::Mul,
            Routine::Unscale | Routine::ComponentDiv => BinaryOp::Div,
            Routine::Neg => return Fused::Neg(Box::new(self.fuse_operand(&operands[0], place))),
            Routine::Abs => return Fused::Abs(Box::new(self.fuse_operand(&operands[0], place))),
            Routine::Inf | Routine::Sup => {
                let element = float(shape(&operands[0].ty).0);
                let left = self.fuse_operand(&operands[0], place);
                let right = self.fuse_operand(&operands[1], place);
                return Fused::Chosen(chooser(routine, element), Box::new(left), Box::new(right));
            }
            Routine::Product => {
                return Fused::Outer(self.stored(&operands[0]), self.stored(&operands[1]));
            }
            _ => unreachable!("{routine:?} is not element-wise"),
        };
        let left = self.fuse_operand(&operands[0], place);
        let right = self.fuse_operand(&operands[1], place);
        Fused::Binary(op, Box::new(left), Box::new(right))
    }

    pub(super) fn fuse_operand(&mut self, operand: &Ir, place: Option<&Place>) -> Fused {
        if operand.ty.is_word() {
            return Fused::Scalar(self.once("factor", operand, place));
        }
        match &operand.kind {
            ExprKind::Routine(routine, operands)
                if is_element_wise(*routine) || outer(*routine, operands) =>
            {
                self.fuse(*routine, operands, place)
            }
            ExprKind::Matrix(items) => {
                let (_, rows, _) = shape(&operand.ty);
                Fused::Elements(items.iter().map(|item| self.word(item)).collect(), rows)
            }
            ExprKind::Splat(item) => Fused::Scalar(self.once("factor", item, place)),
            _ => Fused::Matrix(self.stored(operand)),
        }
    }

    /// Returns a matrix operand; for a transposition, the original matrix.
    fn stored(&mut self, operand: &Ir) -> Stored {
        let (inner, transposed) = match &operand.kind {
            ExprKind::Routine(Routine::Transpose, list) => (&list[0], true),
            _ => (operand, false),
        };
        let (_, rows, cols) = shape(&inner.ty);
        let layout = self.context.names.layout;
        Stored { layout, matrix: self.operand(inner), shape: (rows, cols), transposed }
    }

    pub(super) fn fused_element(&mut self, fused: &Fused, scalar: Scalar, at: &At<'_>) -> Expr {
        let ty = Type::Scalar(scalar);
        match (fused, at) {
            (Fused::Scalar(value), _) => value.clone(),
            (Fused::Matrix(stored), At::Fixed(row, column)) => {
                stored.at(number(*row), number(*column))
            }
            (Fused::Elements(items, rows), At::Fixed(row, column)) => {
                items[(row + rows * column) as usize].clone()
            }
            (Fused::Elements(..), _) => unreachable!("few elements are written out"),
            (Fused::Matrix(stored), At::Counted(index)) => {
                stored.matrix.clone().at((*index).clone())
            }
            (Fused::Matrix(stored), At::Cell(row, column)) => {
                stored.at((*row).clone(), (*column).clone())
            }
            (Fused::Outer(a, b), at) => {
                let (row, column) = match at {
                    At::Fixed(row, column) => (number(*row), number(*column)),
                    At::Cell(row, column) => ((*row).clone(), (*column).clone()),
                    At::Counted(_) => unreachable!("an outer product is not flat"),
                };
                let (left, right) = (a.at(row, number(0)), b.at(number(0), column));
                self.arithmetic(BinaryOp::Mul, &ty, left, right)
            }
            (Fused::Neg(inner), _) => {
                let inner = self.fused_element(inner, scalar, at);
                super::word::narrowed(&ty, Expr::unary("-", inner))
            }
            (Fused::Abs(inner), _) => {
                let inner = self.fused_element(inner, scalar, at);
                self.math("fabs", float(scalar), vec![inner])
            }
            (Fused::Chosen(helper, left, right), _) => {
                let left = self.fused_element(left, scalar, at);
                let right = self.fused_element(right, scalar, at);
                self.helper(*helper, vec![left, right])
            }
            (Fused::Binary(op, left, right), _) => {
                let less_nothing = *op == BinaryOp::Sub && is_nothing(right, scalar, at);
                let left = self.fused_element(left, scalar, at);
                if less_nothing {
                    return left;
                }
                let right = self.fused_element(right, scalar, at);
                self.arithmetic(*op, &ty, left, right)
            }
        }
    }

    /// Returns `a[r][0]*b[0][c] + a[r][1]*b[1][c] + …`, summed in this order.
    fn product_element(
        &mut self,
        scalar: Scalar,
        [a, b]: &[Stored; 2],
        depth: u32,
        (row, column): (u32, u32),
    ) -> Expr {
        let ty = Type::Scalar(scalar);
        let mut sum: Option<Expr> = None;
        for k in 0..depth {
            let left = a.at(number(row), number(k));
            let right = b.at(number(k), number(column));
            let term = self.arithmetic(BinaryOp::Mul, &ty, left, right);
            sum = Some(match sum {
                None => term,
                Some(sum) => self.arithmetic(BinaryOp::Add, &ty, sum, term),
            });
        }
        sum.expect("matrices are not empty")
    }

    fn cross_element(&mut self, scalar: Scalar, list: &[(Expr, (u32, u32))], index: u32) -> Expr {
        let ty = Type::Scalar(scalar);
        let (y, z) = ((index + 1) % 3, (index + 2) % 3);
        let part =
            |which: usize, index: u32| list[which].0.clone().at(Expr::name(index.to_string()));
        let left = self.arithmetic(BinaryOp::Mul, &ty, part(0, y), part(1, z));
        let right = self.arithmetic(BinaryOp::Mul, &ty, part(0, z), part(1, y));
        self.arithmetic(BinaryOp::Sub, &ty, left, right)
    }

    fn product_loops(
        &mut self,
        dest: &Expr,
        scalar: Scalar,
        operands: &[Ir],
        (rows, cols): (u32, u32),
    ) {
        let ty = Type::Scalar(scalar);
        let depth = shape(&operands[0].ty).2;
        let (a, b) = (self.stored(&operands[0]), self.stored(&operands[1]));
        self.count_from("column", 0, cols, |lower, column| {
            lower.count_from("row", 0, rows, |lower, row| {
                let term = |lower: &mut Self, k: Expr| {
                    let left = a.at(row.clone(), k.clone());
                    let right = b.at(k, column.clone());
                    lower.arithmetic(BinaryOp::Mul, &ty, left, right)
                };
                let first = term(lower, Expr::name("0"));
                let sum = lower.fresh("sum");
                lower.declare(&ty, &sum, Some(Init::Value(first)), false);
                lower.count_from("k", 1, depth, |lower, k| {
                    let term = term(lower, k);
                    let total = lower.arithmetic(BinaryOp::Add, &ty, Expr::name(&sum), term);
                    lower.assign(Expr::name(&sum), total);
                });
                let layout = lower.context.names.layout;
                let place = layout.at(dest.clone(), (rows, cols), row.clone(), column.clone());
                lower.assign(place, Expr::name(&sum));
            });
        });
    }

    fn tr_mul_loops(
        &mut self,
        dest: &Expr,
        scalar: Scalar,
        operands: &[Ir],
        (rows, cols): (u32, u32),
    ) {
        let depth = shape(&operands[0].ty).1;
        let (a, b) = (self.operand(&operands[0]), self.operand(&operands[1]));
        let layout = self.context.names.layout;
        let pick = |matrix: &Expr, cols: u32, index: &Expr, k: u32| {
            layout.at(matrix.clone(), (depth, cols), number(k), index.clone())
        };
        self.count_from("column", 0, cols, |lower, column| {
            lower.count_from("row", 0, rows, |lower, row| {
                let value = if (2..=4).contains(&depth) {
                    let terms = (0..depth).map(|k| {
                        Expr::binary("*", pick(&a, rows, &row, k), pick(&b, cols, &column, k))
                    });
                    small_dot(terms.collect())
                } else {
                    let ends =
                        [(&a, rows, &row), (&b, cols, &column)].map(|(matrix, cols, index)| {
                            if layout.has_columns((depth, cols)) {
                                return pick(matrix, cols, index, 0).address();
                            }
                            lower.column(matrix, scalar, (depth, cols), index)
                        });
                    lower.dot_call(float(scalar), ends, (depth, 1))
                };
                lower.assign(layout.at(dest.clone(), (rows, cols), row, column), value);
            });
        });
    }
}

impl Fused {
    /// Returns the number of operations on each element.
    pub(super) fn operations(&self) -> u32 {
        match self {
            Fused::Matrix(_) | Fused::Elements(..) | Fused::Scalar(_) => 0,
            Fused::Outer(..) => 1,
            Fused::Binary(_, left, right) | Fused::Chosen(_, left, right) => {
                1 + left.operations() + right.operations()
            }
            Fused::Neg(inner) | Fused::Abs(inner) => 1 + inner.operations(),
        }
    }

    /// Returns true if one index addresses all operands.
    pub(super) fn is_flat(&self) -> bool {
        match self {
            Fused::Matrix(stored) => stored.is_flat(),
            Fused::Outer(..) | Fused::Elements(..) => false,
            Fused::Scalar(_) => true,
            Fused::Binary(_, left, right) | Fused::Chosen(_, left, right) => {
                left.is_flat() && right.is_flat()
            }
            Fused::Neg(inner) | Fused::Abs(inner) => inner.is_flat(),
        }
    }
}

/// Returns true for an element that is written as +0.0, which subtracted changes no number.
fn is_nothing(fused: &Fused, scalar: Scalar, at: &At<'_>) -> bool {
    match (fused, scalar, at) {
        (Fused::Elements(items, rows), Scalar::Float(float), At::Fixed(row, column)) => {
            items[(row + rows * column) as usize] == literal::number(float, 0, Readers::C)
        }
        _ => false,
    }
}

pub(super) fn number(value: u32) -> Expr {
    Expr::name(value.to_string())
}

pub(super) fn float(scalar: Scalar) -> Float {
    match scalar {
        Scalar::Float(float) => float,
        _ => unreachable!("the validator asks for floats"),
    }
}

/// Sums two, three or four terms in nalgebra's order.
pub(super) fn small_dot(terms: Vec<Expr>) -> Expr {
    let add = |a, b| Expr::binary("+", a, b);
    match <[Expr; 4]>::try_from(terms) {
        Ok([a, b, c, d]) => add(add(a, c), add(b, d)),
        Err(terms) => terms.into_iter().reduce(add).expect("two or three terms"),
    }
}

/// Returns the helper that chooses one of two numbers.
pub(super) fn chooser(routine: Routine, float: Float) -> Helper {
    match routine {
        Routine::Inf => Helper::Lower(float),
        Routine::Amin => Helper::SmallerMagnitude(float),
        Routine::Amax => Helper::LargerMagnitude(float),
        _ => Helper::Upper(float),
    }
}
