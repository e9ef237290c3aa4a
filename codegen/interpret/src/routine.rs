//! Linear algebra in the order of operations of nalgebra 0.35, element by element.
//!
//! Invariants: sums have exactly the order that `bessemer_ir::Routine` states; a product is never fused with a sum;
//! the result does not overlap the operands.
//!
//! No tiles, no unrolling: this is the reference for kernels.

use core::ops::{Add, Div, Mul, Neg, Sub};

use bessemer_ir::{Float, Routine, Scalar, Type};

/// Operations of a float type that the routines need.
pub(super) trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + PartialOrd
{
    const ZERO: Self;
    const ONE: Self;
    const NAN: Self;
    fn of(word: u64) -> Self;
    fn word(self) -> u64;
    fn root(self) -> Self;
    fn magnitude(self) -> Self;
}

impl Real for f64 {
    const ZERO: f64 = 0.0;
    const ONE: f64 = 1.0;
    const NAN: f64 = f64::NAN;
    fn of(word: u64) -> f64 {
        f64::from_bits(word)
    }
    fn word(self) -> u64 {
        self.to_bits()
    }
    fn root(self) -> f64 {
        self.sqrt()
    }
    fn magnitude(self) -> f64 {
        self.abs()
    }
}

impl Real for f32 {
    const ZERO: f32 = 0.0;
    const ONE: f32 = 1.0;
    const NAN: f32 = f32::NAN;
    fn of(word: u64) -> f32 {
        f32::from_bits(word as u32)
    }
    fn word(self) -> u64 {
        u64::from(self.to_bits())
    }
    fn root(self) -> f32 {
        self.sqrt()
    }
    fn magnitude(self) -> f32 {
        self.abs()
    }
}

/// Returns rows and columns of an operand; one and one for a scalar.
fn shape(ty: &Type) -> (usize, usize) {
    match ty {
        Type::Matrix { rows, cols, .. } => (*rows as usize, *cols as usize),
        _ => (1, 1),
    }
}

/// An operand: its type and its address.
#[derive(Clone, Copy)]
pub(super) struct Operand<'m> {
    pub ty: &'m Type,
    pub at: usize,
}

