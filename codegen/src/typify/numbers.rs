//! Methods of numbers that are put together from operations of the IR.
//!
//! One that the IR has is in [`builtin`](super::builtin); what stands here is spelt out, as a reader of
//! the C would write it, each operand computed once.

use bessemer_ir::tree;
use bessemer_ir::{
    BinaryOp, CompareOp, Expr, ExprKind, Float, Int, Intrinsic, Place, Scalar, Span, Step, Type,
    UnaryOp,
};

use super::Result;
use super::expr::Operand;
use super::function::Lowering;

/// Makes nodes at one place in the source.
struct At(Span);

impl At {
    fn node(&self, kind: ExprKind, ty: &Type) -> Expr {
        Expr { kind, ty: ty.clone(), span: self.0 }
    }

    fn binary(&self, op: BinaryOp, a: Expr, b: Expr) -> Expr {
        let ty = a.ty.clone();
        self.node(ExprKind::Binary(op, Box::new(a), Box::new(b)), &ty)
    }

    fn compare(&self, op: CompareOp, a: Expr, b: Expr) -> Expr {
        self.node(ExprKind::Compare(op, Box::new(a), Box::new(b)), &Type::BOOL)
    }

    fn not(&self, x: Expr) -> Expr {
        let ty = x.ty.clone();
        self.node(ExprKind::Unary(UnaryOp::Not, Box::new(x)), &ty)
    }

    fn cast(&self, x: Expr, ty: &Type) -> Expr {
        if x.ty == *ty { x } else { self.node(ExprKind::Cast(Box::new(x)), ty) }
    }

    /// An intrinsic whose result has the type `ty`.
    fn intrinsic(&self, op: Intrinsic, operands: Vec<Expr>, ty: &Type) -> Expr {
        self.node(ExprKind::Intrinsic(op, operands), ty)
    }

    fn int(&self, value: u32, ty: &Type) -> Expr {
        self.node(ExprKind::Literal(u64::from(value)), ty)
    }

    fn float(&self, double: f64, single: f32, ty: &Type) -> Expr {
        let word = match ty.as_float() {
            Some(Float::F32) => u64::from(single.to_bits()),
            _ => double.to_bits(),
        };
        self.node(ExprKind::Literal(word), ty)
    }

    /// The bits of an integer, unsigned.
    fn unsigned(&self, x: Expr) -> Expr {
        match x.ty.as_int() {
            Some(int) => self.cast(x, &of(int.unsigned())),
            None => x,
        }
    }

    /// `n` modulo the width of `int`.
    fn masked(&self, n: Expr, int: Int) -> Expr {
        let mask = int.bits() - 1;
        match n.kind {
            ExprKind::Literal(word) => self.int(word as u32 & mask, &n.ty),
            _ => {
                let mask = self.int(mask, &n.ty);
                self.binary(BinaryOp::And, n, mask)
            }
        }
    }
}

fn of(int: Int) -> Type {
    Type::Scalar(Scalar::Int(int))
}

const U32: Type = Type::Scalar(Scalar::Int(Int::U32));

