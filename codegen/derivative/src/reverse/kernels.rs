//! Bars through solutions, inverses, factors and determinants.
//!
//! With A x = b and the bar r of x, the bar of b solves Aᵀ s = r, and the bar of A is −s xᵀ. The inverse X of A gives the bar
//! R to A as −Xᵀ R Xᵀ. The bar of a Cholesky factor belongs to the lower
//! triangle of its matrix.

use bessemer_ir::{
    Argument, BinaryOp, Block, Expr, ExprKind, FunctionId, KernelRoutine, LocalId, Place, Routine,
    Span, StmtKind, Type, UnaryOp,
};

use super::{Back, Bars};
use crate::run::Run;
use crate::solve::{Read, kernel_of};
use crate::value::Value;
use crate::{Problem, Result, float, fold};

/// A square matrix and its solution, with the bar of the right side.
struct Solved {
    matrix: Place,
    solution: Place,
    right: Place,
    size: usize,
    read: Read,
    /// True if the transpose of the matrix is solved.
    is_transposed: bool,
}

impl Run<'_> {
    /// Goes back through a call of a kernel; `own` is the local of its result.
    pub(super) fn kernel_backwards(
        &mut self,
        back: &mut Back,
        bars: &mut Bars,
        (callee, arguments): (FunctionId, &[Argument]),
        own: Option<LocalId>,
        span: Span,
    ) -> Result<()> {
        use KernelRoutine::*;
        let routine = self.function_of(callee).kernel.as_ref().map(|it| it.routine);
        match (routine, arguments, own) {
            (
                Some(
                    routine @ (Solve | CholeskySolve | SolveLower | SolveUpper | TrSolveLower
                    | TrSolveUpper),
                ),
                [Argument::Ref(a), Argument::RefMut(x)],
                _,
            ) => {
                let Some(right) = self.taken(bars, x) else { return Ok(()) };
                let transposed = match routine {
                    SolveLower => Some(TrSolveLower),
                    SolveUpper => Some(TrSolveUpper),
                    TrSolveLower => Some(SolveLower),
                    TrSolveUpper => Some(SolveUpper),
                    _ => None,
                };
                if routine == CholeskySolve {
                    let arguments = vec![Argument::Ref(a.clone()), Argument::RefMut(right.clone())];
                    self.ignored(callee, arguments, span);
                } else if let Some(kernel) = transposed.and_then(|it| kernel_of(it, &right.ty)) {
                    let kernel = self.kernel_function(kernel);
                    let arguments = vec![Argument::Ref(a.clone()), Argument::RefMut(right.clone())];
                    let solved = self.call_here(kernel, arguments, span);
                    self.unless(solved, &right, span);
                } else {
                    let kind = ExprKind::Routine(Routine::Transpose, vec![a.clone()]);
                    let turned = Expr { kind, ..a.clone() };
                    let arguments = vec![Argument::Ref(turned), Argument::RefMut(right.clone())];
                    let solved = self.call_here(callee, arguments, span);
                    self.unless(solved, &right, span);
                }
                self.give(bars, x, &right);
                if let ExprKind::Load(matrix) = &a.kind {
                    let size = crate::solve::rows(&a.ty);
                    let (matrix, solution) = (matrix.clone(), x.clone());
                    let is_transposed = matches!(routine, TrSolveLower | TrSolveUpper);
                    let read = Read::of(routine);
                    let solved = Solved { matrix, solution, right, size, read, is_transposed };
                    self.matrix_bar(back, bars, &solved);
                }
                Ok(())
            }
            (Some(Inverse), [Argument::RefMut(x)], Some(inverted)) => {
                let Some(right) = self.taken(bars, x) else { return Ok(()) };
                let of = |routine, operands| Expr {
                    kind: ExprKind::Routine(routine, operands),
                    ty: x.ty.clone(),
                    span,
                };
                let turned = of(Routine::Transpose, vec![x.load()]);
                let turned = self.bind("transposed", turned);
                let product = of(Routine::Product, vec![turned.clone(), right.load()]);
                let product = of(Routine::Product, vec![product, turned]);
                let value = of(Routine::Neg, vec![product]);
                let then = Block::of(StmtKind::Assign { place: right.clone(), value }, span);
                let condition = Expr::local(inverted, &Type::BOOL, span);
                let otherwise = Block::default();
                self.emit(StmtKind::If { condition, then, otherwise }, span);
                self.give(bars, x, &right);
                Ok(())
            }
            (Some(CholeskyLower), [Argument::Ref(a)], Some(lower)) => {
                let words =
                    Value::Place(Place::local(lower, a.ty.clone(), span)).words(self.module);
                let each = (0..words.len()).map(|at| bars.remove(&(lower, at))).collect();
                self.push_all(back, bars, a, each, None)
            }
            // In place: the bars of the factor are the matrix's.
            (Some(Cholesky), ..) => Ok(()),
            (Some(Determinant), [Argument::Ref(a)], Some(own)) => {
                let Some(bar) = bars.remove(&(own, 0)) else { return Ok(()) };
                let own = Expr::local(own, &bar.ty, span);
                let size = crate::solve::rows(&a.ty);
                let slopes = self.slopes(a.clone(), size, &own, span);
                let bar = self.bind("bar", Expr::binary(BinaryOp::Mul, bar, own));
                let each = slopes
                    .into_iter()
                    .map(|slope| Some(Expr::binary(BinaryOp::Mul, bar.clone(), slope)));
                self.push_all(back, bars, a, each.collect(), None)
            }
            _ => {
                let changed = arguments.iter().any(|it| match it {
                    Argument::RefMut(place) => bars.keys().any(|key| key.0 == place.root),
                    _ => false,
                });
                let result = own.is_some_and(|own| bars.keys().any(|key| key.0 == own));
                if !changed && !result {
                    return Ok(());
                }
                Err(Problem::new(
                    span,
                    "this solution has no gradient",
                    "solve by `lu` or `cholesky`",
                ))
            }
        }
    }

    /// Takes the bars of a matrix, as a matrix; none if all are zero.
    fn taken(&mut self, bars: &mut Bars, place: &Place) -> Option<Place> {
        let words = Value::Place(place.clone()).words(self.module);
        let mut any = false;
        let each: Vec<Expr> = words
            .iter()
            .enumerate()
            .map(|(at, word)| {
                let bar = bars.remove(&(place.root, at));
                any |= bar.is_some();
                bar.unwrap_or(float(0.0, &word.value.ty, place.span))
            })
            .collect();
        if !any {
            return None;
        }
        let value = self.aggregate(&place.ty, each.into_iter());
        let name = format!("{}_bar", self.locals[place.root.index()].name);
        Some(self.variable_of(&name, value))
    }

    /// Gives the elements of a matrix as the bars of a place.
    fn give(&self, bars: &mut Bars, place: &Place, right: &Place) {
        let words = Value::Place(right.clone()).words(self.module).into_iter().enumerate();
        bars.extend(words.map(|(at, word)| ((place.root, at), word.value)));
    }

    /// Zeroes a matrix without a solution.
    fn unless(&mut self, solved: Value, right: &Place, span: Span) {
        let Value::Leaf(word) = solved else { return };
        let zero = float(0.0, &self.module.leaves(&right.ty)[0], span);
        let value = Expr { kind: ExprKind::Splat(Box::new(zero)), ty: right.ty.clone(), span };
        let then = Block::of(StmtKind::Assign { place: right.clone(), value }, span);
        let condition = Expr::unary(UnaryOp::Not, word.value);
        self.emit(StmtKind::If { condition, then, otherwise: Block::default() }, span);
    }

    /// Adds −s xᵀ to the bars of the part of a matrix that its solution reads; of a transposed one, −x sᵀ.
    fn matrix_bar(&mut self, back: &Back, bars: &mut Bars, of: &Solved) {
        let words = |place: &Place| Value::Place(place.clone()).words(self.module);
        let (x, s) = (words(&of.solution), words(&of.right));
        let elements = words(&of.matrix);
        let size = of.size;
        let product = |row: usize, col: usize| {
            let (row, col) = if of.is_transposed { (col, row) } else { (row, col) };
            let columns = 0..x.len() / size;
            let term = |column: usize| {
                let (s, x) = (&s[row + column * size], &x[col + column * size]);
                Expr::binary(BinaryOp::Mul, s.value.clone(), x.value.clone())
            };
            columns.map(term).reduce(|sum, term| Expr::binary(BinaryOp::Add, sum, term))
        };
        for (at, element) in elements.iter().enumerate() {
            let (row, col) = (at % size, at / size);
            if !of.read.has(row, col) {
                continue;
            }
            let mut bar = product(row, col);
            if of.read == Read::Symmetric && row > col {
                bar = bar.zip(product(col, row)).map(|(a, b)| Expr::binary(BinaryOp::Add, a, b));
            }
            if let (Some(bar), ExprKind::Load(place)) = (bar, &element.value.kind) {
                self.add_bar(back, bars, place, fold::neg(bar));
            }
        }
    }
}