/// Computes `routine` of `operands`, and writes the result from the address `out` on.
pub(super) fn routine(memory: &mut [u64], routine: Routine, operands: &[Operand<'_>], out: usize) {
    let a = operands[0];
    let b = operands.get(1).copied().unwrap_or(a);
    match a.ty {
        // Moves words, whatever they are.
        Type::Matrix { .. } if routine == Routine::Transpose => transpose(memory, a, out),
        Type::Matrix { element: Scalar::Float(Float::F64), .. } => {
            compute::<f64>(memory, routine, a, b, out);
        }
        Type::Matrix { element: Scalar::Float(Float::F32), .. } => {
            compute::<f32>(memory, routine, a, b, out);
        }
        _ => unreachable!("validated: routines take matrices of floats"),
    }
}

fn transpose(memory: &mut [u64], a: Operand<'_>, out: usize) {
    let (rows, cols) = shape(a.ty);
    for row in 0..rows {
        for col in 0..cols {
            memory[out + col + row * cols] = memory[a.at + row + col * rows];
        }
    }
}

fn compute<R: Real>(
    memory: &mut [u64],
    routine: Routine,
    a: Operand<'_>,
    b: Operand<'_>,
    out: usize,
) {
    let (rows, cols) = shape(a.ty);
    let len = rows * cols;
    match routine {
        Routine::Add => each::<R>(memory, len, a.at, b.at, out, |x, y| x + y),
        Routine::Sub => each::<R>(memory, len, a.at, b.at, out, |x, y| x - y),
        Routine::ComponentMul => each::<R>(memory, len, a.at, b.at, out, |x, y| x * y),
        Routine::ComponentDiv => each::<R>(memory, len, a.at, b.at, out, |x, y| x / y),
        Routine::Neg => each::<R>(memory, len, a.at, a.at, out, |x, _| -x),
        Routine::Abs => each::<R>(memory, len, a.at, a.at, out, |x, _| x.magnitude()),
        Routine::Inf => each::<R>(memory, len, a.at, b.at, out, lower),
        Routine::Sup => each::<R>(memory, len, a.at, b.at, out, upper),
        Routine::Scale => scaled::<R>(memory, len, a.at, b.at, out, |x, s| x * s),
        Routine::Unscale => scaled::<R>(memory, len, a.at, b.at, out, |x, s| x / s),
        Routine::Product => product::<R>(memory, a, b, out),
        Routine::TrMul => {
            let outputs = shape(b.ty).1;
            for row in 0..cols {
                for col in 0..outputs {
                    let sum = dot::<R>(memory, (rows, 1), a.at + row * rows, b.at + col * rows);
                    memory[out + row + col * cols] = sum.word();
                }
            }
        }
        Routine::Dot => memory[out] = dot::<R>(memory, (rows, cols), a.at, b.at).word(),
        Routine::Cross => cross::<R>(memory, a.at, b.at, out),
        Routine::NormSquared => memory[out] = norm_squared::<R>(memory, a).word(),
        Routine::Norm => memory[out] = norm_squared::<R>(memory, a).root().word(),
        Routine::Amax => memory[out] = extreme::<R>(memory, len, a.at, upper).word(),
        Routine::Amin => memory[out] = extreme::<R>(memory, len, a.at, lower).word(),
        Routine::Transpose => unreachable!("done before"),
    }
}

fn each<R: Real>(
    memory: &mut [u64],
    len: usize,
    a: usize,
    b: usize,
    out: usize,
    op: impl Fn(R, R) -> R,
) {
    for index in 0..len {
        let value = op(R::of(memory[a + index]), R::of(memory[b + index]));
        memory[out + index] = value.word();
    }
}

/// Returns the larger of two; the second if they are unordered.
fn upper<R: Real>(x: R, y: R) -> R {
    if x >= y { x } else { y }
}

/// Returns the smaller of two; the second if they are unordered.
fn lower<R: Real>(x: R, y: R) -> R {
    if x <= y { x } else { y }
}

/// Chooses among the magnitudes of `len` elements, in their order.
fn extreme<R: Real>(memory: &[u64], len: usize, a: usize, choose: fn(R, R) -> R) -> R {
    let magnitude = |index: usize| R::of(memory[a + index]).magnitude();
    (1..len).fold(magnitude(0), |chosen, index| choose(chosen, magnitude(index)))
}

fn scaled<R: Real>(
    memory: &mut [u64],
    len: usize,
    a: usize,
    scalar: usize,
    out: usize,
    op: impl Fn(R, R) -> R,
) {
    let scalar = R::of(memory[scalar]);
    for index in 0..len {
        memory[out + index] = op(R::of(memory[a + index]), scalar).word();
    }
}

/// Computes a product: each element begins with its first term, not with 0, and adds `a_k * b_k` for ascending k.
fn product<R: Real>(memory: &mut [u64], a: Operand<'_>, b: Operand<'_>, out: usize) {
    let (rows, inner) = shape(a.ty);
    let cols = shape(b.ty).1;
    for col in 0..cols {
        for row in 0..rows {
            let term = |k: usize| {
                R::of(memory[a.at + row + k * rows]) * R::of(memory[b.at + k + col * inner])
            };
            let sum = (1..inner).fold(term(0), |sum, k| term(k) + sum);
            memory[out + row + col * rows] = sum.word();
        }
    }
}

/// Computes `dot` of two operands of this shape. Columns of 2, 3 and 4 elements have special orders; others use eight
/// lanes along each column.
fn dot<R: Real>(memory: &[u64], (rows, cols): (usize, usize), a: usize, b: usize) -> R {
    let term = |index: usize| R::of(memory[a + index]) * R::of(memory[b + index]);
    match (rows, cols) {
        (2, 1) => return term(0) + term(1),
        (3, 1) => return (term(0) + term(1)) + term(2),
        (4, 1) => return (term(0) + term(2)) + (term(1) + term(3)),
        _ => {}
    }
    (0..cols).fold(R::ZERO, |sum, col| add_lanes(sum, rows, |row| term(col * rows + row)))
}

/// Returns the sum of `count` terms from zero, in eight lanes.
pub(super) fn lanes<R: Real>(count: usize, term: impl Fn(usize) -> R) -> R {
    add_lanes(R::ZERO, count, term)
}

fn add_lanes<R: Real>(mut sum: R, count: usize, term: impl Fn(usize) -> R) -> R {
    let mut lanes = [R::ZERO; 8];
    let blocks = count / 8;
    for block in 0..blocks {
        for (lane, value) in lanes.iter_mut().enumerate() {
            *value = *value + term(block * 8 + lane);
        }
    }
    for lane in 0..4 {
        sum = sum + (lanes[lane] + lanes[lane + 4]);
    }
    for index in blocks * 8..count {
        sum = sum + term(index);
    }
    sum
}

fn norm_squared<R: Real>(memory: &[u64], a: Operand<'_>) -> R {
    let (rows, cols) = shape(a.ty);
    (0..cols).fold(R::ZERO, |sum, col| {
        let column = a.at + col * rows;
        sum + dot::<R>(memory, (rows, 1), column, column)
    })
}

fn cross<R: Real>(memory: &mut [u64], a: usize, b: usize, out: usize) {
    let x = |index: usize| R::of(memory[a + index]);
    let y = |index: usize| R::of(memory[b + index]);
    let values = [x(1) * y(2) - x(2) * y(1), x(2) * y(0) - x(0) * y(2), x(0) * y(1) - x(1) * y(0)];
    for (index, value) in values.into_iter().enumerate() {
        memory[out + index] = value.word();
    }
}
