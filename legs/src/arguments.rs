//! Argument words for calls: from the edges of each type, small like sensor values and setpoints, or around the
//! constants of the program.

use bessemer_ir::visit::Walk as _;
use bessemer_ir::{ExprKind, Float, Form, FunctionId, Int, Module, Scalar, StmtKind, Type};

use crate::random::Random;
use crate::reached::reached;

/// Kind of the argument words.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Size<'n> {
    /// Limits of the types, special floats, and random bits.
    Edges,
    /// Small numbers, like sensor values and setpoints.
    Tame,
    /// The constants of the program, their neighbours, numbers between them, and small numbers.
    Near(&'n Numbers),
}

/// The constants of a program, each once.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Numbers {
    integers: Vec<i128>,
    floats: Vec<f64>,
}

/// Number of words of a constant that are used.
const LOOKED_AT: usize = 64;

impl Numbers {
    /// Collects the numbers in a function and its callees.
    pub fn of(module: &Module, function: FunctionId) -> Numbers {
        let mut numbers = Numbers::default();
        for id in reached(module, function) {
            let body = &module.functions[id.index()].body;
            body.each_expr(|expr| match &expr.kind {
                ExprKind::Literal(word) => numbers.add(&expr.ty, *word),
                ExprKind::Const(id) => {
                    let constant = &module.consts[id.index()];
                    let leaves = module.leaves(&constant.ty);
                    let words = leaves.iter().zip(&constant.words).take(LOOKED_AT);
                    words.for_each(|(ty, word)| numbers.add(ty, *word));
                }
                _ => {}
            });
            body.each_stmt(|stmt| {
                if let StmtKind::Match { scrutinee, arms, .. } = &stmt.kind {
                    let whole = scrutinee.ty.as_int().is_some();
                    let values = arms.iter().filter(|_| whole).flat_map(|arm| &arm.values);
                    numbers.integers.extend(values);
                }
            });
        }
        numbers.integers.sort_unstable();
        numbers.integers.dedup();
        numbers.floats.sort_unstable_by(f64::total_cmp);
        numbers.floats.dedup_by_key(|it| it.to_bits());
        numbers
    }

    fn add(&mut self, ty: &Type, word: u64) {
        match ty {
            Type::Scalar(Scalar::Int(int)) => self.integers.push(int.from_word(word)),
            Type::Scalar(Scalar::Float(Float::F64)) => self.floats.push(f64::from_bits(word)),
            Type::Scalar(Scalar::Float(Float::F32)) => {
                self.floats.push(f64::from(f32::from_bits(word as u32)));
            }
            _ => {}
        }
    }
}

/// Returns the words of a value. Lengths do not exceed capacities, and absent content is zero.
pub fn words(random: &mut Random, module: &Module, ty: &Type, size: Size<'_>) -> Vec<u64> {
    let leaves = module.leaves(ty);
    let mut words: Vec<u64> = leaves.iter().map(|ty| word(random, module, ty, size)).collect();
    each_length(module, ty, &mut words, &mut |length, capacity| {
        *length = random.below(capacity as usize + 1) as u64;
    });
    module.canonical(ty, &mut words);
    words
}

/// Changes up to three words of a value to such as [`words`] returns. `leaves` are those of its type.
pub fn change(
    random: &mut Random,
    module: &Module,
    ty: &Type,
    leaves: &[Type],
    value: &mut [u64],
    size: Size<'_>,
) {
    for _ in 0..=random.below(3) {
        if leaves.is_empty() {
            return;
        }
        let at = random.below(leaves.len());
        value[at] = word(random, module, &leaves[at], size);
    }
    each_length(module, ty, value, &mut |length, capacity| *length = (*length).min(capacity));
    module.canonical(ty, value);
}

/// Sets a word of a value, which stays one of its type. `leaves` are those of its type.
pub fn set(
    module: &Module,
    ty: &Type,
    leaves: &[Type],
    value: &mut [u64],
    (at, word): (usize, u64),
) {
    if at >= leaves.len() {
        return;
    }
    value[at] = word;
    each_length(module, ty, value, &mut |length, capacity| *length = (*length).min(capacity));
    module.canonical(ty, value);
}

/// Returns the words of a type with which an operation may take longest, `subnormal` numbers among them or not.
///
/// They are large and small numbers, mixed mantissas, limits, and all variants.
pub fn slow(module: &Module, ty: &Type, subnormal: bool) -> Vec<u64> {
    match ty {
        Type::Enum(id) => (0..module.enums[id.index()].variants.len() as u64).collect(),
        Type::Scalar(Scalar::Bool) => vec![0, 1],
        Type::Scalar(Scalar::Int(int)) => {
            let (min, max) = (Int::min(*int), Int::max(*int));
            let all = [min, max, max / 3, 0, 1, 2, 3];
            all.iter().map(|it| *it as u64).collect()
        }
        Type::Scalar(Scalar::Float(Float::F64)) => {
            let wanted = SLOW.iter().filter(|it| subnormal || !it.is_subnormal());
            wanted.map(|it| it.to_bits()).collect()
        }
        Type::Scalar(Scalar::Float(Float::F32)) => {
            SLOW_SINGLE.iter().map(|it| u64::from(it.to_bits())).collect()
        }
        _ => Vec::new(),
    }
}

