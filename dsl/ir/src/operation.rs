//! The operations that expressions of the IR are made of, and what each means.
//!
//! Every one is exact: one value for given operands, the same on every target.

/// Operators of one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum UnaryOp {
    /// `-x`; on integers a fault for the smallest value.
    Neg,
    /// `!x` on `bool` and integers.
    Not,
}

/// Operators of two operands. On integers: a fault where Rust panics.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum BinaryOp {
    Add,
    Sub,
    Mul,
    Div,
    Rem,
    And,
    Or,
    Xor,
    Shl,
    Shr,
}

/// Comparisons; on floats as IEEE 754 has them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum CompareOp {
    Eq,
    Ne,
    Lt,
    Le,
    Gt,
    Ge,
}

/// Short-circuit operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum LogicOp {
    And,
    Or,
}

/// Functions of scalars that hardware or a few instructions give, the same on every target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
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
}

/// Routines of linear algebra: each in the operation order of the nalgebra routine it stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
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
