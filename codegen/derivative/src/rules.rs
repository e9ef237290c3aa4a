//! Derivatives of intrinsic and elementary functions.

use bessemer_ir::{BinaryOp, CompareOp, Expr, ExprKind, Intrinsic, StmtKind, Type, UnaryOp};

use crate::expression::literal;
use crate::extreme::negative;
use crate::run::Run;
use crate::value::{Tangents, Value, Word};
use crate::{Problem, Result, float, fold};

/// Module of the DSL's elementary functions.
pub const MATH: &str = "bessemer::math";

/// Returns true for a module of the DSL's elementary functions.
pub fn is_mathematics(module: &str) -> bool {
    module == MATH || module.strip_prefix(MATH).is_some_and(|rest| rest.starts_with("::"))
}

fn mul(a: Expr, b: Expr) -> Expr {
    Expr::binary(BinaryOp::Mul, a, b)
}

fn add(a: Expr, b: Expr) -> Expr {
    Expr::binary(BinaryOp::Add, a, b)
}

fn sub(a: Expr, b: Expr) -> Expr {
    Expr::binary(BinaryOp::Sub, a, b)
}

fn div(a: Expr, b: Expr) -> Expr {
    Expr::binary(BinaryOp::Div, a, b)
}

fn root(a: Expr) -> Expr {
    Expr::intrinsic(Intrinsic::Sqrt, vec![a])
}

