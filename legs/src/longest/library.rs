//! Costs of functions of the compiler's and the C library, which the C calls and no source has.
//!
//! Each figure is the most that was counted over edge values of the libraries that come with gcc 12.2: glibc and newlib for
//! the Cortex-A9, newlib for the Cortex-M4. Another library may take longer; `verify --target` compares the sum with
//! counted calls.
//!
//! The double precision of a Cortex-M4 is a library's. Its operations shift a subnormal number bit by bit, so a product
//! takes 671 instructions in place of 62. A figure is therefore for any numbers, or for [`Numbers::Normal`] ones.

use bessemer_ir::visit::Walk as _;
use bessemer_ir::{BinaryOp, Expr, ExprKind, Float, Intrinsic, Module};

use super::{Cost, Processor};

/// Numbers that a call meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Numbers {
    /// All.
    Any,
    /// No operand and no result of an operation in double precision is subnormal.
    Normal,
}

/// Names, and instructions on the Cortex-A9, on the Cortex-M4, and on the Cortex-M4 if all numbers are normal. A remainder of
/// floats subtracts once for each of up to 277 binary places of the quotient; its figure has all of them.
const FUNCTIONS: &[(&str, u64, u64, u64)] = &[
    ("fmodf", 2_200, 2_050, 2_050),
    ("sqrt", 24, 1_120, 1_100),
    ("sqrtf", 24, 16, 16),
    ("floor", 48, 120, 120),
    ("ceil", 52, 120, 120),
    ("trunc", 28, 48, 48),
    ("round", 44, 50, 50),
    ("floorf", 28, 26, 26),
    ("ceilf", 28, 26, 26),
    ("truncf", 16, 16, 16),
    ("roundf", 20, 18, 18),
    ("__aeabi_dadd", 0, 116, 96),
    ("__aeabi_dsub", 0, 117, 97),
    ("__aeabi_dmul", 0, 690, 60),
    ("__aeabi_ddiv", 0, 1_240, 590),
    ("__aeabi_dcmplt", 0, 54, 54),
    ("__aeabi_dcmple", 0, 54, 54),
    ("__aeabi_dcmpgt", 0, 60, 60),
    ("__aeabi_dcmpge", 0, 60, 60),
    ("__aeabi_dcmpeq", 0, 54, 54),
    ("__aeabi_dcmpun", 0, 16, 16),
    ("__aeabi_ui2d", 0, 38, 38),
    ("__aeabi_i2d", 0, 40, 40),
    ("__aeabi_ul2d", 50, 50, 50),
    ("__aeabi_l2d", 52, 52, 52),
    ("__aeabi_ul2f", 34, 34, 34),
    ("__aeabi_l2f", 36, 36, 36),
    ("__aeabi_d2iz", 0, 18, 18),
    ("__aeabi_d2uiz", 0, 16, 16),
    ("__aeabi_d2ulz", 16, 570, 240),
    ("__aeabi_d2lz", 28, 600, 280),
    ("__aeabi_f2ulz", 16, 240, 240),
    ("__aeabi_f2lz", 28, 250, 250),
    ("__aeabi_d2f", 0, 24, 24),
    ("__aeabi_f2d", 0, 50, 50),
    ("__aeabi_uidiv", 184, 0, 0),
    ("__aeabi_idiv", 192, 0, 0),
    ("__aeabi_uidivmod", 192, 0, 0),
    ("__aeabi_idivmod", 200, 0, 0),
    ("__aeabi_uldivmod", 800, 80, 80),
    ("__aeabi_ldivmod", 810, 90, 90),
];

/// Operations of doubles on the Cortex-M4, and instructions if the second operand is zero. Others take about their usual figure
/// then.
const WITH_ZERO: [(&str, u64); 2] = [("__aeabi_dadd", 34), ("__aeabi_dsub", 33)];

/// Known second and third argument of a call.
#[derive(Clone, Copy, Debug, Default)]
pub struct Known {
    /// The bytes of a copy.
    pub bytes: Option<u64>,
    /// True if the second argument is a zero in double precision.
    pub zero: bool,
}

