//! Values in comparisons.
//!
//! gcc takes `(uint8_t)(255U - x)` and `(uint8_t)(x ^ 255U)` for `(uint8_t)~x`, also if the number is a named
//! constant, and warns of every comparison with it. Instead the value is computed in 32 bits, or by a function. gcc
//! also warns of widened values, `~(uint64_t)x`, and of signed ones, `(uint8_t)(int8_t)~x`; a function computes
//! these.

use bessemer_ir::{Float, Int, Scalar};

use super::super::helpers::Helper;
use super::super::literal;
use super::super::spelling::scalar_type;
use super::super::tree::Expr;
use super::Lower;

impl Lower<'_> {
    /// Returns a value in a form that no compiler takes for a complement.
    pub(super) fn comparable(&mut self, value: Expr) -> Expr {
        let (ty, inner) = match value {
            Expr::Unary("~", operand) => return self.complement(*operand),
            Expr::Binary(op @ ("&" | "|"), left, right) => return self.picked(op, *left, *right),
            Expr::Cast(ty, inner) => (ty, inner),
            other => return other,
        };
        let (mask, int) = match ty.as_str() {
            "uint8_t" => ("255U", Int::U8),
            "uint16_t" => ("65535U", Int::U16),
            // In a wider type it is a complement still.
            _ => {
                let small = matches!(&*inner, Expr::Cast(ty, _) if matches!(ty.as_str(), "uint8_t" | "uint16_t"));
                return match (self.comparable(*inner), numeric(&ty).filter(|_| small)) {
                    // In 32 bits now.
                    (masked @ Expr::Binary(..), Some(to)) => {
                        self.converted(Scalar::Int(Int::U32), to, masked)
                    }
                    (inner, _) => Expr::Cast(ty, Box::new(inner)),
                };
            }
        };
        match *inner {
            Expr::Unary("~", operand) => {
                let operand = Expr::cast("uint32_t", *operand);
                Expr::binary("&", Expr::unary("~", operand), Expr::name(mask))
            }
            Expr::Binary("-", left, right) if self.may_be_constant(&left) => {
                let (left, right) = (Expr::cast("uint32_t", *left), Expr::cast("uint32_t", *right));
                Expr::binary("&", Expr::binary("-", left, right), Expr::name(mask))
            }
            Expr::Binary("^", left, right)
                if self.may_be_constant(&left) || self.may_be_constant(&right) =>
            {
                self.helper(Helper::Xor(int), vec![*left, *right])
            }
            Expr::Binary(op @ ("&" | "|"), left, right) => {
                Expr::Cast(ty, Box::new(self.picked(op, *left, *right)))
            }
            Expr::Cast(to, operand) => match self.held(int, to, *operand) {
                // In 32 bits now, of which the narrower type is left.
                Expr::Binary("&", bits, of_inner) => {
                    let mask = if int == Int::U8 { Expr::name(mask) } else { *of_inner };
                    Expr::binary("&", *bits, mask)
                }
                held => Expr::Cast(ty, Box::new(held)),
            },
            other => Expr::Cast(ty, Box::new(other)),
        }
    }

    /// Returns a value of the small type `to` under a cast to `int`; complements are computed by a function.
    fn held(&mut self, int: Int, to: String, operand: Expr) -> Expr {
        let signed = match (int, to.as_str()) {
            (Int::U8, "int8_t") => Int::I8,
            (Int::U16, "int16_t") => Int::I16,
            _ => return self.comparable(Expr::Cast(to, Box::new(operand))),
        };
        match operand {
            Expr::Unary("~", operand) => {
                let all = literal::integer(signed, -1);
                self.helper(Helper::Xor(signed), vec![*operand, all])
            }
            Expr::Binary("-", left, right) if self.may_be_constant(&left) => {
                let bits = [*left, *right].map(|it| self.helper(Helper::Extend(signed), vec![it]));
                let [left, right] = bits;
                let mask = Expr::name(format!("{}U", Int::max(int)));
                Expr::binary("&", Expr::binary("-", left, right), mask)
            }
            Expr::Binary("^", left, right)
                if self.may_be_constant(&left) || self.may_be_constant(&right) =>
            {
                self.helper(Helper::Xor(signed), vec![*left, *right])
            }
            other => self.comparable(Expr::Cast(to, Box::new(other))),
        }
    }

    /// Returns bits masked by a number, which may leave them unchanged.
    fn picked(&mut self, op: &'static str, left: Expr, right: Expr) -> Expr {
        let number = self.may_be_constant(&left) || self.may_be_constant(&right);
        let [left, right] = [left, right].map(|it| match it {
            Expr::Cast(ty, inner) if number => self.turned_over(ty, *inner),
            Expr::Binary(op @ ("&" | "|"), left, right) => self.picked(op, *left, *right),
            it => it,
        });
        Expr::binary(op, left, right)
    }

    /// Returns a cast to a type; the cast of a small complement becomes a call of a function.
    fn turned_over(&mut self, ty: String, inner: Expr) -> Expr {
        let mut small = [Int::U8, Int::U16].into_iter();
        let int = small.find(|int| scalar_type(Scalar::Int(*int)) == ty);
        match (inner, int) {
            (Expr::Unary("~", operand), Some(int)) => {
                let all = literal::integer(int, Int::max(int));
                self.helper(Helper::Xor(int), vec![*operand, all])
            }
            // Of what a signed type held.
            (inner @ Expr::Cast(..), Some(_)) => self.comparable(Expr::Cast(ty, Box::new(inner))),
            (inner, _) => Expr::Cast(ty, Box::new(inner)),
        }
    }

    /// Returns the complement of a widened value.
    fn complement(&mut self, operand: Expr) -> Expr {
        let widened = match &operand {
            Expr::Cast(ty, _) => ty.as_str(),
            _ => return Expr::unary("~", operand),
        };
        let int = match widened {
            "uint32_t" => Int::U32,
            "uint64_t" => Int::U64,
            "int16_t" | "int32_t" => Int::I32,
            "int64_t" => Int::I64,
            _ => return Expr::unary("~", operand),
        };
        let all = literal::integer(int, if int.signed() { -1 } else { Int::max(int) });
        self.helper(Helper::Xor(int), vec![operand, all])
    }

    /// Returns true if a compiler might know a value: a number, or anything except a parameter.
    fn may_be_constant(&self, value: &Expr) -> bool {
        match value {
            Expr::Name(name) => !self.signature.params.iter().any(|param| param.name == *name),
            Expr::Cast(_, inner) | Expr::Unary("-", inner) => self.may_be_constant(inner),
            _ => false,
        }
    }
}

/// Returns the scalar type with this name in C.
fn numeric(ty: &str) -> Option<Scalar> {
    let ints = Int::ALL.into_iter().map(Scalar::Int);
    let floats = [Float::F32, Float::F64].map(Scalar::Float);
    ints.chain(floats).find(|scalar| scalar_type(*scalar) == ty)
}
