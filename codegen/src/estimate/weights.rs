//! Weights of operations: instructions, and cycles of two processors.

use std::ops::{Add, AddAssign, Mul};

use bessemer_ir::{Float, Scalar, Type};

/// Instructions and cycles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Instructions of 32-bit ARM with double precision in hardware.
    pub instructions: u64,
    /// Cycles of a processor, in the order of [`PROCESSORS`].
    pub cycles: [u64; 2],
}

/// Processors that cycles are bounded for.
pub const PROCESSORS: [&str; 2] = ["Cortex-A9", "Cortex-M4F"];

/// Classes of operations with equal weights.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// A load, a store, or a constant.
    Move,
    /// An operation on at most 32 bits.
    Word32,
    /// An operation on 64 bits.
    Word64,
    /// A division on at most 32 bits.
    Word32Division,
    /// A division on 64 bits.
    Word64Division,
    /// An operation in single precision.
    Single,
    /// A division or a root in single precision.
    SingleDivision,
    /// An operation in double precision.
    Double,
    /// A division or a root in double precision.
    DoubleDivision,
    /// A remainder in single precision: `fmodf` subtracts once for each of up to 277 binary places of the quotient.
    SingleRemainder,
    /// A remainder in double precision: `fmod` subtracts once for each of up to 2,098 binary places of the quotient.
    DoubleRemainder,
    /// A conversion between floats, or between a float and an integer.
    Conversion,
    /// A branch with its test.
    Branch,
    /// A call and its return, with saved registers.
    Call,
}

/// Weights of each class: its name, instructions, cycles on the Cortex-A9 and on the Cortex-M4F.
pub const WEIGHTS: [(Class, &str, u64, u64, u64); 14] = [
    (Class::Move, "load, store or constant", 1, 2, 2),
    (Class::Word32, "operation on at most 32 bits", 1, 1, 1),
    (Class::Word64, "operation on 64 bits", 3, 3, 4),
    (Class::Word32Division, "division on at most 32 bits", 40, 50, 14),
    (Class::Word64Division, "division on 64 bits", 160, 250, 300),
    (Class::Single, "operation in single precision", 1, 5, 2),
    (Class::SingleDivision, "division or root in single precision", 1, 20, 15),
    (Class::Double, "operation in double precision", 1, 6, 80),
    (Class::DoubleDivision, "division or root in double precision", 1, 32, 600),
    (Class::SingleRemainder, "remainder in single precision", 2_000, 3_000, 3_000),
    (Class::DoubleRemainder, "remainder in double precision", 15_000, 23_000, 26_000),
    (Class::Conversion, "conversion of or to a float", 3, 8, 40),
    (Class::Branch, "branch with its test", 2, 6, 4),
    (Class::Call, "call and return", 12, 30, 24),
];

impl Class {
    /// Returns the weights of one operation.
    pub fn cost(self) -> Cost {
        let found = WEIGHTS.iter().find(|it| it.0 == self);
        found.map_or_else(Cost::default, |(_, _, instructions, a9, m4f)| Cost {
            instructions: *instructions,
            cycles: [*a9, *m4f],
        })
    }

    /// Returns the class of an operation other than a division on a type.
    pub fn arithmetic(ty: &Type) -> Class {
        match ty {
            Type::Scalar(Scalar::Float(Float::F64)) => Class::Double,
            Type::Scalar(Scalar::Float(Float::F32)) => Class::Single,
            Type::Scalar(Scalar::Int(int)) if int.bits() == 64 => Class::Word64,
            Type::Matrix { element, .. } => Class::arithmetic(&Type::Scalar(*element)),
            Type::Array { element, .. } | Type::Slice(element) => Class::arithmetic(element),
            _ => Class::Word32,
        }
    }

    /// Returns the class of a conversion.
    pub fn conversion(from: &Type, to: &Type) -> Class {
        match from.as_float().is_some() || to.as_float().is_some() {
            true => Class::Conversion,
            false => Class::arithmetic(to),
        }
    }
}

impl Cost {
    /// Returns the larger of two costs, each figure by itself.
    pub fn most(self, other: Cost) -> Cost {
        let larger = |at: usize| self.cycles[at].max(other.cycles[at]);
        Cost {
            instructions: self.instructions.max(other.instructions),
            cycles: [larger(0), larger(1)],
        }
    }
}

impl Add for Cost {
    type Output = Cost;

    fn add(self, other: Cost) -> Cost {
        let sum = |at: usize| self.cycles[at].saturating_add(other.cycles[at]);
        Cost {
            instructions: self.instructions.saturating_add(other.instructions),
            cycles: [sum(0), sum(1)],
        }
    }
}

impl AddAssign for Cost {
    fn add_assign(&mut self, other: Cost) {
        *self = *self + other;
    }
}

impl Mul<u64> for Cost {
    type Output = Cost;

    fn mul(self, times: u64) -> Cost {
        let cycles = self.cycles.map(|it| it.saturating_mul(times));
        Cost { instructions: self.instructions.saturating_mul(times), cycles }
    }
}
