//! Routines of linear algebra on matrices with derivatives, by elements in the order of each routine.

use bessemer_ir::{Expr, ExprKind, Intrinsic, Routine, Span, StmtKind, Type};

use crate::run::Run;
use crate::value::{Value, Word};
use crate::{Problem, Result, float};

/// Routines whose numbers are operands, or their magnitudes.
const EXTREMES: [Routine; 5] =
    [Routine::Abs, Routine::Inf, Routine::Sup, Routine::Amax, Routine::Amin];

/// A matrix by columns.
struct Matrix {
    words: Vec<Word>,
    rows: usize,
    cols: usize,
}

impl Matrix {
    fn at(&self, row: usize, col: usize) -> Word {
        self.words[row + col * self.rows].clone()
    }

    fn column(&self, col: usize) -> &[Word] {
        &self.words[col * self.rows..(col + 1) * self.rows]
    }
}

impl Run<'_> {
    /// Returns the value of a routine.
    pub fn routine(
        &mut self,
        routine: Routine,
        operands: Vec<(Value, Type)>,
        expr: &Expr,
    ) -> Result<Value> {
        let plain = |(value, ty)| Ok((self.plain(value, expr.span)?, ty));
        let operands = operands.into_iter().map(plain).collect::<Result<Vec<_>>>()?;
        let active = operands.iter().any(|(value, _)| value.is_active());
        let chooses = EXTREMES.contains(&routine);
        if chooses && (active || self.backwards && routine != Routine::Abs) {
            return self.extreme(routine, operands, expr);
        }
        if routine == Routine::Transpose || active || self.backwards {
            return self.by_elements(routine, operands, expr);
        }
        let mut whole = Vec::new();
        for (value, ty) in operands {
            whole.push(self.whole_value(value, &ty));
        }
        let kind = ExprKind::Routine(routine, whole);
        let value = Expr { kind, ty: expr.ty.clone(), span: expr.span };
        if expr.ty.is_word() {
            return Ok(Value::Leaf(Word::constant(value)));
        }
        let name = self.name.clone();
        let local = self.declare(&name, &expr.ty, expr.span);
        self.emit(StmtKind::Let { local, value: Some(value) }, expr.span);
        Ok(Value::at(bessemer_ir::Place::local(local, expr.ty.clone(), expr.span)))
    }

    /// Returns an expression of a value without derivatives.
    pub fn whole_value(&mut self, value: Value, ty: &Type) -> Expr {
        match value {
            Value::Place(place) => place.load(),
            Value::Leaf(word) => word.value,
            parts => {
                let words = parts.words(self.module).into_iter().map(|word| word.value);
                self.aggregate(ty, words)
            }
        }
    }

    fn by_elements(
        &mut self,
        routine: Routine,
        operands: Vec<(Value, Type)>,
        expr: &Expr,
    ) -> Result<Value> {
        let name = self.name.clone();
        let mut matrices = Vec::new();
        for (value, ty) in operands {
            let (rows, cols) = match ty {
                Type::Matrix { rows, cols, .. } => (rows as usize, cols as usize),
                _ => (1, 1),
            };
            let value = self.held(value, &name);
            matrices.push(Matrix { words: value.words(self.module), rows, cols });
        }
        let a = &matrices[0];
        let b = matrices.get(1).unwrap_or(a);
        let span = expr.span;
        let words: Vec<Word> = match routine {
            Routine::Add => self.each(a, b, Run::add),
            Routine::Sub => self.each(a, b, Run::sub),
            Routine::ComponentMul => self.each(a, b, Run::mul),
            Routine::ComponentDiv => self.each(a, b, Run::div),
            Routine::Neg => a.words.iter().map(|it| self.neg(it.clone())).collect(),
            Routine::Scale => a.words.iter().map(|it| self.mul(it.clone(), b.at(0, 0))).collect(),
            Routine::Unscale => a.words.iter().map(|it| self.div(it.clone(), b.at(0, 0))).collect(),
            Routine::Product => {
                let mut words = Vec::new();
                for col in 0..b.cols {
                    for row in 0..a.rows {
                        let mut sum = self.mul(a.at(row, 0), b.at(0, col));
                        for k in 1..a.cols {
                            let term = self.mul(a.at(row, k), b.at(k, col));
                            sum = self.add(term, sum);
                        }
                        words.push(sum);
                    }
                }
                words
            }
            Routine::TrMul => {
                let mut words = Vec::new();
                for col in 0..b.cols {
                    for row in 0..a.cols {
                        words.push(self.dot((a.rows, 1), a.column(row), b.column(col), span));
                    }
                }
                words
            }
            Routine::Transpose => {
                let all = (0..a.rows).flat_map(|row| (0..a.cols).map(move |col| (row, col)));
                all.map(|(row, col)| a.at(row, col)).collect()
            }
            Routine::Dot => vec![self.dot((a.rows, a.cols), &a.words, &b.words, span)],
            Routine::Cross => [(1, 2), (2, 0), (0, 1)]
                .into_iter()
                .map(|(i, j)| {
                    let left = self.mul(a.at(i, 0), b.at(j, 0));
                    let right = self.mul(a.at(j, 0), b.at(i, 0));
                    self.sub(left, right)
                })
                .collect(),
            Routine::Abs => {
                let each = a.words.iter().map(|it| {
                    let value = Expr::intrinsic(Intrinsic::Abs, vec![it.value.clone()]);
                    Word::constant(value)
                });
                each.collect()
            }
            Routine::Inf | Routine::Sup | Routine::Amax | Routine::Amin => {
                return Err(Problem::new(
                    span,
                    "this routine is not computed by elements",
                    "report it: this is a bug of the generator",
                ));
            }
            Routine::NormSquared => vec![self.norm_squared(a, span)],
            Routine::Norm => {
                let square = self.norm_squared(a, span);
                vec![self.root(square)]
            }
        };
        if expr.ty.is_word() {
            return Ok(words.into_iter().next().map_or(Value::Parts(Vec::new()), Value::Leaf));
        }
        Ok(Value::Parts(words.into_iter().map(Value::Leaf).collect()))
    }

    fn each(
        &mut self,
        a: &Matrix,
        b: &Matrix,
        operation: impl Fn(&mut Self, Word, Word) -> Word,
    ) -> Vec<Word> {
        let pairs = a.words.iter().zip(&b.words);
        pairs.map(|(a, b)| operation(self, a.clone(), b.clone())).collect()
    }

    /// Returns the scalar product of operands of a shape.
    fn dot(&mut self, (rows, cols): (usize, usize), a: &[Word], b: &[Word], span: Span) -> Word {
        let terms: Vec<Word> =
            a.iter().zip(b).map(|(a, b)| self.mul(a.clone(), b.clone())).collect();
        match ((rows, cols), terms.as_slice()) {
            ((2, 1), [p, q]) => self.add(p.clone(), q.clone()),
            ((3, 1), [p, q, r]) => {
                let two = self.add(p.clone(), q.clone());
                self.add(two, r.clone())
            }
            ((4, 1), [p, q, r, s]) => {
                let one = self.add(p.clone(), r.clone());
                let other = self.add(q.clone(), s.clone());
                self.add(one, other)
            }
            _ => {
                let ty = terms.first().map_or(Type::F64, |it| it.value.ty.clone());
                let zero = Word::constant(float(0.0, &ty, span));
                let columns = terms.chunks(rows.max(1));
                columns.fold(zero, |sum, column| self.lanes(sum, column, span))
            }
        }
    }

    /// Adds terms in eight lanes.
    fn lanes(&mut self, mut sum: Word, terms: &[Word], span: Span) -> Word {
        let ty = sum.value.ty.clone();
        let zero = Word::constant(float(0.0, &ty, span));
        let mut lanes = vec![zero; 8];
        let blocks = terms.chunks_exact(8);
        let rest = blocks.remainder();
        for block in blocks {
            for (lane, term) in lanes.iter_mut().zip(block) {
                *lane = self.add(lane.clone(), term.clone());
            }
        }
        for lane in 0..4 {
            let two = self.add(lanes[lane].clone(), lanes[lane + 4].clone());
            sum = self.add(sum, two);
        }
        rest.iter().fold(sum, |sum, term| self.add(sum, term.clone()))
    }

    fn norm_squared(&mut self, a: &Matrix, span: Span) -> Word {
        let ty = a.words.first().map_or(Type::F64, |it| it.value.ty.clone());
        let zero = Word::constant(float(0.0, &ty, span));
        (0..a.cols).fold(zero, |sum, col| {
            let column = a.column(col);
            let square = self.dot((a.rows, 1), column, column, span);
            self.add(sum, square)
        })
    }
}
