//! Linear algebra of the DSL against nalgebra's: the same bits for static sizes, and for larger ones
//! against its matrices of dynamic size.

use bessemer::math::Real;
use bessemer::nalgebra::{DMatrix, SMatrix};
use bessemer_codegen::deep::deep;
use bessemer_tests::random::Random;

/// Class of a matrix' elements.
#[derive(Clone, Copy, Debug)]
enum Kind {
    /// Between −1 and 1.
    Uniform,
    /// Elements of very different sizes.
    Graded,
    /// The last column is the first.
    Singular,
    /// Small whole numbers: ties between pivots, and exact zeros.
    Whole,
    /// A few elements are zero, NaN or infinite.
    Special,
}

const KINDS: [Kind; 5] = [Kind::Uniform, Kind::Graded, Kind::Singular, Kind::Whole, Kind::Special];

fn elements(kind: Kind, rows: usize, cols: usize, random: &mut Random) -> Vec<f64> {
    let mut list: Vec<f64> = (0..rows * cols)
        .map(|index| match kind {
            Kind::Graded => random.unit() * 10f64.powi((index % rows) as i32 % 16 - 8),
            Kind::Whole => random.below(5) as f64 - 2.0,
            _ => random.unit(),
        })
        .collect();
    match kind {
        Kind::Singular => {
            let first = list[..rows].to_vec();
            list[rows * (cols - 1)..].copy_from_slice(&first);
        }
        Kind::Special => {
            let specials = [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 5e-324];
            for _ in 0..1 + random.below(3) {
                let at = random.below(list.len());
                list[at] = specials[random.below(specials.len())];
            }
        }
        _ => {}
    }
    list
}

/// The bits of each element; any NaN is one.
fn bits<T: Real>(elements: &[T]) -> Vec<u64> {
    let word = |x: f64| if x.is_nan() { u64::MAX } else { x.to_bits() };
    elements.iter().map(|&element| word(element.as_f64())).collect()
}

macro_rules! sizes {
    ($($name:ident: $real:ident, $n:literal;)*) => {$(
        #[test]
        fn $name() {
            let mut random = Random(0x9e37_79b9_7f4a_7c15 + $n);
            for kind in KINDS.iter().cycle().take(60) {
                let elements = |cols: usize, random: &mut Random| -> Vec<$real> {
                    let list = elements(*kind, $n, cols, random);
                    list.into_iter().map(|x| x as $real).collect()
                };
                let a = SMatrix::<$real, $n, $n>::from_iterator(elements($n, &mut random));
                let b = SMatrix::<$real, $n, 3>::from_iterator(elements(3, &mut random));

                let (mut factors, mut x) = (a, b);
                let solved = bessemer::solve_mut(&mut factors, &mut x);
                let lu = a.lu();
                match lu.solve(&b) {
                    Some(expected) => {
                        assert!(solved, "{kind:?} {a}");
                        assert_eq!(bits(x.as_slice()), bits(expected.as_slice()), "{kind:?} {a}");
                        assert_eq!(bits(factors.as_slice()), bits(lu.lu_internal().as_slice()));
                    }
                    None => {
                        assert!(!solved, "{kind:?} {a}");
                        assert!(x.iter().chain(&factors).all(|x| x.is_nan()));
                    }
                }

                let mut inverse = a;
                let inverted = bessemer::inverse_mut(&mut inverse);
                match a.try_inverse() {
                    Some(expected) => {
                        assert!(inverted, "{kind:?} {a}");
                        assert_eq!(bits(inverse.as_slice()), bits(expected.as_slice()), "{kind:?} {a}");
                    }
                    None => {
                        assert!(!inverted, "{kind:?} {a}");
                        assert_eq!(bits(inverse.as_slice()), bits(a.as_slice()));
                    }
                }
            }
        }
    )*};
}

sizes! {
    f64_1: f64, 1; f64_2: f64, 2; f64_3: f64, 3; f64_4: f64, 4; f64_5: f64, 5; f64_6: f64, 6;
    f64_8: f64, 8; f64_13: f64, 13; f64_20: f64, 20; f64_33: f64, 33;
    f32_1: f32, 1; f32_2: f32, 2; f32_3: f32, 3; f32_4: f32, 4; f32_5: f32, 5; f32_6: f32, 6;
    f32_9: f32, 9; f32_20: f32, 20;
}

/// Beyond nalgebra's static decompositions: against those of dynamic size.
macro_rules! large {
    ($($name:ident: $n:literal;)*) => {$(
        #[test]
        fn $name() {
            // Unoptimised, matrices pass through the stack by value.
            deep(|| {
                const N: usize = $n;
                let mut random = Random(7 + $n);
                for kind in [Kind::Uniform, Kind::Graded, Kind::Singular, Kind::Special] {
                    let list = elements(kind, N, N, &mut random);
                    let right = elements(kind, N, 2, &mut random);
                    let mut a: Box<SMatrix<f64, N, N>> = Box::new(SMatrix::from_column_slice(&list));
                    let mut b: Box<SMatrix<f64, N, 2>> = Box::new(SMatrix::from_column_slice(&right));
                    let mut inverse = a.clone();
                    let lu = DMatrix::from_vec(N, N, list.clone()).lu();
                    let expected = lu.solve(&DMatrix::from_vec(N, 2, right));
                    assert_eq!(bessemer::solve_mut(&mut *a, &mut *b), expected.is_some(), "{kind:?}");
                    if let Some(expected) = expected {
                        assert_eq!(bits(b.as_slice()), bits(expected.as_slice()), "{kind:?}");
                    }
                    let expected = DMatrix::from_vec(N, N, list).try_inverse();
                    assert_eq!(bessemer::inverse_mut(&mut *inverse), expected.is_some(), "{kind:?}");
                    if let Some(expected) = expected {
                        assert_eq!(bits(inverse.as_slice()), bits(expected.as_slice()), "{kind:?}");
                    }
                }
            });
        }
    )*};
}

large! {
    just_beyond_127_rows: 128; not_a_multiple_of_any_tile: 131; two_hundred_rows: 200;
}
