//! Costs of functions of the compiler's and the C library, which the C calls and no source has.
//!
//! Each figure is the most that was counted over edge values, subnormal numbers included, of the libraries that come
//! with gcc 12.2: glibc and newlib for the Cortex-A9, newlib for the Cortex-M4. An operation on two normal numbers
//! takes a fraction of it. Another library may take longer; `verify --target` compares the sum with counted calls.

use bessemer_ir::visit::Walk as _;
use bessemer_ir::{BinaryOp, Expr, ExprKind, Float, Intrinsic, Module};

use super::{Cost, Processor};

/// Names, and instructions on the Cortex-A9 and on the Cortex-M4. A remainder of floats subtracts once for each of up to
/// 277 binary places of the quotient; its figure has all of them.
const FUNCTIONS: &[(&str, u64, u64)] = &[
    ("fmodf", 2_200, 2_050),
    ("sqrt", 24, 1_090),
    ("sqrtf", 24, 16),
    ("floor", 44, 116),
    ("ceil", 50, 116),
    ("trunc", 28, 48),
    ("round", 40, 50),
    ("floorf", 28, 26),
    ("ceilf", 28, 26),
    ("truncf", 16, 16),
    ("roundf", 20, 18),
    ("__aeabi_dadd", 0, 104),
    ("__aeabi_dsub", 0, 105),
    ("__aeabi_dmul", 0, 395),
    ("__aeabi_ddiv", 0, 920),
    ("__aeabi_dcmplt", 0, 62),
    ("__aeabi_dcmple", 0, 62),
    ("__aeabi_dcmpgt", 0, 68),
    ("__aeabi_dcmpge", 0, 68),
    ("__aeabi_dcmpeq", 0, 64),
    ("__aeabi_dcmpun", 0, 40),
    ("__aeabi_ui2d", 0, 38),
    ("__aeabi_i2d", 0, 40),
    ("__aeabi_ul2d", 50, 50),
    ("__aeabi_l2d", 52, 52),
    ("__aeabi_ul2f", 34, 34),
    ("__aeabi_l2f", 36, 36),
    ("__aeabi_d2iz", 0, 40),
    ("__aeabi_d2uiz", 0, 40),
    ("__aeabi_d2ulz", 40, 570),
    ("__aeabi_d2lz", 50, 380),
    ("__aeabi_f2ulz", 40, 240),
    ("__aeabi_f2lz", 50, 185),
    ("__aeabi_d2f", 0, 42),
    ("__aeabi_f2d", 0, 52),
    ("__aeabi_uidiv", 196, 0),
    ("__aeabi_idiv", 200, 0),
    ("__aeabi_uidivmod", 204, 0),
    ("__aeabi_idivmod", 208, 0),
    ("__aeabi_uldivmod", 800, 100),
    ("__aeabi_ldivmod", 810, 114),
];

/// Instructions before and after the bytes of a copy.
const COPY: u64 = 64;

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

