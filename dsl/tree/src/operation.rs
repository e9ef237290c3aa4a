//! Operations that tree and IR share. Operators are not among them: those of the tree are the author's, those of the
//! IR have one type.
//!
//! Each operation is exact: one value for its operands, equal on every target.

use serde::{Deserialize, Serialize};

use crate::number::{Float, Int, Scalar};

/// Functions of scalars that hardware or a few instructions compute, equal on every target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Intrinsic {
    /// `sqrt(x)`, floats, rounded once.
    Sqrt,
    /// `|x|`; on signed integers it faults for the smallest value.
    Abs,
    /// The smaller operand, where −0 < +0; a NaN is ignored.
    Min,
    /// The larger operand, where −0 < +0; a NaN is ignored.
    Max,
    /// `clamp(x, low, high)`; NaN stays NaN. Faults unless `low <= high`.
    Clamp,
    /// `floor(x)`, floats.
    Floor,
    /// The bits of a float as an unsigned integer; every NaN has the canonical bits.
    ToBits,
    /// The bits of a float; of a NaN, the machine's bits.
    RawBits,
    /// The float with these bits.
    FromBits,
    /// `copysign(magnitude, sign)` of floats; a NaN has positive sign.
    Copysign,
    /// Sum of integers modulo 2^bits.
    WrappingAdd,
    /// Difference of integers modulo 2^bits.
    WrappingSub,
    /// Product of integers modulo 2^bits.
    WrappingMul,
    /// Quotient of signed integers modulo 2^bits; faults for the divisor 0.
    WrappingDiv,
    /// Remainder of signed integers, 0 for the divisor −1; faults for the divisor 0.
    WrappingRem,
    /// Saturating sum of integers.
    SaturatingAdd,
    /// Saturating difference of integers.
    SaturatingSub,
    /// Saturating product of integers.
    SaturatingMul,
    /// Quotient whose remainder is not negative: of floats (as Rust's std computes it), and of signed integers, where
    /// it faults as `/` does.
    DivEuclid,
    /// Remainder that is not negative: of floats (as Rust's std computes it), and of signed integers, where it faults
    /// as `%` does.
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
    /// An unsigned integer of at least 16 bits with its bytes in reverse order.
    SwapBytes,
    /// Smallest whole float that is not less.
    Ceil,
    /// Whole part of a float, towards zero.
    Trunc,
    /// Nearest whole float; halves are rounded away from zero.
    Round,
    /// 1 with the sign of a float, also of zero; NaN for a NaN.
    Signum,
    /// True if a float is NaN.
    IsNan,
    /// True if a float is neither infinite nor NaN.
    IsFinite,
    /// True if a float is infinite.
    IsInfinite,
    /// An enum, or its last variant if its value is no variant, since a byte from outside may be any.
    Variant,
}

impl Intrinsic {
    /// Returns the result type for operands of type `operand`; none if it does not take that type, as
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

/// Routines of linear algebra, each in the order of operations of the nalgebra routine it represents.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Routine {
    /// `a + b` of elements.
    Add,
    /// `a - b` of elements.
    Sub,
    /// `-a` of elements.
    Neg,
    /// `a * s` of a matrix and a scalar.
    Scale,
    /// `a / s` of a matrix and a scalar.
    Unscale,
    /// `a.component_mul(&b)`.
    ComponentMul,
    /// `a.component_div(&b)`.
    ComponentDiv,
    /// `a.inf(&b)`: of each pair the first if it is at most the second, else the second.
    Inf,
    /// `a.sup(&b)`: of each pair the first if it is at least the second, else the second.
    Sup,
    /// `a.abs()` of elements.
    Abs,
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
    /// `a.amax()`: `sup` of the magnitudes, by columns.
    Amax,
    /// `a.amin()`: `inf` of the magnitudes, by columns.
    Amin,
}
