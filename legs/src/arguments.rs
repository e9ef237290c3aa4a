//! Words to call a function with: from the edges of each type, or small as sensors and set points are.

use bessemer_ir::{Float, Form, Int, Module, Scalar, Type};

use crate::random::Random;

/// The size of the words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// The limits of the types, odd floats, and any bits.
    Edges,
    /// Small numbers.
    Tame,
}

/// The words of a value: lengths for which there is room, nothing where nothing is.
pub fn words(random: &mut Random, module: &Module, ty: &Type, size: Size) -> Vec<u64> {
    let leaves = module.leaves(ty);
    let mut words: Vec<u64> = leaves.iter().map(|ty| word(random, module, ty, size)).collect();
    lengths(random, module, ty, &mut words);
    module.canonical(ty, &mut words);
    words
}

fn lengths<'w>(
    random: &mut Random,
    module: &Module,
    ty: &Type,
    words: &'w mut [u64],
) -> &'w mut [u64] {
    match ty {
        Type::Array { element, len } => {
            (0..*len).fold(words, |words, _| lengths(random, module, element, words))
        }
        Type::Struct(id) => {
            let item = &module.structs[id.index()];
            if item.form == Form::Sequence
                && let Type::Array { len, .. } = item.fields[1].ty
            {
                words[0] = random.below(len as usize + 1) as u64;
            }
            let fields = item.fields.iter();
            fields.fold(words, |words, field| lengths(random, module, &field.ty, words))
        }
        other => &mut words[module.leaves(other).len()..],
    }
}

fn word(random: &mut Random, module: &Module, ty: &Type, size: Size) -> u64 {
    match (ty, size) {
        (Type::Enum(id), _) => random.below(module.enums[id.index()].variants.len()) as u64,
        (Type::Scalar(Scalar::Bool), _) => random.below(2) as u64,
        (Type::Scalar(Scalar::Int(_)), Size::Tame) => random.below(8) as u64,
        (Type::Scalar(Scalar::Int(int)), Size::Edges) => integer(random, *int),
        (Type::Scalar(Scalar::Float(float)), _) => {
            let value = match size {
                Size::Tame => (random.below(4001) as f64 - 2000.0) / 512.0,
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
