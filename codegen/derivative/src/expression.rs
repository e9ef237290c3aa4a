//! Expressions: values with derivatives, and calls.

use bessemer_ir::{
    Argument, BinaryOp, Expr, ExprKind, Function, FunctionId, LocalId, Span, StmtKind, Type,
    UnaryOp,
};

use crate::run::{Env, Frame, Run};
use crate::value::{Tangents, Value, Word};
use crate::{Problem, Result, fold, known, rules};

/// Returns the value of a literal that is no float.
pub fn literal(expr: &Expr) -> Option<i128> {
    let ExprKind::Literal(word) = expr.kind else { return None };
    match &expr.ty {
        Type::Scalar(bessemer_ir::Scalar::Float(_)) => None,
        ty => Some(ty.as_int().map_or_else(|| i128::from(word), |int| int.from_word(word))),
    }
}

impl Run<'_> {
    /// Returns the value of an expression that has no derivative: a number that is no float, a boolean, an enum.
    pub fn scalar(&mut self, frame: Frame<'_>, env: &mut Env, expr: &Expr) -> Result<Expr> {
        self.compared += 1;
        let word = self.word(frame, env, expr);
        self.compared -= 1;
        Ok(word?.value)
    }

    /// Returns the value of an expression of one word.
    pub fn word(&mut self, frame: Frame<'_>, env: &mut Env, expr: &Expr) -> Result<Word> {
        match self.value(frame, env, expr)? {
            Value::Leaf(word) => Ok(word),
            _ => Err(Problem::new(
                expr.span,
                "this value has parts where a number is expected",
                "report it: this is a bug of the generator",
            )),
        }
    }

    /// Returns the value of an expression.
    pub fn value(&mut self, frame: Frame<'_>, env: &mut Env, expr: &Expr) -> Result<Value> {
        let module = self.module;
        let leaf = |value: Expr| Ok(Value::Leaf(Word::constant(value)));
        match &expr.kind {
            ExprKind::Literal(_) => leaf(expr.clone()),
            ExprKind::Const(id) => {
                let constant = &module.consts[id.index()];
                if expr.ty.as_float().is_some() {
                    return leaf(expr.clone());
                }
                let leaves = module.leaves(&expr.ty);
                let words = leaves.into_iter().zip(&constant.words);
                let mut words =
                    words.map(|(ty, word)| Word::constant(Expr::literal(*word, ty, expr.span)));
                Value::of(module, &expr.ty, &mut words).ok_or_else(|| {
                    Problem::new(expr.span, "this constant has no value", "write its value")
                })
            }
            ExprKind::Load(place) => {
                let route = self.route(frame, env, place)?;
                self.read(env, &route, expr.span)
            }
            ExprKind::Unary(op, operand) => {
                let operand = self.word(frame, env, operand)?;
                Ok(Value::Leaf(match op {
                    UnaryOp::Neg if expr.ty.as_float().is_some() => self.neg(operand),
                    _ => Word::constant(fold::unary(*op, operand.value)),
                }))
            }
            ExprKind::Binary(op, a, b) => {
                let a = self.word(frame, env, a)?;
                let b = self.word(frame, env, b)?;
                if expr.ty.as_float().is_none() {
                    return leaf(fold::binary(*op, a.value, b.value));
                }
                Ok(Value::Leaf(match op {
                    BinaryOp::Add => self.add(a, b),
                    BinaryOp::Sub => self.sub(a, b),
                    BinaryOp::Mul => self.mul(a, b),
                    BinaryOp::Div => self.div(a, b),
                    _ => self.rem(a, b),
                }))
            }
            ExprKind::Compare(op, a, b) => {
                let a = self.scalar(frame, env, a)?;
                let b = self.scalar(frame, env, b)?;
                leaf(fold::compare(*op, a, b))
            }
            ExprKind::Logic(op, a, b) => {
                let a = self.scalar(frame, env, a)?;
                let stops = *op == bessemer_ir::LogicOp::Or;
                if let Some(known) = literal(&a) {
                    return if (known != 0) == stops { leaf(a) } else { self.value(frame, env, b) };
                }
                let (block, b) = self.captured(|run| run.scalar(frame, env, b))?;
                if block.0.is_empty() {
                    return leaf(Expr::logic(*op, a, b));
                }
                // The statements of the second operand run only if it decides.
                let local = self.declare("condition", &Type::BOOL, expr.span);
                self.emit(StmtKind::Let { local, value: None }, expr.span);
                let assign = |value: Expr| {
                    let place = bessemer_ir::Place::local(local, Type::BOOL, expr.span);
                    bessemer_ir::Stmt::new(StmtKind::Assign { place, value }, expr.span)
                };
                let mut decides = block;
                decides.0.push(assign(b));
                let decided = bessemer_ir::Block(vec![assign(Expr::bool(stops, expr.span))]);
                let (then, otherwise) = if stops { (decided, decides) } else { (decides, decided) };
                self.emit(StmtKind::If { condition: a, then, otherwise }, expr.span);
                leaf(Expr::local(local, &Type::BOOL, expr.span))
            }
            ExprKind::Cast(operand) => {
                let Word { value, tangents } = self.word(frame, env, operand)?;
                let value = fold::cast(value, &expr.ty);
                let tangents = match expr.ty.as_float() {
                    Some(_) => {
                        let cast = |(variable, it): (u32, Expr)| (variable, it.cast(&expr.ty));
                        tangents.into_iter().map(cast).collect()
                    }
                    None => Tangents::new(),
                };
                Ok(Value::Leaf(Word { value, tangents }))
            }
            ExprKind::Intrinsic(op, operands) => {
                let operands = operands.iter().map(|it| self.word(frame, env, it));
                let operands = operands.collect::<Result<Vec<_>>>()?;
                Ok(Value::Leaf(self.intrinsic(*op, operands, expr)?))
            }
            ExprKind::Call(callee, arguments) => self.call(frame, env, *callee, arguments, expr),
            ExprKind::Struct(parts) | ExprKind::Array(parts) | ExprKind::Matrix(parts) => {
                let parts = parts.iter().map(|it| self.value(frame, env, it));
                Ok(Value::Parts(parts.collect::<Result<_>>()?))
            }
            ExprKind::Splat(operand) => {
                let value = self.value(frame, env, operand)?;
                let value = self.plain(value, expr.span)?;
                let name = self.name.clone();
                let value = self.held(value, &name);
                let count = match &expr.ty {
                    Type::Array { len, .. } => *len,
                    Type::Matrix { rows, cols, .. } => rows * cols,
                    _ => 0,
                };
                Ok(Value::Parts(vec![value; count as usize]))
            }
            ExprKind::Routine(routine, operands) => {
                let mut values = Vec::new();
                for operand in operands {
                    values.push((self.value(frame, env, operand)?, operand.ty.clone()));
                }
                self.routine(*routine, values, expr)
            }
        }
    }

    /// Returns the value of a call.
    fn call(
        &mut self,
        frame: Frame<'_>,
        env: &mut Env,
        callee: FunctionId,
        arguments: &[Argument],
        expr: &Expr,
    ) -> Result<Value> {
        let module = self.module;
        let function = &module.functions[callee.index()];
        if function.kernel.is_some() {
            return self.kernel(frame, env, callee, arguments, expr);
        }
        if function.attributes.external.is_some() {
            return Err(Problem::new(
                expr.span,
                format!("`{}` is the firmware's, and has no derivative", function.name),
                "pass its result as an argument",
            ));
        }
        let name = self.name.clone();
        let mut inner = Env { passes: env.passes, ..Env::default() };
        let mut borrowed = Vec::new();
        let mut words = Vec::new();
        for (index, argument) in arguments.iter().enumerate() {
            let local = LocalId(index as u32);
            let parameter = function.local(local).name.clone();
            let value = match argument {
                Argument::Value(value) | Argument::Ref(value) => self.value(frame, env, value)?,
                Argument::RefMut(place) => {
                    let route = self.route(frame, env, place)?;
                    let value = self.read(env, &route, place.span)?;
                    borrowed.push((local, route));
                    value
                }
            };
            let value = self.held(value, &parameter);
            if let Value::Leaf(word) = &value {
                words.push(word.clone());
            }
            inner.locals.insert(local, value);
        }
        self.name.clone_from(&name);
        if rules::is_mathematics(&function.module)
            && words.len() == arguments.len()
            && let Some(value) = self.elementary_function(&function.name, words, expr)?
        {
            return Ok(value);
        }
        self.inlined(function, inner, (env, borrowed), expr.span)
    }

    /// Evaluates a function in place of its call.
    fn inlined(
        &mut self,
        function: &Function,
        inner: Env,
        (env, borrowed): (&mut Env, Vec<(LocalId, crate::place::Route)>),
        span: Span,
    ) -> Result<Value> {
        let compared = std::mem::take(&mut self.compared);
        // A number, vector or matrix is named after its function, a struct after the value that the call is for.
        let name = match function.result {
            Type::Struct(_) => self.name.clone(),
            _ => function.name.clone(),
        };
        let outer = (self.result_name.replace(name), self.name.clone());
        let mut inner = inner;
        let inner = match self.factored(function, (&mut inner, span)) {
            Ok(Some(result)) => Ok(Env { result: Some(result), ..inner }),
            Ok(None) => self.function(function, inner),
            Err(problem) => Err(problem),
        };
        self.compared = compared;
        (self.result_name, self.name) = outer;
        let inner = inner.map_err(|problem| match problem.span.file {
            // A place in another file is of no help; the call is.
            file if file != span.file => Problem { span, ..problem },
            _ => problem,
        })?;
        for (local, route) in borrowed {
            if let Some(value) = inner.locals.get(&local) {
                self.write(env, &route, value.clone(), span)?;
            }
        }
        Ok(inner.result.unwrap_or(Value::Parts(Vec::new())))
    }
}