/// Instructions of a copy besides its bytes.
const COPY: u64 = 64;

/// Returns the functions that take longer with subnormal numbers.
pub fn slow() -> impl Iterator<Item = &'static str> {
    FUNCTIONS.iter().filter(|(_, _, any, normal)| any != normal).map(|it| it.0)
}

/// Most binary places of a quotient of doubles, each of which is one pass of `fmod`.
const PLACES: u64 = 2_098;

/// Instructions of `fmod` besides its passes, and of a pass: of a quotient whose binary places take the longer way. On the
/// Cortex-A9 those of glibc, which has one more than newlib.
const REMAINDER: (u64, u64) = (80, 14);

/// Returns the most binary places of the quotient of a remainder in a module: fewer if all divisors are constants.
pub fn places(module: &Module) -> u64 {
    let mut most = 0;
    for function in &module.functions {
        function.body.each_expr(|expr| {
            let divisor = match &expr.kind {
                ExprKind::Binary(BinaryOp::Rem, _, divisor) => divisor,
                ExprKind::Intrinsic(Intrinsic::RemEuclid | Intrinsic::DivEuclid, operands) => {
                    let Some(divisor) = operands.get(1) else { return };
                    divisor
                }
                _ => return,
            };
            if divisor.ty.as_float() == Some(Float::F64) {
                most = most.max(constant(module, divisor).map_or(PLACES, quotient));
            }
        });
    }
    most
}

/// Returns the value of a double that is computed from constants.
fn constant(module: &Module, expr: &Expr) -> Option<f64> {
    Some(match &expr.kind {
        ExprKind::Literal(word) => f64::from_bits(*word),
        ExprKind::Const(id) => f64::from_bits(*module.consts[id.index()].words.first()?),
        ExprKind::Binary(op, left, right) => {
            let (left, right) = (constant(module, left)?, constant(module, right)?);
            match op {
                BinaryOp::Add => left + right,
                BinaryOp::Sub => left - right,
                BinaryOp::Mul => left * right,
                BinaryOp::Div => left / right,
                _ => return None,
            }
        }
        _ => return None,
    })
}

/// Returns the most binary places of a quotient by this double.
fn quotient(divisor: f64) -> u64 {
    // The largest dividend is below 2 to the power of 1,024.
    match divisor.to_bits() >> 52 & 0x7FF {
        0 | 0x7FF => PLACES,
        biased => 1024 + 1023 - biased + 1,
    }
}

/// Returns the cost of a call with these arguments, in which a quotient has at most `places` binary places.
///
/// A function that is not in the table, and a copy of unknown size, have no cost.
pub fn cost(
    processor: Processor,
    name: &str,
    Known { bytes, zero }: Known,
    places: u64,
    numbers: Numbers,
) -> Option<Cost> {
    let with_zero = || WITH_ZERO.iter().find(|it| it.0 == name).map(|it| it.1);
    let instructions = match name {
        "memcpy" if processor == Processor::A9 => COPY - 8 + bytes? * 7 / 16,
        "memcpy" => COPY + bytes? * 9 / 16,
        "memset" => COPY + bytes? / 2,
        // Byte by byte if the end of the one memory overlaps the beginning of the other.
        "memmove" => COPY + bytes? * 4,
        "fmod" => {
            let (besides, pass) = REMAINDER;
            besides + places * pass
        }
        _ if zero && processor == Processor::M4f && with_zero().is_some() => with_zero()?,
        _ => {
            let (_, a9, any, normal) = FUNCTIONS.iter().find(|it| it.0 == name)?;
            let count = match (processor, numbers) {
                (Processor::A9, _) => *a9,
                (Processor::M4f, Numbers::Any) => *any,
                (Processor::M4f, Numbers::Normal) => *normal,
            };
            (count > 0).then_some(count)?
        }
    };
    // Loads, branches and multiplications among them: one and a half cycles each, on the Cortex-A9 two.
    let cycles = match processor {
        Processor::A9 => 2 * instructions,
        Processor::M4f => instructions * 3 / 2,
    };
    Some(Cost { instructions, cycles })
}

#[cfg(test)]
mod tests;