impl Run<'_> {
    /// Returns the square root; its derivative is `a′ / (2 * root)`.
    pub fn root(&mut self, a: Word) -> Word {
        let mut value = root(a.value);
        if a.tangents.is_empty() {
            return Word::constant(value);
        }
        let name = self.name.clone();
        value = self.atom(value, &name);
        let two = float(2.0, &value.ty, value.span);
        let twice = self.atom(mul(two, value.clone()), "twice");
        let each = |(variable, it)| (variable, div(it, twice.clone()));
        Word { value, tangents: a.tangents.into_iter().map(each).collect() }
    }

    /// Returns the value of an intrinsic function.
    pub fn intrinsic(
        &mut self,
        op: Intrinsic,
        mut operands: Vec<Word>,
        expr: &Expr,
    ) -> Result<Word> {
        use Intrinsic::*;
        let active = operands.iter().any(|it| !it.tangents.is_empty());
        let values = |operands: &[Word]| operands.iter().map(|it| it.value.clone()).collect();
        let whole = |operands: &[Word]| Expr {
            kind: ExprKind::Intrinsic(op, values(operands)),
            ty: expr.ty.clone(),
            span: expr.span,
        };
        let is_constant = matches!(
            op,
            Floor | Ceil | Trunc | Round | Signum | DivEuclid | IsNan | IsFinite | IsInfinite
        );
        if !active || is_constant {
            return Ok(Word::constant(whole(&operands)));
        }
        let name = self.name.clone();
        match op {
            Sqrt => {
                let operand = operands.remove(0);
                Ok(self.root(operand))
            }
            Abs | Min | Max | Clamp | Copysign => {
                for operand in &mut operands {
                    operand.value = self.atom(operand.value.clone(), &name);
                }
                let value = self.atom(whole(&operands), &name);
                let tangents = self.selected(op, &value, &operands);
                Ok(Word { value, tangents })
            }
            RemEuclid => {
                let [a, b] = <[Word; 2]>::try_from(operands.clone()).map_err(|_| opaque(expr))?;
                match b.tangents.is_empty() {
                    true => Ok(Word { value: whole(&operands), tangents: a.tangents }),
                    false => Err(opaque(expr)),
                }
            }
            _ => Err(opaque(expr)),
        }
    }

    /// Returns the derivatives of a function whose value is one of its operands, or its negative.
    pub fn selected(&mut self, op: Intrinsic, value: &Expr, operands: &[Word]) -> Tangents {
        let is = |op: CompareOp, a: &Expr, b: &Expr| Expr::compare(op, a.clone(), b.clone());
        let empty = Tangents::new();
        let of = |index: usize| operands.get(index).map_or(&empty, |it| &it.tangents).clone();
        let operand = |index: usize| operands.get(index).map_or(value, |it| &it.value);
        let sides: Vec<(Expr, Tangents)> = match op {
            Intrinsic::Clamp => vec![
                (is(CompareOp::Lt, operand(0), operand(1)), of(1)),
                (is(CompareOp::Gt, operand(0), operand(2)), of(2)),
            ],
            _ => vec![(is(CompareOp::Eq, value, operand(0)), of(0))],
        };
        let last = match op {
            Intrinsic::Clamp => of(0),
            Intrinsic::Min | Intrinsic::Max => of(1),
            _ => negative(&of(0)),
        };
        self.by_cases(value, sides, last)
    }

    /// Returns the derivatives of the first case that holds, or the last ones.
    pub fn by_cases(
        &mut self,
        value: &Expr,
        sides: Vec<(Expr, Tangents)>,
        last: Tangents,
    ) -> Tangents {
        let span = value.span;
        let mut variables: Vec<u32> = last.keys().copied().collect();
        variables.extend(sides.iter().flat_map(|side| side.1.keys().copied()));
        variables.sort_unstable();
        variables.dedup();
        let zero = float(0.0, &value.ty, span);
        let name = self.name.clone();
        let places: Vec<(u32, bessemer_ir::Place)> = variables
            .into_iter()
            .map(|variable| {
                let local = self.declare(&format!("{name}_d{variable}"), &value.ty, span);
                self.emit(StmtKind::Let { local, value: None }, span);
                (variable, bessemer_ir::Place::local(local, value.ty.clone(), span))
            })
            .collect();
        let assigned = |tangents: &Tangents| {
            let assign = |(variable, place): &(u32, bessemer_ir::Place)| {
                let value = tangents.get(variable).unwrap_or(&zero).clone();
                bessemer_ir::Stmt::new(StmtKind::Assign { place: place.clone(), value }, span)
            };
            bessemer_ir::Block(places.iter().map(assign).collect())
        };
        let mut otherwise = assigned(&last);
        for (condition, tangents) in sides.into_iter().rev() {
            let then = assigned(&tangents);
            let kind = StmtKind::If { condition, then, otherwise };
            otherwise = bessemer_ir::Block::of(kind, span);
        }
        for stmt in otherwise.0 {
            self.emit(stmt.kind, span);
        }
        places.into_iter().map(|(variable, place)| (variable, place.load())).collect()
    }

    /// Returns the value of an elementary function of the DSL; none for other functions.
    pub fn elementary_function(
        &mut self,
        name: &str,
        operands: Vec<Word>,
        expr: &Expr,
    ) -> Result<Option<Value>> {
        let Some(first) = operands.first().cloned() else { return Ok(None) };
        if first.value.ty.as_float().is_none() {
            return Ok(None);
        }
        let suffix = if first.value.ty == Type::F32 { "f" } else { "" };
        let Some(base) = name.strip_suffix(suffix) else { return Ok(None) };
        let named = |name: &str| format!("{name}{suffix}");
        if base == "sin_cos" {
            let mut parts = Vec::new();
            for name in ["sin", "cos"] {
                let value = self.elementary_function(&named(name), vec![first.clone()], expr)?;
                parts.extend(value);
            }
            return Ok(Some(Value::Parts(parts)));
        }
        if !ELEMENTARY.contains(&base) {
            return Ok(None);
        }
        let values: Vec<Expr> = operands.iter().map(|it| it.value.clone()).collect();
        let value = self.elementary(name, values.clone());
        if operands.iter().all(|it| it.tangents.is_empty()) {
            return Ok(Some(Value::Leaf(Word::constant(value))));
        }
        let hint = self.name.clone();
        let value = self.atom(value, &hint);
        let (x, v) = (&first.value, &value);
        let number = |it: f64| float(it, &value.ty, expr.span);
        let square = |it: &Expr| mul(it.clone(), it.clone());
        let one = || number(1.0);
        let y = operands.get(1).cloned().unwrap_or_else(|| Word::constant(one()));
        let z = operands.get(2).cloned().unwrap_or_else(|| Word::constant(one()));
        let slope = match base {
            "sin" => self.elementary(&named("cos"), vec![x.clone()]),
            "cos" => Expr::unary(UnaryOp::Neg, self.elementary(&named("sin"), vec![x.clone()])),
            "tan" => add(one(), square(v)),
            "asin" => div(one(), root(sub(one(), square(x)))),
            "acos" => div(number(-1.0), root(sub(one(), square(x)))),
            "atan" => div(one(), add(one(), square(x))),
            "exp" => v.clone(),
            "exp2" => mul(number(core::f64::consts::LN_2), v.clone()),
            "exp_m1" => add(v.clone(), one()),
            "ln" => div(one(), x.clone()),
            "log2" => div(one(), mul(number(core::f64::consts::LN_2), x.clone())),
            "log10" => div(one(), mul(number(core::f64::consts::LN_10), x.clone())),
            "ln_1p" => div(one(), add(one(), x.clone())),
            "sinh" => self.elementary(&named("cosh"), vec![x.clone()]),
            "cosh" => self.elementary(&named("sinh"), vec![x.clone()]),
            "tanh" => sub(one(), square(v)),
            "cbrt" => div(one(), mul(number(3.0), square(v))),
            "powi" => {
                let exponent = y.value.clone();
                let less = match literal(&exponent) {
                    Some(0) => return Ok(Some(Value::Leaf(Word::constant(value)))),
                    Some(1) => None,
                    Some(n) if n > i128::from(i32::MIN) => {
                        Some(Expr::literal_like((n - 1) as u64, &exponent))
                    }
                    _ => {
                        let one = Expr::literal_like(1, &exponent);
                        Some(Expr::intrinsic(Intrinsic::WrappingSub, vec![exponent.clone(), one]))
                    }
                };
                let factor = fold::cast(exponent, &value.ty);
                match less {
                    Some(less) => {
                        let power = self.elementary(&named("powi"), vec![x.clone(), less]);
                        mul(factor, power)
                    }
                    None => one(),
                }
            }
            _ => {
                let tangents = self.of_two(base, &named, (&first, &y, &z), &value);
                return Ok(Some(Value::Leaf(Word { value, tangents })));
            }
        };
        let tangents = self.along(slope, first.tangents);
        Ok(Some(Value::Leaf(Word { value, tangents })))
    }

    /// Returns the derivatives of a function of several numbers.
    fn of_two(
        &mut self,
        base: &str,
        named: &dyn Fn(&str) -> String,
        (x, y, z): (&Word, &Word, &Word),
        value: &Expr,
    ) -> Tangents {
        let (a, b) = (x.value.clone(), y.value.clone());
        let square = |it: &Expr| mul(it.clone(), it.clone());
        let one = float(1.0, &value.ty, value.span);
        match base {
            // The angle of the point (b, a).
            "atan2" => {
                let radius = self.atom(add(square(&b), square(&a)), "radius");
                let first = self.along(div(b, radius.clone()), x.tangents.clone());
                let second = self.along(div(a, radius), y.tangents.clone());
                fold::difference(first, second)
            }
            "hypot" => {
                let first = self.along(div(a, value.clone()), x.tangents.clone());
                let second = self.along(div(b, value.clone()), y.tangents.clone());
                fold::sum(first, second)
            }
            "mul_add" => {
                let first = fold::scaled(x.tangents.clone(), &b);
                let second = fold::scaled(y.tangents.clone(), &a);
                fold::sum(fold::sum(first, second), z.tangents.clone())
            }
            _ => {
                let mut first = Tangents::new();
                let mut second = Tangents::new();
                if !x.tangents.is_empty() {
                    let less = self.atom(sub(b.clone(), one), "less");
                    let power = self.elementary(&named("powf"), vec![a.clone(), less]);
                    first = self.along(mul(b, power), x.tangents.clone());
                }
                if !y.tangents.is_empty() {
                    let logarithm = self.elementary(&named("ln"), vec![a]);
                    second = self.along(mul(value.clone(), logarithm), y.tangents.clone());
                }
                fold::sum(first, second)
            }
        }
    }
}

/// Elementary functions with derivatives, by their names in double precision.
const ELEMENTARY: [&str; 22] = [
    "sin", "cos", "tan", "asin", "acos", "atan", "exp", "exp2", "exp_m1", "ln", "log2", "log10",
    "ln_1p", "sinh", "cosh", "tanh", "cbrt", "powi", "atan2", "powf", "hypot", "mul_add",
];

/// Returns the problem of an operation on bits.
pub fn opaque(expr: &Expr) -> Problem {
    Problem::new(
        expr.span,
        "an operation on the bits of a differentiated number has no derivative",
        "differentiate a function that computes with the number itself",
    )
}
