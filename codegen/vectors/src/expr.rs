//! Expressions, each as an expression of Rust.

use bessemer_ir::visit::Walk;
use bessemer_ir::{Const, ConstId, Expr, ExprKind, Float, LogicOp, Scalar, Type};

use crate::body::{Cx, Result};
use crate::names::word;
use crate::types::{is_byte, number, text};

impl Cx<'_> {
    /// Returns the value of an expression, with a type of [`text`].
    pub(crate) fn value(&self, expr: &Expr) -> Result<String> {
        if let Some(uniform) = self.uniform(expr) {
            return Ok(format!("Whole::of({uniform})"));
        }
        Ok(match &expr.kind {
            ExprKind::Literal(word) => literal(&expr.ty, *word),
            ExprKind::Const(id) => self.constant(*id),
            ExprKind::Load(place) => self.load(place)?,
            ExprKind::Unary(op, of) => self.unary(*op, of)?,
            ExprKind::Binary(op, left, right) => self.binary(*op, left, right)?,
            ExprKind::Compare(op, left, right) => match self.uniform_condition(expr) {
                Some(condition) => format!("Mask::of({condition})"),
                None => self.comparison(*op, left, right)?,
            },
            ExprKind::Logic(op, left, right) => self.logic(*op, left, right)?,
            ExprKind::Cast(of) => self.cast(of, &expr.ty)?,
            ExprKind::Intrinsic(which, of) => self.intrinsic(*which, of)?,
            ExprKind::Call(callee, arguments) => self.call(*callee, arguments)?,
            ExprKind::Struct(parts) => {
                let Type::Struct(id) = &expr.ty else {
                    return Err(self.error(expr.span, "has a literal of no struct"));
                };
                let fields = &self.module.structs[id.index()].fields;
                let part = |(field, part): (&bessemer_ir::Field, &Expr)| {
                    Ok(format!("{}: {}", word(&field.name), self.part(part)?))
                };
                let parts = fields.iter().zip(parts).map(part).collect::<Result<Vec<_>>>()?;
                format!("{} {{ {} }}", self.names.of_struct(*id), parts.join(", "))
            }
            ExprKind::Array(parts) | ExprKind::Matrix(parts) => {
                let parts = parts.iter().map(|it| self.part(it)).collect::<Result<Vec<_>>>()?;
                format!("[{}]", parts.join(", "))
            }
            ExprKind::Splat(of) => {
                let value = self.part(of)?;
                match of.ty.is_word() {
                    true => format!("[{value}; {}]", self.elements(&expr.ty)),
                    false => {
                        format!("{{ let value = {value}; std::array::from_fn(|_| value.clone()) }}")
                    }
                }
            }
            ExprKind::Routine(which, of) => self.routine(*which, of)?,
        })
    }

    /// Returns the value of an element or a field.
    fn part(&self, expr: &Expr) -> Result<String> {
        let value = self.value(expr)?;
        Ok(if is_byte(&expr.ty) { format!("Byte::of({value})") } else { value })
    }

    fn elements(&self, ty: &Type) -> u32 {
        match ty {
            Type::Array { len, .. } => *len,
            Type::Matrix { rows, cols, .. } => rows * cols,
            _ => 1,
        }
    }

    fn logic(&self, op: LogicOp, left: &Expr, right: &Expr) -> Result<String> {
        let then = self.value(right)?;
        // Where the left side decides for all lanes, the right one may have an index beyond the end.
        if let Some(left) = self.uniform_condition(left) {
            return Ok(match op {
                LogicOp::And => format!("(if {left} {{ {then} }} else {{ Mask::NONE }})"),
                LogicOp::Or => format!("(if {left} {{ Mask::ALL }} else {{ {then} }})"),
            });
        }
        let first = self.value(left)?;
        let calls = right.any_expr(|it| matches!(it.kind, ExprKind::Call(..)));
        Ok(match (op, calls) {
            (LogicOp::And, false) => format!("({first} & {then})"),
            (LogicOp::Or, false) => format!("({first} | {then})"),
            (LogicOp::And, true) => format!("lanes::and(m, {first}, |m| {then})"),
            (LogicOp::Or, true) => format!("lanes::or(m, {first}, |m| {then})"),
        })
    }

    fn constant(&self, id: ConstId) -> String {
        let (name, Const { ty, words, .. }) =
            (self.names.of_const(id), &self.module.consts[id.index()]);
        match ty {
            Type::Scalar(Scalar::Float(Float::F64)) => format!("Real::of({name})"),
            Type::Scalar(Scalar::Float(Float::F32)) => {
                format!("Single::of(f32::from_bits({name} as u32))")
            }
            Type::Scalar(Scalar::Bool) => format!("Mask::of({name} != 0)"),
            _ if words.len() == 1 && ty.is_word() => format!("Whole::of({name})"),
            _ if words.len() == 1 => {
                format!("<{} as Lanes>::of_words(&[{}])", text(self.names, ty), words[0])
            }
            _ => format!("<{} as Lanes>::of_words(&{name})", text(self.names, ty)),
        }
    }
}

fn literal(ty: &Type, word: u64) -> String {
    match ty {
        Type::Scalar(Scalar::Float(Float::F64)) => {
            format!("Real::of({})", number(f64::from_bits(word)))
        }
        Type::Scalar(Scalar::Float(Float::F32)) => {
            format!("Single::of(f32::from_bits({word:#x}))")
        }
        Type::Scalar(Scalar::Bool) if word == 0 => "Mask::NONE".to_owned(),
        Type::Scalar(Scalar::Bool) => "Mask::ALL".to_owned(),
        _ => format!("Whole::of({})", word as i64),
    }
}
