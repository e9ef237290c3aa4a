//! Enums of every numbering by a few numbers, each byte tried as a value: variants, and what is none of them.

use bessemer_ir::{
    CompareOp, Enum, EnumId, Expr, ExprKind, Given, Int, Intrinsic, LocalId, Module, Scalar, Span,
    Type, Variant,
};

use crate::passes::analysis::State;

const NUMBERS: [i8; 5] = [-1, 0, 1, 2, 10];

fn module(numbers: &[i8]) -> Module {
    let variants = numbers.iter().map(|number| Variant {
        name: format!("V{number}"),
        docs: Vec::new(),
        value: (*number).into(),
        given: Given::default(),
    });
    let item = Enum {
        name: "Kind".into(),
        module: "demo".into(),
        docs: Vec::new(),
        variants: variants.collect(),
        given: Given::default(),
        span: Span::default(),
    };
    Module { enums: vec![item], ..Module::default() }
}

/// All ways to number three variants.
fn numberings() -> Vec<Vec<i8>> {
    let mut all = Vec::new();
    for a in NUMBERS {
        for b in NUMBERS {
            for c in NUMBERS {
                if a != b && b != c && a != c {
                    all.push(vec![a, b, c]);
                }
            }
        }
    }
    all
}

fn node(kind: ExprKind, ty: Type) -> Expr {
    Expr { kind, ty, span: Span::default() }
}

fn kind() -> Type {
    Type::Enum(EnumId(0))
}

fn int(int: Int) -> Type {
    Type::Scalar(Scalar::Int(int))
}

/// The enum: the byte that is there, and the variant that it is brought to.
fn read() -> [Expr; 2] {
    let raw = Expr::local(LocalId(0), &kind(), Span::default());
    let brought = node(ExprKind::Intrinsic(Intrinsic::Variant, vec![raw.clone()]), kind());
    [raw, brought]
}

/// The number of a byte that represents an enum, in the C.
fn number(byte: i8, brought: bool, numbers: &[i8]) -> i8 {
    if brought && !numbers.contains(&byte) { numbers[numbers.len() - 1] } else { byte }
}

/// Returns the result of the C. A byte that encodes no variant differs from each variant.
fn value(expr: &Expr, byte: i8, numbers: &[i8]) -> i128 {
    match &expr.kind {
        ExprKind::Literal(word) => match expr.ty {
            Type::Enum(_) => numbers[*word as usize].into(),
            _ => Int::I8.from_word(*word),
        },
        ExprKind::Load(_) => byte.into(),
        ExprKind::Intrinsic(..) => number(byte, true, numbers).into(),
        ExprKind::Cast(inner) => match expr.ty.as_int() {
            Some(Int::U8) => i128::from(value(inner, byte, numbers) as u8),
            _ => value(inner, byte, numbers),
        },
        ExprKind::Compare(op, a, b) => {
            let (a, b) = (value(a, byte, numbers), value(b, byte, numbers));
            i128::from(match op {
                CompareOp::Eq => a == b,
                CompareOp::Ne => a != b,
                CompareOp::Le => a <= b,
                _ => a > b,
            })
        }
        kind => unreachable!("no such term: {kind:?}"),
    }
}

fn conditions() -> Vec<Expr> {
    let mut all = Vec::new();
    let compare = |op, a: &Expr, b: Expr| {
        node(ExprKind::Compare(op, Box::new(a.clone()), Box::new(b)), Type::BOOL)
    };
    for enumeration in read() {
        for variant in 0..3 {
            for op in [CompareOp::Eq, CompareOp::Ne] {
                all.push(compare(op, &enumeration, node(ExprKind::Literal(variant), kind())));
            }
        }
        for ty in [int(Int::I8), int(Int::U8)] {
            let cast = node(ExprKind::Cast(Box::new(enumeration.clone())), ty.clone());
            for number in [-1, 0, 1, 3, 10] {
                for op in [CompareOp::Le, CompareOp::Gt, CompareOp::Eq] {
                    let word = match ty.as_int() {
                        Some(Int::U8) if number < 0 => 255,
                        _ => number as i64 as u64,
                    };
                    all.push(compare(op, &cast, node(ExprKind::Literal(word), ty.clone())));
                }
            }
        }
    }
    all
}