/// Calls `f` with the length of each list in a value, and its capacity. Returns the words behind the value.
fn each_length<'w>(
    module: &Module,
    ty: &Type,
    words: &'w mut [u64],
    f: &mut dyn FnMut(&mut u64, u64),
) -> &'w mut [u64] {
    match ty {
        Type::Array { element, len } => {
            (0..*len).fold(words, |words, _| each_length(module, element, words, f))
        }
        Type::Struct(id) => {
            let item = &module.structs[id.index()];
            if item.form == Form::Sequence
                && let Type::Array { len, .. } = item.fields[1].ty
            {
                f(&mut words[0], u64::from(len));
            }
            let fields = item.fields.iter();
            fields.fold(words, |words, field| each_length(module, &field.ty, words, f))
        }
        other => &mut words[module.width(other)..],
    }
}

fn word(random: &mut Random, module: &Module, ty: &Type, size: Size<'_>) -> u64 {
    match (ty, size) {
        (Type::Enum(id), _) => random.below(module.enums[id.index()].variants.len()) as u64,
        (Type::Scalar(Scalar::Bool), _) => random.below(2) as u64,
        (Type::Scalar(Scalar::Int(_)), Size::Tame) => random.below(8) as u64,
        (Type::Scalar(Scalar::Int(int)), Size::Edges) => integer(random, *int),
        (Type::Scalar(Scalar::Int(int)), Size::Near(numbers)) => {
            near(random, *int, &numbers.integers)
        }
        (Type::Scalar(Scalar::Float(float)), _) => {
            let value = match size {
                Size::Tame => tame(random),
                Size::Near(numbers) => near_float(random, &numbers.floats),
                Size::Edges => match random.below(4) {
                    0 => random.of(&FLOATS),
                    1 => f64::from_bits(random.bits()),
                    _ => (random.below(41) as f64 - 20.0) / 4.0,
                },
            };
            match float {
                Float::F64 => value.to_bits(),
                Float::F32 => u64::from((value as f32).to_bits()),
            }
        }
        _ => 0,
    }
}

fn integer(random: &mut Random, int: Int) -> u64 {
    let (min, max) = (Int::min(int), Int::max(int));
    let value = match random.below(8) {
        0 => random.of(&[min, min + 1, max, max - 1]),
        1 => i128::from(random.bits()),
        2 => -(random.below(8) as i128),
        _ => random.below(8) as i128,
    };
    let span = max - min + 1;
    ((value - min).rem_euclid(span) + min) as u64
}

fn tame(random: &mut Random) -> f64 {
    (random.below(4001) as f64 - 2000.0) / 512.0
}

/// Returns a number of a list, a neighbour of one, or a number between two.
fn near(random: &mut Random, int: Int, numbers: &[i128]) -> u64 {
    let (min, max) = (Int::min(int), Int::max(int));
    let fitting: Vec<i128> =
        numbers.iter().copied().filter(|it| (min..=max).contains(it)).collect();
    if fitting.is_empty() {
        return random.below(8) as u64;
    }
    let (one, other) = (random.of(&fitting), random.of(&fitting));
    let value = match random.below(4) {
        0 => (one + random.below(3) as i128 - 1).clamp(min, max),
        1 => (random.below(8) as i128).clamp(min, max),
        _ => one.min(other) + (random.bits() as i128).rem_euclid((one - other).abs() + 1),
    };
    value as u64
}

fn near_float(random: &mut Random, numbers: &[f64]) -> f64 {
    if numbers.is_empty() {
        return tame(random);
    }
    let (one, other) = (random.of(numbers), random.of(numbers));
    match random.below(4) {
        0 => one,
        1 => tame(random),
        _ => one + (other - one) * (random.below(1025) as f64 / 1024.0),
    }
}

/// Mantissas of mixed bits, in numbers of all sizes.
const SLOW: [f64; 20] = [
    0.0,
    -0.001 / 3.0,
    0.7,
    -7.1,
    1234.5678,
    -1e6 / 3.0,
    -1e-9 / 7.0,
    5e-324,
    f64::from_bits(0x000F_FFFF_FFFF_FFFF),
    f64::from_bits(0x0005_5555_5555_5555),
    -f64::from_bits(0x0000_0000_0055_5555),
    f64::from_bits(0x0010_0000_0000_0001),
    -1.2345e-160,
    1.0 / 3.0,
    -1.0,
    123.456,
    1.2345e160,
    f64::MAX,
    -f64::MAX,
    f64::NAN,
];

const SLOW_SINGLE: [f32; 12] = [
    0.0,
    f32::from_bits(1),
    f32::from_bits(0x007F_FFFF),
    -f32::from_bits(0x0000_5555),
    f32::from_bits(0x0080_0001),
    -1.2345e-20,
    1.0 / 3.0,
    -1.0,
    123.456,
    f32::MAX,
    -f32::MAX,
    f32::NAN,
];

const FLOATS: [f64; 14] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    f64::MAX,
    f64::MIN_POSITIVE,
    5e-324,
    1e-40,
    9007199254740993.0,
    4294967296.5,
    -2147483649.0,
];
