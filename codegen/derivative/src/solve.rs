//! Solutions, inverses and determinants. The kernel computes the value; the derivatives follow from it.
//!
//! With A x = b each derivative of x solves A x′ = b′ − A′ x, and so do all of them at once, as columns of one right-hand
//! side. The inverse X has X′ = −X A′ X, and the determinant d has d′ = d · trace(A⁻¹ A′).
//!
//! A factor of a matrix is a [`Factor`]: it solves, but its elements have no derivatives.
//!
//! Must not know: how a kernel computes.

use std::collections::BTreeSet;

use bessemer_ir::{
    Argument, Expr, ExprKind, Function, FunctionId, Kernel, KernelRoutine, Place, Routine, Scalar,
    Span, Step, StmtKind, Type,
};

use crate::place::Route;
use crate::run::{Env, Frame, Run};
use crate::value::{Factor, Value, Word};
use crate::{Problem, Result, float, fold};

/// Module of the DSL's factors by rows.
const FACTORS: &str = "bessemer::linear::factored::lu";

/// Part of a matrix that a kernel reads.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Read {
    Whole,
    /// The lower triangle, mirrored.
    Symmetric,
    Lower,
    Upper,
}

/// A square matrix of which a kernel reads a part, possibly transposed.
struct System {
    words: Vec<Word>,
    size: usize,
    read: Read,
    is_transposed: bool,
}

/// An operand of a kernel: its value and its type; where the kernel writes to it, its place.
struct Operand {
    value: Value,
    ty: Type,
    route: Option<Route>,
}

/// A solution, with the result of its kernel, and the factors that replace the matrix.
struct Solution {
    x: Value,
    solved: Value,
    factors: Option<Value>,
}

impl Read {
    /// Returns the part that a solution reads.
    pub fn of(routine: KernelRoutine) -> Read {
        match routine {
            KernelRoutine::CholeskySolve => Read::Symmetric,
            KernelRoutine::SolveLower | KernelRoutine::TrSolveLower => Read::Lower,
            KernelRoutine::SolveUpper | KernelRoutine::TrSolveUpper => Read::Upper,
            _ => Read::Whole,
        }
    }

    /// Returns true if the part contains an element.
    pub fn has(self, row: usize, col: usize) -> bool {
        match self {
            Read::Whole => true,
            Read::Symmetric | Read::Lower => row >= col,
            Read::Upper => row <= col,
        }
    }
}

impl System {
    /// Returns an element; none if the kernel does not read it.
    fn at(&self, row: usize, col: usize) -> Option<&Word> {
        let (row, col) = if self.is_transposed { (col, row) } else { (row, col) };
        let (row, col) = match self.read {
            Read::Symmetric => (row.max(col), row.min(col)),
            read if !read.has(row, col) => return None,
            _ => (row, col),
        };
        self.words.get(row + col * self.size)
    }
}

fn unknown(span: Span) -> Problem {
    Problem::new(
        span,
        "the elements of a factor have no derivative",
        "solve by the factor, or take `determinant` or `try_inverse` of the matrix itself",
    )
}

