//! Arithmetic of matrices of integers: loops over their elements, where each operation is checked as it is
//! of two integers.
//!
//! The order is nalgebra's: a product adds its terms in the order of the columns of its left factor.
//!
//! Absent: matrices of floats, which have routines and kernels.

use bessemer_ir::tree::Site;
use bessemer_ir::{
    BinaryOp, Block, Expr, ExprKind, LocalId, Place, Routine, Span, Step, StmtKind, Type, UnaryOp,
};

use super::lowering::Lowering;
use super::words;
use super::{OUR_FAULT, Result, problem};

/// The operation of a routine on two elements, on an element and a number, or on one.
enum Each {
    Negated,
    Joined(BinaryOp),
    Terms,
}

impl Each {
    fn operands(&self) -> usize {
        if matches!(self, Each::Negated) { 1 } else { 2 }
    }
}

impl Lowering<'_, '_> {
    /// A routine of matrices of integers.
    pub(super) fn integer_routine(
        &mut self,
        routine: Routine,
        values: Vec<Expr>,
        ty: Type,
        site: Site,
    ) -> Result<Expr> {
        let (name, each) = match routine {
            Routine::Neg => (words::NEGATIVE, Each::Negated),
            Routine::Add => (words::SUM, Each::Joined(BinaryOp::Add)),
            Routine::Sub => (words::DIFFERENCE, Each::Joined(BinaryOp::Sub)),
            Routine::ComponentMul => (words::PRODUCT, Each::Joined(BinaryOp::Mul)),
            Routine::ComponentDiv => (words::QUOTIENT, Each::Joined(BinaryOp::Div)),
            Routine::Scale => (words::SCALED, Each::Joined(BinaryOp::Mul)),
            Routine::Unscale => (words::QUOTIENT, Each::Joined(BinaryOp::Div)),
            Routine::Product => (words::PRODUCT, Each::Terms),
            _ => {
                let remedy = "write a loop over their elements";
                return problem(site, "this takes matrices of `f64` or `f32`", remedy);
            }
        };
        let (Type::Matrix { element, rows, cols }, true) = (&ty, values.len() == each.operands())
        else {
            return problem(site, "this is no matrix", OUR_FAULT);
        };
        let mut operands = Vec::new();
        for value in values {
            operands.push(match value.is_literal() {
                true => value,
                false => {
                    let mut place = self.hold(value);
                    self.keep_indices(&mut place, |index| !index.is_literal());
                    place.load()
                }
            });
        }
        let span = self.span(site);
        let elements = Elements { operands, scalar: Type::Scalar(*element), span };
        let result = self.temporary_place(name, self.zero(&ty, span));
        let row = self.counter_of(*rows, "row", span);
        let col = self.counter_of(*cols, "col", span);
        let mut counters = vec![(row, *rows), (col, *cols)];
        let at = (elements.index(row), elements.index(col));
        let place = elements.cell(&result, at.clone());
        let value = match each {
            Each::Negated => Expr::unary(UnaryOp::Neg, elements.at(0, at)).at(span),
            Each::Joined(op) => elements.joined(op, elements.at(0, at.clone()), elements.at(1, at)),
            Each::Terms => {
                let terms = elements.terms();
                let k = self.counter_of(terms, "k", span);
                counters.insert(0, (k, terms));
                let ((row, col), k) = (at, elements.index(k));
                let factors = (elements.at(0, (row, k.clone())), elements.at(1, (k, col)));
                let term = elements.joined(BinaryOp::Mul, factors.0, factors.1);
                elements.joined(BinaryOp::Add, place.load(), term)
            }
        };
        let mut body = Block::of(StmtKind::Assign { place, value }, span);
        for (counter, count) in counters {
            if let Some(counter) = counter {
                let count = Expr::usize(u64::from(count), span);
                body = Block::of(StmtKind::for_below(counter, count, body), span);
            }
        }
        self.out.extend(body.0);
        Ok(result.load())
    }

    /// A counter, unless there is one row or column.
    fn counter_of(&mut self, count: u32, name: &str, span: Span) -> Option<LocalId> {
        (count > 1).then(|| self.counter(name, span))
    }
}

/// The operands, element by element.
struct Elements {
    operands: Vec<Expr>,
    scalar: Type,
    span: Span,
}

impl Elements {
    fn index(&self, counter: Option<LocalId>) -> Expr {
        let zero = || Expr::usize(0, self.span);
        counter.map_or_else(zero, |counter| Expr::local(counter, &Type::USIZE, self.span))
    }

    fn cell(&self, matrix: &Place, (row, col): (Expr, Expr)) -> Place {
        matrix.inside(Step::Element(row, col), self.scalar.clone())
    }

    /// An operand at a row and a column; a number is the same at each.
    fn at(&self, operand: usize, at: (Expr, Expr)) -> Expr {
        let operand = &self.operands[operand];
        match &operand.kind {
            ExprKind::Load(place) if matches!(place.ty, Type::Matrix { .. }) => {
                self.cell(place, at).load()
            }
            _ => operand.clone(),
        }
    }

    /// How many terms an element of the product has.
    fn terms(&self) -> u32 {
        match self.operands[0].ty {
            Type::Matrix { cols, .. } => cols,
            _ => 0,
        }
    }

    fn joined(&self, op: BinaryOp, one: Expr, other: Expr) -> Expr {
        Expr::binary(op, one, other).at(self.span)
    }
}