/// Returns the cost of a call, in which a quotient has at most `places` binary places.
///
/// A function that is not in the table, and a copy of unknown size, have no cost.
pub fn cost(processor: Processor, name: &str, bytes: Option<u64>, places: u64) -> Option<Cost> {
    let instructions = match name {
        "memcpy" | "memset" | "memmove" => bytes? + COPY,
        "fmod" => {
            let (besides, pass) = REMAINDER;
            besides + places * pass
        }
        _ => {
            let (_, a9, m4f) = FUNCTIONS.iter().find(|it| it.0 == name)?;
            let count = if processor == Processor::A9 { *a9 } else { *m4f };
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
mod tests {
    use super::*;
    use crate::harness::MARKS;
    use crate::longest::processor;
    use crate::toolchain::{ARM, BARE_A9, CORTEX_M4F, Toolchain};
    use crate::watch;

    /// Dividends and divisors whose quotients have many binary places, of all kinds: nearly all ones, zeros, or mixed.
    fn remainders() -> Vec<(f64, f64)> {
        let ones = (1_u64 << 52) - 1;
        let largest = |mantissa: u64| f64::from_bits(2046 << 52 | mantissa);
        let mut pairs = Vec::new();
        for divisor in [1.0, 3.0, std::f64::consts::TAU, f64::from_bits(1), f64::from_bits(ones)] {
            let mixed = [0, 1, ones, 0x5_5555_5555_5555, 0x9_2492_4924_9249];
            pairs.extend(mixed.map(|mantissa| (largest(mantissa), divisor)));
        }
        // The places of (m - 1) / m and of 1 / m have a period of nearly all ones, and of nearly all zeros.
        for exponent in [1, 53, 1023] {
            let divisor = f64::from_bits(exponent << 52 | ones);
            pairs.extend([ones - 1, 0, 1].map(|mantissa| (largest(mantissa), divisor)));
        }
        pairs
    }

    fn remainders_of_floats() -> Vec<(f32, f32)> {
        let ones = (1_u32 << 23) - 1;
        let largest = |mantissa: u32| f32::from_bits(254 << 23 | mantissa);
        let mut pairs = Vec::new();
        for divisor in
            [1.0, 3.0, f32::from_bits(1), f32::from_bits(ones), f32::from_bits(1 << 23 | ones)]
        {
            let mixed = [0, 1, ones - 1, ones, 0x25_5555];
            pairs.extend(mixed.map(|mantissa| (largest(mantissa), divisor)));
        }
        pairs
    }

    /// Counts the calls on an emulated processor, with the instructions of their caller.
    fn counts(
        toolchain: &Toolchain,
        pairs: &[(String, String)],
        function: &str,
        ty: &str,
    ) -> Vec<u64> {
        let folder = tempfile::tempdir().expect("a folder");
        let mut text = format!(
            "#include <math.h>\n#include <stdint.h>\n#include <stdlib.h>\n{MARKS}int main(void)\n{{\n    \
             static volatile {ty} x;\n    static volatile {ty} y;\n    static volatile {ty} z;\n"
        );
        for (x, y) in pairs {
            text += &format!(
                "    x = {x}; y = {y};\n    bench_begin(); z = {function}(x, y); bench_end(); (void)z;\n"
            );
        }
        text += "    exit(0);\n}\n";
        let main = folder.path().join("remainders.c");
        std::fs::write(&main, text).expect("a file");
        let program = watch::built(toolchain, folder.path(), &main, &[]).expect("it compiles");
        let own = folder.path().join(watch::FOLDER);
        // The program writes no words.
        std::fs::write(own.join("words.out"), "").expect("a file");
        watch::counted(toolchain, &own, &program, &[]).expect("it runs").counts
    }

    /// No call takes more than its figure, and the figure is near the largest count.
    #[test]
    fn remainders_take_no_more_than_their_figures() {
        // Instructions of `main` between the marks.
        const CALLER: u64 = 16;
        let doubles = remainders();
        let floats = remainders_of_floats();
        let texts = |it: &(f64, f64)| (format!("{:e}", it.0), format!("{:e}", it.1));
        let of_doubles: Vec<_> = doubles.iter().map(texts).collect();
        let texts = |it: &(f32, f32)| (format!("{:e}F", it.0), format!("{:e}F", it.1));
        let of_floats: Vec<_> = floats.iter().map(texts).collect();
        for toolchain in [ARM, BARE_A9, CORTEX_M4F].iter().filter(|it| it.is_there()) {
            let processor = processor(toolchain).expect("the model has it");
            let bound = |function, places| {
                cost(processor, function, None, places).expect("a figure").instructions + CALLER
            };
            let mut most = 0;
            for (pair, count) in
                doubles.iter().zip(counts(toolchain, &of_doubles, "fmod", "double"))
            {
                let bound = bound("fmod", quotient(pair.1));
                assert!(
                    count <= bound,
                    "{processor:?}: fmod of {pair:?} takes {count}, not {bound}"
                );
                most = most.max(100 * count / bound);
            }
            let single =
                counts(toolchain, &of_floats, "fmodf", "float").into_iter().max().expect("a count");
            let bound = bound("fmodf", 0);
            assert!(single <= bound, "{processor:?}: fmodf takes {single}, not {bound}");
            assert!(
                most > 80 && 100 * single > 70 * bound,
                "{processor:?}: {most} percent, {single} of {bound}"
            );
        }
    }

    #[test]
    fn copies_cost_their_bytes_and_unknown_functions_have_no_cost() {
        let of = |name, bytes| cost(Processor::M4f, name, bytes, 0).map(|it| it.instructions);
        assert_eq!([of("memcpy", Some(8)), of("memcpy", None)], [Some(72), None]);
        assert_eq!(quotient(std::f64::consts::TAU), 1023);
        assert_eq!([quotient(0.0), quotient(f64::from_bits(1)), quotient(f64::NAN)], [PLACES; 3]);
        assert_eq!(["__aeabi_uidiv", "printf"].map(|it| of(it, Some(1))), [None; 2]);
    }
}