impl Lowering<'_, '_> {
    /// The value of the method `name`; none if it is not put together here.
    pub(super) fn number_method(
        &mut self,
        name: &str,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Option<Expr>> {
        let Some((first, rest)) = expected(name) else { return Ok(None) };
        let ty = self.slot_of(expr)?;
        let first = match first {
            Expected::Result => Some(ty.clone()),
            Expected::Count => Some(U32),
            Expected::Receiver => None,
        };
        let rest = match rest {
            Expected::Receiver => self.partner(arguments)?,
            Expected::Result => Some(ty.clone()),
            Expected::Count => Some(U32),
        };
        let operands: Vec<_> = arguments
            .iter()
            .zip(["value", "by"])
            .map(|(expr, role)| Operand {
                expr,
                expected: if role == "by" { rest.clone() } else { first.clone() },
                role,
            })
            .collect();
        let values = self.operands(&operands)?;
        let at = At(self.span(expr.site));
        let value = match values.len() {
            1 => self.of_one(name, values, &ty, &at),
            _ => self.of_two(name, values, &ty, &at),
        };
        Ok(Some(value))
    }

    /// The type of the first operand, where a literal beside it has it too.
    fn partner(&mut self, arguments: &[tree::Expr]) -> Result<Option<Type>> {
        match arguments {
            [first, tree::Expr { kind: tree::ExprKind::Int(_, None), .. }] => {
                self.type_alone(first).map(Some)
            }
            [first, tree::Expr { kind: tree::ExprKind::Unary(..), .. }] => {
                self.type_alone(first).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// Values that may be written more than once: where one has to be computed before, all are.
    fn reusable(&mut self, values: Vec<Expr>) -> Vec<Expr> {
        fn light(value: &Expr) -> bool {
            match &value.kind {
                ExprKind::Literal(_) | ExprKind::Const(_) => true,
                ExprKind::Load(place) => {
                    place.steps.iter().all(|step| matches!(step, Step::Field(_)))
                }
                _ => false,
            }
        }
        if values.iter().all(light) {
            return values;
        }
        let roles = ["value", "by"];
        let constant =
            |value: &Expr| matches!(value.kind, ExprKind::Literal(_) | ExprKind::Const(_));
        let kept = values.into_iter().zip(roles).map(|(value, role)| {
            if constant(&value) { value } else { self.temporary(role, value) }
        });
        kept.collect()
    }

    fn of_one(&mut self, name: &str, mut values: Vec<Expr>, ty: &Type, at: &At) -> Expr {
        if matches!(name, "fract" | "signum") {
            values = self.reusable(values);
        }
        let x = values.remove(0);
        let zero = at.int(0, &x.ty);
        let is_float = x.ty.as_float().is_some();
        match name {
            "recip" => at.binary(BinaryOp::Div, at.float(1.0, 1.0, ty), x),
            "fract" => {
                let whole = at.intrinsic(Intrinsic::Trunc, vec![x.clone()], ty);
                at.binary(BinaryOp::Sub, x, whole)
            }
            // As core has them: the factor rounded once, for `f32` from more digits.
            "to_degrees" => {
                let factor = 180.0 / core::f64::consts::PI;
                at.binary(BinaryOp::Mul, x, at.float(factor, factor as f32, ty))
            }
            "to_radians" => {
                let single = core::f32::consts::PI / 180.0;
                at.binary(BinaryOp::Mul, x, at.float(core::f64::consts::PI / 180.0, single, ty))
            }
            "signum" if is_float => at.intrinsic(Intrinsic::Signum, vec![x], ty),
            "signum" => {
                let above = at.compare(CompareOp::Gt, x.clone(), zero.clone());
                let below = at.compare(CompareOp::Lt, x, zero);
                at.binary(BinaryOp::Sub, at.cast(above, ty), at.cast(below, ty))
            }
            "is_sign_negative" | "is_sign_positive" => {
                let one = at.float(1.0, 1.0, &x.ty);
                let nothing = at.float(0.0, 0.0, &x.ty);
                let of = x.ty.clone();
                let unit = at.intrinsic(Intrinsic::Copysign, vec![one, x], &of);
                let negative = name == "is_sign_negative";
                at.compare(if negative { CompareOp::Lt } else { CompareOp::Gt }, unit, nothing)
            }
            "is_positive" => at.compare(CompareOp::Gt, x, zero),
            "is_negative" => at.compare(CompareOp::Lt, x, zero),
            "wrapping_neg" => at.intrinsic(Intrinsic::WrappingSub, vec![zero, x], ty),
            "wrapping_abs" => {
                let unsigned = x.ty.as_int().map_or(U32, |int| of(int.unsigned()));
                at.cast(at.intrinsic(Intrinsic::UnsignedAbs, vec![x], &unsigned), ty)
            }
            "swap_bytes" if x.ty.as_int().is_some_and(|int| int.bits() == 8) => x,
            "swap_bytes" => {
                let bits = at.unsigned(x);
                let unsigned = bits.ty.clone();
                at.cast(at.intrinsic(Intrinsic::SwapBytes, vec![bits], &unsigned), ty)
            }
            "is_power_of_two" => {
                let count = at.intrinsic(Intrinsic::CountOnes, vec![x], &U32);
                at.compare(CompareOp::Eq, count, at.int(1, &U32))
            }
            "from" => at.cast(x, ty),
            _ => {
                let bits = at.unsigned(x);
                let (op, turned) = match name {
                    "count_ones" => (Intrinsic::CountOnes, false),
                    "count_zeros" => (Intrinsic::CountOnes, true),
                    "leading_zeros" => (Intrinsic::LeadingZeros, false),
                    "leading_ones" => (Intrinsic::LeadingZeros, true),
                    "trailing_zeros" => (Intrinsic::TrailingZeros, false),
                    _ => (Intrinsic::TrailingZeros, true),
                };
                at.intrinsic(op, vec![if turned { at.not(bits) } else { bits }], &U32)
            }
        }
    }

    fn of_two(&mut self, name: &str, mut values: Vec<Expr>, ty: &Type, at: &At) -> Expr {
        let int = values[0].ty.as_int();
        let signed = int.is_none_or(Int::signed);
        if name.starts_with("rotate") {
            values = self.reusable(values);
        }
        let (b, a) = (values.remove(1), values.remove(0));
        let plain = |op, node, a, b| match signed {
            true => at.intrinsic(node, vec![a, b], ty),
            false => at.binary(op, a, b),
        };
        match (name, int) {
            ("div_euclid", _) => plain(BinaryOp::Div, Intrinsic::DivEuclid, a, b),
            ("rem_euclid", _) => plain(BinaryOp::Rem, Intrinsic::RemEuclid, a, b),
            ("wrapping_div", _) => plain(BinaryOp::Div, Intrinsic::WrappingDiv, a, b),
            ("wrapping_rem", _) => plain(BinaryOp::Rem, Intrinsic::WrappingRem, a, b),
            ("abs_diff", _) => at.intrinsic(Intrinsic::AbsDiff, vec![a, b], ty),
            ("wrapping_shl", Some(int)) => at.binary(BinaryOp::Shl, a, at.masked(b, int)),
            ("wrapping_shr", Some(int)) => at.binary(BinaryOp::Shr, a, at.masked(b, int)),
            (_, Some(int)) => {
                let bits = at.unsigned(a);
                let back = match b.kind {
                    ExprKind::Literal(word) => {
                        at.int((word as u32).wrapping_neg() & (int.bits() - 1), &U32)
                    }
                    _ => {
                        let operands = vec![at.int(0, &U32), b.clone()];
                        at.masked(at.intrinsic(Intrinsic::WrappingSub, operands, &U32), int)
                    }
                };
                let by = at.masked(b, int);
                let (left, right) = if name == "rotate_left" { (by, back) } else { (back, by) };
                let high = at.binary(BinaryOp::Shl, bits.clone(), left);
                let low = at.binary(BinaryOp::Shr, bits, right);
                at.cast(at.binary(BinaryOp::Or, high, low), ty)
            }
            _ => a,
        }
    }

    /// The square or the cube of an integer, which need no loop; none if it is another call.
    pub(super) fn small_power(
        &mut self,
        path: &str,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Option<Expr>> {
        let Some(name) = path.strip_prefix("bessemer::math::integer::") else { return Ok(None) };
        let wrapping = name.starts_with("wrapping_pow");
        let exponent = match arguments {
            [_, tree::Expr { kind: tree::ExprKind::Int(digits, _), .. }] => digits.as_str(),
            _ => return Ok(None),
        };
        if !matches!(exponent, "2" | "3") {
            return Ok(None);
        }
        let ty = self.slot_of(expr)?;
        let base = self.value(&arguments[0], Some(&ty))?;
        let at = At(self.span(expr.site));
        let product = |a: Expr, b: Expr| match wrapping {
            true => at.intrinsic(Intrinsic::WrappingMul, vec![a, b], &ty),
            false => at.binary(BinaryOp::Mul, a, b),
        };
        let x = self.reusable(vec![base]).remove(0);
        let square = product(x.clone(), x.clone());
        Ok(Some(if exponent == "2" { square } else { product(square, x) }))
    }

    /// The bytes of a number as an array, or the number that they make.
    pub(super) fn bytes(
        &mut self,
        name: &str,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let ty = self.slot_of(expr)?;
        let at = At(self.span(expr.site));
        let big = name.ends_with("be_bytes");
        let byte = of(Int::U8);
        let argument = self.value(&arguments[0], None)?;
        if let Type::Array { len, .. } = ty {
            let value = match argument.ty.as_float() {
                Some(float) => {
                    at.intrinsic(Intrinsic::ToBits, vec![argument], &of(float.bits_type()))
                }
                None => at.unsigned(argument),
            };
            let value = self.reusable(vec![value]).remove(0);
            let bytes = (0..len).map(|index| {
                let place = if big { len - 1 - index } else { index };
                let shifted = match place {
                    0 => value.clone(),
                    _ => at.binary(BinaryOp::Shr, value.clone(), at.int(8 * place, &U32)),
                };
                at.cast(shifted, &byte)
            });
            return Ok(at.node(ExprKind::Array(bytes.collect()), &ty));
        }
        let bytes = match &argument.kind {
            ExprKind::Load(place) if place.steps.iter().all(|it| matches!(it, Step::Field(_))) => {
                argument
            }
            _ => self.temporary("bytes", argument),
        };
        let (ExprKind::Load(place), Type::Array { len, .. }) = (&bytes.kind, &bytes.ty) else {
            return super::problem(expr.site, "these are no bytes", super::OUR_FAULT);
        };
        let unsigned = match (ty.as_float(), ty.as_int()) {
            (Some(float), _) => of(float.bits_type()),
            (_, Some(int)) => of(int.unsigned()),
            _ => U32,
        };
        let mut total: Option<Expr> = None;
        for index in 0..*len {
            let mut steps = place.steps.clone();
            steps.push(Step::Index(at.int(index, &Type::USIZE)));
            let one = Place { root: place.root, steps, ty: byte.clone(), span: at.0 };
            let value = at.cast(at.node(ExprKind::Load(one), &byte), &unsigned);
            let weight = if big { len - 1 - index } else { index };
            let value = match weight {
                0 => value,
                _ => at.binary(BinaryOp::Shl, value, at.int(8 * weight, &U32)),
            };
            total = Some(match total {
                None => value,
                Some(total) => at.binary(BinaryOp::Or, total, value),
            });
        }
        let bits = total.unwrap_or_else(|| at.int(0, &unsigned));
        Ok(match ty.as_float() {
            Some(_) => at.intrinsic(Intrinsic::FromBits, vec![bits], &ty),
            None => at.cast(bits, &ty),
        })
    }
}

/// What a literal operand is expected to be.
enum Expected {
    /// Of the result's type.
    Result,
    /// A `u32`.
    Count,
    /// Of the receiver's type, which is not the result's.
    Receiver,
}

/// What is expected of the receiver and of the operand after it; none for names of no method here.
fn expected(name: &str) -> Option<(Expected, Expected)> {
    use Expected::{Count, Receiver, Result};
    Some(match name {
        "recip" | "fract" | "to_degrees" | "to_radians" | "signum" | "wrapping_neg"
        | "wrapping_abs" | "swap_bytes" => (Result, Result),
        "div_euclid" | "rem_euclid" | "wrapping_div" | "wrapping_rem" => (Result, Result),
        "wrapping_shl" | "wrapping_shr" | "rotate_left" | "rotate_right" => (Result, Count),
        "is_sign_negative" | "is_sign_positive" | "is_positive" | "is_negative"
        | "is_power_of_two" | "abs_diff" | "from" => (Receiver, Receiver),
        "count_ones" | "count_zeros" | "leading_zeros" | "leading_ones" | "trailing_zeros"
        | "trailing_ones" => (Receiver, Receiver),
        _ => return None,
    })
}