/// The proofs, and the knowledge of numbers, hold of every byte that satisfies the state.
fn confirm(state: &State, numbers: &[i8], reach: &[i8], told: &dyn Fn() -> String) {
    for condition in conditions() {
        let wrong = reach.iter().find(|byte| value(&condition, **byte, numbers) == 0);
        if let Some(byte) = wrong {
            assert!(!state.proves(&condition), "{}: {byte} against {condition:?}", told());
        }
    }
    for enumeration in read() {
        for ty in [int(Int::I8), int(Int::U8)] {
            let cast = node(ExprKind::Cast(Box::new(enumeration.clone())), ty);
            let range = state.range(&cast);
            for byte in reach {
                let number = value(&cast, *byte, numbers);
                assert!(range.contains(number), "{}: {number} in {range} of {byte}", told());
            }
        }
    }
}

#[test]
fn no_byte_is_believed() {
    for numbers in numberings() {
        let module = module(&numbers);
        let all: Vec<i8> = (i8::MIN..=i8::MAX).collect();
        confirm(&State::new(&module), &numbers, &all, &|| format!("{numbers:?}"));
        let conditions = conditions();
        for condition in &conditions {
            for truth in [true, false] {
                let state = State::new(&module).assuming(condition, truth);
                let holds = |byte: &i8| value(condition, *byte, &numbers) == i128::from(truth);
                let reach: Vec<i8> = all.iter().copied().filter(holds).collect();
                let told = || format!("{numbers:?}, {condition:?} is {truth}");
                confirm(&state, &numbers, &reach, &told);
            }
        }
    }
}

#[test]
fn the_last_arm_stands_for_what_is_no_variant() {
    for numbers in numberings() {
        let module = module(&numbers);
        let arms: [&[i128]; 2] = [&[0], &[1, 2]];
        for [raw, brought] in [read(), [read()[1].clone(), read()[1].clone()]] {
            for (index, values) in arms.into_iter().enumerate() {
                let mut state = State::new(&module);
                state.select(&raw, values, index == 1);
                let named = |byte: i8| values.iter().any(|at| numbers[*at as usize] == byte);
                let is_brought = raw == brought;
                let reaches = |byte: &i8| {
                    let byte = number(*byte, is_brought, &numbers);
                    named(byte) || index == 1 && !numbers.contains(&byte)
                };
                let reach: Vec<i8> = (i8::MIN..=i8::MAX).filter(reaches).collect();
                confirm(&state, &numbers, &reach, &|| format!("{numbers:?}, arm {index}"));
            }
            let mut state = State::new(&module);
            state.exclude(&raw, vec![2, 0]);
            let other = |byte: &i8| {
                let byte = number(*byte, raw == brought, &numbers);
                byte != numbers[0] && byte != numbers[2]
            };
            let reach: Vec<i8> = (i8::MIN..=i8::MAX).filter(other).collect();
            confirm(&state, &numbers, &reach, &|| format!("{numbers:?}, the rest"));
        }
    }
}

/// Two bytes that are not variants may be equal or different.
#[test]
fn bytes_that_are_no_variants_are_not_told_apart() {
    let module = module(&NUMBERS[..2]);
    let (one, other) = (LocalId(0), LocalId(1));
    let (one, other) =
        (Expr::local(one, &kind(), Span::default()), Expr::local(other, &kind(), Span::default()));
    let mut state = State::new(&module);
    for byte in [&one, &other] {
        state.exclude(byte, vec![0, 1]);
    }
    for op in [CompareOp::Eq, CompareOp::Ne] {
        let (one, other) = (Box::new(one.clone()), Box::new(other.clone()));
        let same = node(ExprKind::Compare(op, one, other), Type::BOOL);
        assert!(!state.proves(&same), "{op:?}");
    }
}