impl Run<'_> {
    /// Returns the value, unless it contains a factor.
    pub fn plain(&self, value: Value, span: Span) -> Result<Value> {
        if value.has_factor() { Err(unknown(span)) } else { Ok(value) }
    }

    /// Returns the value of a factor whose elements are read. Its derivatives are unknown, so it must be compared.
    pub fn elements(&self, factor: &Factor, span: Span) -> Result<Place> {
        let place = factor.value.clone().filter(|_| self.compared > 0);
        place.ok_or_else(|| unknown(span))
    }

    /// Returns the value of a function of the DSL's factors by rows; none for other functions, and for a matrix without
    /// derivatives.
    pub fn factored(
        &mut self,
        function: &Function,
        (inner, span): (&mut Env, Span),
    ) -> Result<Option<Value>> {
        if function.module != FACTORS {
            return Ok(None);
        }
        let operand = |index: u32| {
            let local = bessemer_ir::LocalId(index);
            let ty = function.locals.get(index as usize).map(|it| it.ty.clone());
            inner.locals.get(&local).cloned().zip(ty)
        };
        let name = ["factored", "solve_mut"].into_iter().find(|it| function.name.starts_with(it));
        match (name.unwrap_or_default(), operand(0), operand(1)) {
            ("factored", Some((a, _)), _) if a.is_active() || self.backwards => {
                let of = a.words(self.module);
                Ok(Some(Value::Factor(Factor { of, value: None })))
            }
            ("solve_mut", Some((a @ Value::Factor(_), _)), Some((b, ty))) => {
                let Type::Matrix { element: Scalar::Float(element), rows, cols } = ty else {
                    return Ok(None);
                };
                let Some(kernel) = Kernel::new(KernelRoutine::Solve, element, &[rows, cols]) else {
                    return Ok(None);
                };
                let of = Type::Matrix { element: Scalar::Float(element), rows, cols: rows };
                let kernel = self.kernel_function(kernel);
                let a = Operand { value: a, ty: of, route: None };
                let b = Operand { value: b, ty, route: None };
                let Solution { x, solved, .. } = self.solution(kernel, (a, b), span)?;
                inner.locals.insert(bessemer_ir::LocalId(1), x);
                Ok(Some(solved))
            }
            _ => Ok(None),
        }
    }

    /// Returns the value of a kernel.
    pub fn kernel(
        &mut self,
        frame: Frame<'_>,
        env: &mut Env,
        callee: FunctionId,
        arguments: &[Argument],
        expr: &Expr,
    ) -> Result<Value> {
        let module = self.module;
        let name = self.name.clone();
        let mut operands = Vec::new();
        for (index, argument) in arguments.iter().enumerate() {
            let local = module.functions[callee.index()].local(bessemer_ir::LocalId(index as u32));
            let (value, ty, route) = match argument {
                Argument::Value(value) | Argument::Ref(value) => {
                    (self.value(frame, env, value)?, value.ty.clone(), None)
                }
                Argument::RefMut(place) => {
                    let route = self.route(frame, env, place)?;
                    (self.read(env, &route, place.span)?, place.ty.clone(), Some(route))
                }
            };
            let value = self.held(value, &local.name);
            operands.push(Operand { value, ty, route });
        }
        self.name = name;
        let Some(kernel) = &module.functions[callee.index()].kernel else {
            return Ok(Value::Parts(Vec::new()));
        };
        let mut operands = operands.into_iter();
        match (kernel.routine, operands.next(), operands.next()) {
            (KernelRoutine::Product | KernelRoutine::ProductTr, Some(a), Some(b))
            | (KernelRoutine::TrProduct | KernelRoutine::TrMul, Some(a), Some(b)) => {
                let operands = [(a.value, a.ty), (b.value, b.ty)];
                self.product(kernel.routine, operands, expr)
            }
            (KernelRoutine::Determinant, Some(a), None) => self.determinant(callee, a, expr),
            (KernelRoutine::CholeskyLower, Some(a), None) => {
                let a_value = self.plain(a.value, expr.span)?;
                let lower = Argument::Ref(self.whole_value(a_value.clone(), &a.ty));
                let kind = ExprKind::Call(callee, vec![lower]);
                let lower = Expr { kind, ty: a.ty.clone(), span: expr.span };
                let lower = self.variable_of("lower", lower);
                Ok(self.factor(a_value.words(module), lower))
            }
            (KernelRoutine::Cholesky, Some(mut a), None) => {
                a.value = self.plain(a.value, expr.span)?;
                let (lower, factored) = self.changed(callee, &a, "lower", expr.span);
                if let Some(route) = a.route {
                    let factor = self.factor(a.value.words(module), lower);
                    self.write(env, &route, factor, expr.span)?;
                }
                Ok(factored)
            }
            (KernelRoutine::Inverse, Some(mut a), None) => {
                a.value = self.plain(a.value, expr.span)?;
                let route = a.route.take();
                let (inverse, inverted) = self.inverse(callee, a, expr);
                if let Some(route) = route {
                    self.write(env, &route, inverse, expr.span)?;
                }
                Ok(inverted)
            }
            (_, Some(mut a), Some(mut b)) => {
                let routes = [a.route.take(), b.route.take()];
                let Solution { x, solved, factors } = self.solution(callee, (a, b), expr.span)?;
                let written = routes.into_iter().zip([factors, Some(x)]);
                for (route, value) in written {
                    if let (Some(route), Some(value)) = (route, value) {
                        self.write(env, &route, value, expr.span)?;
                    }
                }
                Ok(solved)
            }
            _ => Err(Problem::new(
                expr.span,
                "this kernel has no operands",
                "report it: this is a bug of the generator",
            )),
        }
    }

    /// Returns the value of a product that is a kernel.
    fn product(
        &mut self,
        routine: KernelRoutine,
        [mut a, mut b]: [(Value, Type); 2],
        expr: &Expr,
    ) -> Result<Value> {
        let transposed = |run: &mut Self, (value, ty): (Value, Type)| {
            let Type::Matrix { element, rows, cols } = ty else { return Ok((value, ty)) };
            let turned = Type::Matrix { element, rows: cols, cols: rows };
            let of = Expr { ty: turned.clone(), ..expr.clone() };
            let value = run.routine(Routine::Transpose, vec![(value, ty)], &of)?;
            Ok((value, turned))
        };
        match routine {
            KernelRoutine::ProductTr => b = transposed(self, b)?,
            KernelRoutine::TrProduct => a = transposed(self, a)?,
            _ => {}
        }
        let routine = match routine {
            KernelRoutine::TrMul => Routine::TrMul,
            _ => Routine::Product,
        };
        self.routine(routine, vec![a, b], expr)
    }

    /// Returns the solution of a system, and the result of the kernel that solves it.
    fn solution(
        &mut self,
        kernel: FunctionId,
        (a, b): (Operand, Operand),
        span: Span,
    ) -> Result<Solution> {
        use KernelRoutine::*;
        let module = self.module;
        let b_value = self.plain(b.value, span)?;
        let (of, is_factor) = match a.value.clone() {
            Value::Factor(factor) => (factor.of, true),
            other => (self.plain(other, span)?.words(module), false),
        };
        let routine = self.function_of(kernel).kernel.as_ref().map(|it| it.routine);
        // The way backwards needs the matrix, so its factors do not replace it.
        let stays = self.backwards && routine == Some(LuSolve);
        let kernel = match kernel_of(Solve, &b.ty).filter(|_| stays) {
            Some(solve) => self.kernel_function(solve),
            None => kernel,
        };
        if routine == Some(CholeskySolve) && !is_factor && a.value.is_active() {
            return Err(unknown(span));
        }
        let read = routine.map_or(Read::Whole, Read::of);
        let whole = match (&a.value, routine) {
            (Value::Factor(Factor { value: Some(place), .. }), Some(CholeskySolve)) => place.load(),
            (Value::Factor(_), _) => {
                let words = of.iter().map(|word| word.value.clone());
                self.aggregate(&a.ty, words)
            }
            (other, _) => self.whole_value(other.clone(), &a.ty),
        };
        let whole = self.atom(whole, "matrix");
        let is_transposed = matches!(routine, Some(TrSolveLower | TrSolveUpper));
        // The kernel of the derivatives leaves the matrix as it is.
        let factors = match routine {
            Some(LuSolve) if !stays => Some(self.variable_of("factors", whole.clone())),
            _ => None,
        };
        let kept = match &factors {
            Some(factors) => Argument::RefMut(factors.clone()),
            None => Argument::Ref(whole.clone()),
        };
        let factors = match factors {
            Some(place) => Some(self.factor(of.clone(), place)),
            None => stays.then(|| Value::Factor(Factor { of: of.clone(), value: None })),
        };
        let system = System { words: of, size: rows(&b.ty), read, is_transposed };
        let first = self.whole_value(b_value.clone(), &b.ty);
        let place = self.variable_of("solution", first);
        let arguments = vec![kept, Argument::RefMut(place.clone())];
        let solved = self.call_here(kernel, arguments, span);
        let x: Vec<Word> = Value::Place(place.clone()).words(module);
        let right = self.right_side(&system, &x, &b_value.words(module), span);
        let x = match right {
            None => x,
            Some((variables, right)) => {
                let right = self.variable_of("solution_d", right);
                let routine = routine.map_or(Solve, |it| if it == LuSolve { Solve } else { it });
                if let Some(kernel) = kernel_of(routine, &right.ty) {
                    let kernel = self.kernel_function(kernel);
                    let arguments = vec![Argument::Ref(whole), Argument::RefMut(right.clone())];
                    self.ignored(kernel, arguments, span);
                }
                self.with_columns(x, &variables, &right, span)
            }
        };
        let x = Value::Parts(x.into_iter().map(Value::Leaf).collect());
        Ok(Solution { x, solved, factors })
    }

    /// Returns b′ − A′ x as the columns of each variable; none if all are zero.
    fn right_side(
        &mut self,
        system: &System,
        x: &[Word],
        b: &[Word],
        span: Span,
    ) -> Option<(Vec<u32>, Expr)> {
        let size = system.size;
        let mut sums: Vec<crate::value::Tangents> = Vec::new();
        for at in 0..x.len() {
            let (row, col) = (at % size, at / size);
            let mut sum = b.get(at).map(|it| it.tangents.clone()).unwrap_or_default();
            for k in 0..size {
                let Some(a) = system.at(row, k) else { continue };
                let Some(x) = x.get(k + col * size) else { continue };
                sum = fold::difference(sum, fold::scaled(a.tangents.clone(), &x.value));
            }
            sums.push(sum);
        }
        let variables: BTreeSet<u32> = sums.iter().flat_map(|it| it.keys().copied()).collect();
        let variables: Vec<u32> = variables.into_iter().collect();
        let leaf = x.first()?.value.ty.clone();
        let zero = float(0.0, &leaf, span);
        let column = |variable: &u32| {
            let each = |sum: &crate::value::Tangents| sum.get(variable).unwrap_or(&zero).clone();
            sums.iter().map(each).collect::<Vec<Expr>>()
        };
        let all: Vec<Expr> = variables.iter().flat_map(column).collect();
        let cols = (all.len() / size) as u32;
        let Type::Scalar(element) = leaf else { return None };
        let ty = Type::Matrix { element, rows: size as u32, cols };
        (cols > 0).then_some((variables, Expr { kind: ExprKind::Matrix(all), ty, span }))
    }

    /// Returns words whose derivatives are the columns of a matrix, those of each variable together.
    fn with_columns(
        &self,
        words: Vec<Word>,
        variables: &[u32],
        columns: &Place,
        span: Span,
    ) -> Vec<Word> {
        let (size, count) = (rows(&columns.ty), words.len());
        let each = words.into_iter().enumerate().map(|(at, mut word)| {
            for (index, variable) in variables.iter().enumerate() {
                let (row, col) = (at % size, at / size + index * (count / size));
                let at = |it: usize| Expr::usize(it as u64, span);
                let step = Step::Element(at(row), at(col));
                let place = columns.inside(step, word.value.ty.clone());
                word.tangents.insert(*variable, place.load());
            }
            word
        });
        each.collect()
    }

    /// Returns the inverse, and the result of its kernel.
    fn inverse(&mut self, kernel: FunctionId, a: Operand, expr: &Expr) -> (Value, Value) {
        let module = self.module;
        let (place, inverted) = self.changed(kernel, &a, "inverse", expr.span);
        let of = a.value.words(module);
        let x = Value::Place(place.clone()).words(module);
        let system =
            System { words: of, size: rows(&a.ty), read: Read::Whole, is_transposed: false };
        let Some((variables, right)) = self.right_side(&system, &x, &[], expr.span) else {
            return (Value::at(place), inverted);
        };
        // Without an inverse the matrix stays, and so do its derivatives.
        let zero = float(0.0, &x.first().map_or(Type::F64, |it| it.value.ty.clone()), expr.span);
        let before = variables.iter().flat_map(|variable| {
            let words = system.words.iter();
            words.map(|word| word.tangents.get(variable).unwrap_or(&zero).clone())
        });
        let before = Expr { kind: ExprKind::Matrix(before.collect()), ..right.clone() };
        let columns = self.variable_of("inverse_d", before);
        let ty = right.ty.clone();
        let product = ExprKind::Routine(Routine::Product, vec![place.load(), right]);
        let value = Expr { kind: product, ty, span: expr.span };
        let then =
            bessemer_ir::Block::of(StmtKind::Assign { place: columns.clone(), value }, expr.span);
        let otherwise = bessemer_ir::Block::default();
        if let Value::Leaf(Word { value: condition, .. }) = &inverted {
            self.emit(StmtKind::If { condition: condition.clone(), then, otherwise }, expr.span);
        }
        let words = self.with_columns(x, &variables, &columns, expr.span);
        (Value::Parts(words.into_iter().map(Value::Leaf).collect()), inverted)
    }

    /// Returns the determinant.
    fn determinant(&mut self, kernel: FunctionId, a: Operand, expr: &Expr) -> Result<Value> {
        let a_value = self.plain(a.value, expr.span)?;
        let size = rows(&a.ty);
        let words = a_value.clone().words(self.module);
        let a_is_active = a_value.is_active();
        let m = |row: usize, col: usize| words[row - 1 + (col - 1) * size].clone();
        let active = a_value.is_active() || self.backwards;
        let minor = |run: &mut Self, one: usize, other: usize| {
            let (first, second) =
                (run.mul(m(2, one), m(3, other)), run.mul(m(3, one), m(2, other)));
            let difference = run.sub(first, second);
            run.hold(difference, "minor")
        };
        let word = match size {
            1 if active => m(1, 1),
            2 if active => {
                let (first, second) = (self.mul(m(1, 1), m(2, 2)), self.mul(m(2, 1), m(1, 2)));
                self.sub(first, second)
            }
            3 if active => {
                let minors = [minor(self, 2, 3), minor(self, 1, 3), minor(self, 1, 2)];
                let [one, two, three] = minors;
                let (one, two) = (self.mul(m(1, 1), one), self.mul(m(1, 2), two));
                let sum = self.sub(one, two);
                let three = self.mul(m(1, 3), three);
                self.add(sum, three)
            }
            _ => {
                let whole = self.whole_value(a_value, &a.ty);
                let whole = self.atom(whole, "matrix");
                let arguments = vec![Argument::Ref(whole.clone())];
                let value = self.call_here(kernel, arguments, expr.span);
                let Value::Leaf(mut value) = value else { return Ok(value) };
                if a_is_active {
                    let slopes = self.slopes(whole, size, &value.value, expr.span);
                    for (slope, word) in slopes.into_iter().zip(words) {
                        let more = fold::scaled(word.tangents, &slope);
                        value.tangents = fold::sum(value.tangents, more);
                    }
                    let slope = value.value.clone();
                    value.tangents = fold::scaled(value.tangents, &slope);
                }
                value
            }
        };
        Ok(Value::Leaf(word))
    }

    /// Returns the derivatives of the determinant by the elements, relative to it: the transpose of the inverse. They are
    /// NaN for a singular matrix.
    pub fn slopes(&mut self, whole: Expr, size: usize, like: &Expr, span: Span) -> Vec<Expr> {
        let ty = whole.ty.clone();
        let one = |at: usize| if at.is_multiple_of(size + 1) { 1.0 } else { 0.0 };
        let all = (0..size * size).map(|at| float(one(at), &like.ty, span));
        let identity = Expr { kind: ExprKind::Matrix(all.collect()), ty: ty.clone(), span };
        let inverse = self.variable_of("inverse", identity);
        if let Some(kernel) = kernel_of(KernelRoutine::Solve, &ty) {
            let kernel = self.kernel_function(kernel);
            let arguments = vec![Argument::Ref(whole), Argument::RefMut(inverse.clone())];
            self.ignored(kernel, arguments, span);
        }
        let at = |it: usize| Expr::usize(it as u64, span);
        let all = (0..size * size).map(|index| {
            let step = Step::Element(at(index / size), at(index % size));
            inverse.inside(step, like.ty.clone()).load()
        });
        all.collect()
    }

    /// Calls a kernel that changes its only operand; returns the changed matrix and the kernel's result.
    fn changed(
        &mut self,
        kernel: FunctionId,
        a: &Operand,
        name: &str,
        span: Span,
    ) -> (Place, Value) {
        let first = self.whole_value(a.value.clone(), &a.ty);
        let place = self.variable_of(name, first);
        let result = self.call_here(kernel, vec![Argument::RefMut(place.clone())], span);
        (place, result)
    }

    /// Calls a kernel whose result is a number, a boolean or nothing.
    pub fn call_here(&mut self, kernel: FunctionId, arguments: Vec<Argument>, span: Span) -> Value {
        let function = self.function_of(kernel);
        let (ty, name) = (function.result.clone(), function.kernel.as_ref());
        let name = name.map_or("result", |it| it.routine.result());
        let call = Expr { kind: ExprKind::Call(kernel, arguments), ty: ty.clone(), span };
        if ty == Type::Unit {
            self.emit(StmtKind::Expr(call), span);
            return Value::Parts(Vec::new());
        }
        Value::Leaf(Word::constant(self.bind(name, call)))
    }

    /// Calls a kernel whose result is unused.
    pub fn ignored(&mut self, kernel: FunctionId, arguments: Vec<Argument>, span: Span) {
        let ty = self.function_of(kernel).result.clone();
        let call = Expr { kind: ExprKind::Call(kernel, arguments), ty, span };
        self.emit(StmtKind::Expr(call), span);
    }

    /// Returns the factor of a matrix; one without derivatives is a matrix like others.
    fn factor(&self, of: Vec<Word>, value: Place) -> Value {
        match self.backwards || of.iter().any(|word| !word.tangents.is_empty()) {
            true => Value::Factor(Factor { value: Some(value), of }),
            false => Value::at(value),
        }
    }

    /// Declares a local with a first value; returns its place.
    pub fn variable_of(&mut self, name: &str, first: Expr) -> Place {
        let (ty, span) = (first.ty.clone(), first.span);
        let local = self.declare(name, &ty, span);
        self.emit(StmtKind::Let { local, value: Some(first) }, span);
        Place::local(local, ty, span)
    }
}

/// Returns the kernel of a routine with a square matrix for a right-hand side.
pub fn kernel_of(routine: KernelRoutine, right: &Type) -> Option<Kernel> {
    let Type::Matrix { element: Scalar::Float(element), rows, cols } = *right else { return None };
    Kernel::new(routine, element, &[rows, cols])
}

/// Returns the number of rows of a matrix.
pub fn rows(ty: &Type) -> usize {
    match ty {
        Type::Matrix { rows, .. } => *rows as usize,
        _ => 1,
    }
}
