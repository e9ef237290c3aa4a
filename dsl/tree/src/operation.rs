//! Operations that have a name in the tree and in the IR, and what each means. Operators are not among them: those of the
//! tree are the author's, those of the IR have one type.
//!
//! Every one is exact: one value for given operands, the same on every target.

use serde::{Deserialize, Serialize};

use crate::number::{Float, Int, Scalar};

/// Functions of scalars that hardware or a few instructions give, the same on every target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Intrinsic {
    /// `sqrt(x)`, floats, rounded once.
    Sqrt,
    /// `|x|`; on signed integers a fault for the smallest value.
    Abs,
    /// The smaller: −0 < +0; a NaN gives the other operand.
    Min,
    /// The larger: −0 < +0; a NaN gives the other operand.
    Max,
    /// `clamp(x, low, high)`: NaN stays NaN; a fault unless `low <= high`.
    Clamp,
    /// `floor(x)`, floats.
    Floor,
    /// The bits of a float as the unsigned integer of its width; every NaN has the canonical bits.
    ToBits,
    /// The bits of a float that is not a NaN; of a NaN, whatever the machine has.
    RawBits,
    /// The float with these bits.
    FromBits,
    /// `copysign(magnitude, sign)`, floats; a NaN counts as positive sign.
    Copysign,
    /// Sum, integers, modulo 2^bits.
    WrappingAdd,
    /// Difference, integers, modulo 2^bits.
    WrappingSub,
    /// Product, integers, modulo 2^bits.
    WrappingMul,
    /// Quotient, signed integers, modulo 2^bits; a fault for a divisor of 0.
    WrappingDiv,
    /// Remainder, signed integers, 0 for a divisor of −1; a fault for a divisor of 0.
    WrappingRem,
    /// Sum, integers, at most and at least what the type holds.
    SaturatingAdd,
    /// Difference, integers, at most and at least what the type holds.
    SaturatingSub,
    /// Product, integers, at most and at least what the type holds.
    SaturatingMul,
    /// The quotient that leaves a remainder of 0 or more: floats (as Rust's std computes it), and signed
    /// integers, where it faults as `/` does.
    DivEuclid,
    /// The remainder of 0 or more: floats (as Rust's std computes it), and signed integers, where it
    /// faults as `%` does.
    RemEuclid,
    /// `|x|` of a signed integer as the unsigned integer of its width.
    UnsignedAbs,
    /// `|x - y|` of integers as the unsigned integer of their width.
    AbsDiff,
    /// Number of bits set in an unsigned integer, as `u32`.
    CountOnes,
    /// Number of zero bits above the highest bit set in an unsigned integer, as `u32`.
    LeadingZeros,
    /// Number of zero bits below the lowest bit set in an unsigned integer, as `u32`.
    TrailingZeros,
    /// The bytes of an unsigned integer of 16 bits or more, turned round.
    SwapBytes,
    /// The smallest whole float not below.
    Ceil,
    /// The whole part of a float, towards zero.
    Trunc,
    /// The nearest whole float; halves go away from zero.
    Round,
    /// 1 with the sign of a float, its zero included; NaN for a NaN.
    Signum,
    /// True if a float is NaN.
    IsNan,
    /// True if a float is neither infinite nor NaN.
    IsFinite,
    /// True if a float is infinite.
    IsInfinite,
    /// An enum as it is, or its last variant for what is none of them: a byte from outside may be either.
    Variant,
}

impl Intrinsic {
    /// The type of the result for operands of type `operand`; none if it does not take that type, as
    /// [`Intrinsic::Variant`] takes no scalar.
    pub fn result(self, operand: Scalar) -> Option<Scalar> {
        use Intrinsic::*;
        let (int, float) = match operand {
            Scalar::Int(int) => (Some(int), None),
            Scalar::Float(float) => (None, Some(float)),
            Scalar::Bool => return None,
        };
        let signed = int.is_some_and(Int::signed);
        match self {
            Min | Max | Clamp => Some(operand),
            Abs | DivEuclid | RemEuclid => (signed || float.is_some()).then_some(operand),
            Sqrt | Floor | Ceil | Trunc | Round | Copysign | Signum => float.map(Scalar::Float),
            IsNan | IsFinite | IsInfinite => float.map(|_| Scalar::Bool),
            WrappingAdd | WrappingSub | WrappingMul => int.map(Scalar::Int),
            SaturatingAdd | SaturatingSub | SaturatingMul => int.map(Scalar::Int),
            WrappingDiv | WrappingRem => signed.then_some(operand),
            UnsignedAbs => int.filter(|_| signed).map(|int| Scalar::Int(int.unsigned())),
            AbsDiff => int.map(|int| Scalar::Int(int.unsigned())),
            CountOnes | LeadingZeros | TrailingZeros => {
                int.filter(|_| !signed).map(|_| Scalar::Int(Int::U32))
            }
            Variant => None,
            SwapBytes => int.filter(|int| !signed && int.bits() > 8).map(Scalar::Int),
            ToBits | RawBits => float.map(|float| Scalar::Int(float.bits_type())),
            FromBits => match int? {
                Int::U32 => Some(Scalar::Float(Float::F32)),
                Int::U64 => Some(Scalar::Float(Float::F64)),
                _ => None,
            },
        }
    }

    /// Returns the number of operands, which are all of one type.
    pub const fn operands(self) -> usize {
        use Intrinsic::*;
        match self {
            Sqrt | Abs | Floor | Ceil | Trunc | Round | Signum | ToBits | RawBits | FromBits
            | IsNan | IsFinite | IsInfinite | UnsignedAbs | CountOnes | LeadingZeros
            | TrailingZeros | SwapBytes | Variant => 1,
            Clamp => 3,
            _ => 2,
        }
    }
}

/// Routines of linear algebra: each in the operation order of the nalgebra routine it represents.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Routine {
    /// `a + b`, each element.
    Add,
    /// `a - b`, each element.
    Sub,
    /// `-a`, each element.
    Neg,
    /// `a * s` for a matrix and a scalar, each element `a * s`.
    Scale,
    /// `a / s` for a matrix and a scalar, each element `a / s`.
    Unscale,
    /// `a.component_mul(&b)`.
    ComponentMul,
    /// `a.component_div(&b)`.
    ComponentDiv,
    /// `a * b`: per output the first product, then k ascending `y = a_k * b_k + y`.
    Product,
    /// `a.tr_mul(&b)`: per output the `dot` of a column of `a` and a column of `b`.
    TrMul,
    /// `a.transpose()`.
    Transpose,
    /// `a.dot(&b)`: 2: `p0+p1`; 3: `(p0+p1)+p2`; 4: `(p0+p2)+(p1+p3)`; else 0 with eight lanes.
    Dot,
    /// `a.cross(&b)`.
    Cross,
    /// `a.norm()`: `sqrt` of the sum over columns (from 0) of `dot(c, c)`.
    Norm,
    /// `a.norm_squared()`: the sum over columns (from 0) of `dot(c, c)`.
    NormSquared,
}