/// Operations of numbers with their derivatives.
impl Run<'_> {
    /// Returns `-a`.
    pub fn neg(&mut self, a: Word) -> Word {
        let tangents = a.tangents.into_iter().map(|(variable, it)| (variable, fold::neg(it)));
        Word { value: Expr::unary(UnaryOp::Neg, a.value), tangents: tangents.collect() }
    }

    /// Returns `a + b`.
    pub fn add(&mut self, a: Word, b: Word) -> Word {
        let tangents = fold::sum(a.tangents, b.tangents);
        Word { value: Expr::binary(BinaryOp::Add, a.value, b.value), tangents }
    }

    /// Returns `a - b`.
    pub fn sub(&mut self, a: Word, b: Word) -> Word {
        let tangents = fold::difference(a.tangents, b.tangents);
        Word { value: Expr::binary(BinaryOp::Sub, a.value, b.value), tangents }
    }

    /// Returns `a * b`; its derivative is `b * a′ + a * b′`.
    pub fn mul(&mut self, mut a: Word, mut b: Word) -> Word {
        let name = self.name.clone();
        if !b.tangents.is_empty() {
            a.value = self.atom(a.value, &name);
        }
        if !a.tangents.is_empty() {
            b.value = self.atom(b.value, &name);
        }
        let tangents =
            fold::sum(fold::scaled(a.tangents, &b.value), fold::scaled(b.tangents, &a.value));
        Word { value: Expr::binary(BinaryOp::Mul, a.value, b.value), tangents }
    }

    /// Returns `q = a / b`; its derivative is `(a′ - q * b′) / b`.
    pub fn div(&mut self, a: Word, mut b: Word) -> Word {
        if a.tangents.is_empty() && b.tangents.is_empty() {
            return Word::constant(Expr::binary(BinaryOp::Div, a.value, b.value));
        }
        let name = self.name.clone();
        b.value = self.atom(b.value, &name);
        let mut value = Expr::binary(BinaryOp::Div, a.value, b.value.clone());
        if !b.tangents.is_empty() {
            value = self.atom(value, &name);
        }
        let tangents = fold::difference(a.tangents, fold::scaled(b.tangents, &value));
        let tangents = tangents
            .into_iter()
            .map(|(variable, it)| (variable, Expr::binary(BinaryOp::Div, it, b.value.clone())));
        Word { value, tangents: tangents.collect() }
    }

    /// Returns `a % b`; its derivative is `a′ - (a / b).trunc() * b′`.
    fn rem(&mut self, mut a: Word, mut b: Word) -> Word {
        let mut tangents = a.tangents;
        if !b.tangents.is_empty() {
            let name = self.name.clone();
            a.value = self.atom(a.value, &name);
            b.value = self.atom(b.value, &name);
            let quotient = Expr::binary(BinaryOp::Div, a.value.clone(), b.value.clone());
            let whole = Expr::intrinsic(bessemer_ir::Intrinsic::Trunc, vec![quotient]);
            let whole = self.atom(whole, &name);
            tangents = fold::difference(tangents, fold::scaled(b.tangents, &whole));
        }
        Word { value: Expr::binary(BinaryOp::Rem, a.value, b.value), tangents }
    }

    /// Returns tangents by a slope: `slope * a′`.
    pub fn along(&mut self, slope: Expr, tangents: Tangents) -> Tangents {
        let slope = match known(&slope) {
            Some(_) => slope,
            None => self.atom(slope, "slope"),
        };
        fold::scaled(tangents, &slope)
    }
}
