//! Eigenvalues, singular values and exponentials, which the DSL computes in an order of its own. They are compared with
//! their definitions and with nalgebra's, within a stated error.

use bessemer::linear::{ldl, svd, symmetric_eigen};
use bessemer::math::{Real, SquareMethods};
use bessemer::nalgebra::{SMatrix, SVector};
use bessemer_tests::random::Random;

/// Matrices of several kinds: between −1 and 1, of very different sizes, of low rank, nearly diagonal.
fn matrix<T: Real, const R: usize, const C: usize>(
    kind: usize,
    random: &mut Random,
) -> SMatrix<T, R, C> {
    let (mut left, mut right) = (SMatrix::<f64, R, 2>::zeros(), SMatrix::<f64, 2, C>::zeros());
    left.iter_mut().chain(right.iter_mut()).for_each(|element| *element = random.unit());
    let low = left * right;
    SMatrix::from_fn(|row, column| {
        let element = match kind {
            0 => random.unit(),
            1 => random.unit() * 10f64.powi((row % 8) as i32 + (column % 8) as i32 - 6),
            2 => low[(row, column)],
            _ if row == column => 1.0 + (row / 2) as f64,
            _ => random.unit() * 1e-9,
        };
        bessemer::math::real(element)
    })
}

macro_rules! sizes {
    ($($name:ident: $real:ident $r:tt $c:tt;)*) => {$(
        #[test]
        fn $name() {
            let mut random = Random(0x9e37_79b9_7f4a_7c15);
            for kind in (0..4).cycle().take(80) {
                eigenvalues::<$real, $c>(kind, &mut random);
                singular_values::<$real, $r, $c>(kind, &mut random);
            }
        }
    )*};
}

sizes! {
    f64_1: f64 1 1; f64_2: f64 3 2; f64_3: f64 3 3; f64_6: f64 8 6; f64_12: f64 12 12; f64_20: f64 24 20;
    f32_2: f32 2 2; f32_5: f32 9 5; f32_12: f32 12 12;
}

/// `A V = V Λ`, `Vᵀ V = 1`, both within 8 n roundings of the norm, and the values in order.
fn eigenvalues<T: Real, const N: usize>(kind: usize, random: &mut Random) {
    let a = matrix::<T, N, N>(kind, random);
    let a = a + a.transpose();
    let eigen = symmetric_eigen(&a);
    let bound = T::EPSILON * bessemer::math::real(8.0 * N as f64);
    let v = eigen.eigenvectors;
    let off = a * v - v * SMatrix::from_diagonal(&eigen.eigenvalues);
    assert!(off.norm() <= bound * a.norm(), "{kind}: {off} of {a}");
    let skew = v.tr_mul(&v) - SMatrix::identity();
    assert!(skew.norm() <= bound, "{kind}: {skew} of {a}");
    let values = eigen.eigenvalues;
    assert!((1..N).all(|k| values[k - 1] <= values[k]), "{values}");
}

/// Checks `U Σ Vᵀ = A` and `V Vᵀ = 1`, both within 8 n roundings of the norm. If no value is zero, `Uᵀ U = 1` is
/// checked too.
fn singular_values<T: Real, const R: usize, const C: usize>(kind: usize, random: &mut Random) {
    let a = matrix::<T, R, C>(kind, random);
    let found = svd(&a);
    let bound = T::EPSILON * bessemer::math::real(8.0 * R as f64);
    let off = found.u * SMatrix::from_diagonal(&found.singular_values) * found.v_t - a;
    assert!(off.norm() <= bound * a.norm(), "{kind}: {off} of {a}");
    let skew = found.v_t * found.v_t.transpose() - SMatrix::identity();
    assert!(skew.norm() <= bound, "{kind}: {skew} of {a}");
    let values = found.singular_values;
    assert!((1..C).all(|k| values[k - 1] >= values[k]), "{values}");
    if values[C - 1] > T::ZERO {
        let skew = found.u.tr_mul(&found.u) - SMatrix::identity();
        assert!(skew.norm() <= bound, "{kind}: {skew} of {a}");
    }
}

/// The values are nalgebra's within 4 n roundings of the largest.
#[test]
fn as_nalgebra_has_them() {
    let mut random = Random(77);
    for kind in (0..4).cycle().take(40) {
        let a = matrix::<f64, 6, 6>(kind, &mut random);
        let symmetric = a + a.transpose();
        let bound = f64::EPSILON * 24.0;
        let mut expected: Vec<f64> =
            symmetric.symmetric_eigen().eigenvalues.iter().copied().collect();
        expected.sort_by(f64::total_cmp);
        let off = symmetric_eigen(&symmetric).eigenvalues - SVector::from_vec(expected);
        assert!(off.amax() <= bound * symmetric.norm(), "{off}");
        let off = svd(&a).singular_values - a.singular_values();
        assert!(off.amax() <= bound * a.norm(), "{off}");
    }
}

/// `L D Lᵀ = A`, and a solution whose residual is within 64 n roundings of the norms; none of a singular matrix.
#[test]
fn without_roots() {
    let mut random = Random(11);
    for kind in [0, 1, 3].into_iter().cycle().take(60) {
        let a = matrix::<f64, 7, 7>(kind, &mut random);
        let a = a.tr_mul(&a) + SMatrix::identity();
        let b = matrix::<f64, 7, 2>(0, &mut random);
        let factors = ldl(&a).expect("it is definite");
        assert!(factors.is_positive());
        let off = factors.l * SMatrix::from_diagonal(&factors.d) * factors.l.transpose() - a;
        assert!(off.norm() <= 64.0 * f64::EPSILON * a.norm(), "{kind}: {off}");
        let x = factors.solve(&b);
        let off = a * x - b;
        assert!(off.norm() <= 448.0 * f64::EPSILON * (a.norm() * x.norm() + b.norm()), "{off}");
        assert!(!ldl(&-a).expect("it is definite").is_positive());
        let ratio = factors.determinant() / a.determinant();
        assert!((ratio - 1.0).abs() < 1e-9, "{ratio}");
    }
    assert!(ldl(&SMatrix::<f64, 2, 2>::zeros()).is_none());
    assert!(ldl(&SMatrix::<f32, 2, 2>::from_element(1.0)).is_none());
    assert!(ldl(&SMatrix::<f64, 1, 1>::new(f64::NAN)).is_none());
}

/// Zero, infinite and NaN.
#[test]
fn at_the_edges() {
    let zero = SMatrix::<f64, 3, 3>::zeros();
    assert_eq!(symmetric_eigen(&zero).eigenvalues, SVector::<f64, 3>::zeros());
    assert_eq!(svd(&zero).singular_values, SVector::<f64, 3>::zeros());
    assert_eq!(svd(&zero).rank(0.0), 0);
    assert_eq!(svd(&zero).pseudo_inverse(0.0), zero);
    assert_eq!(zero.dsl_exp(), SMatrix::<f64, 3, 3>::identity());
    for special in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut a = SMatrix::<f64, 3, 3>::identity();
        a[(1, 1)] = special;
        assert!(symmetric_eigen(&a).eigenvalues.iter().all(|x| x.is_nan()));
        assert!(svd(&a).singular_values.iter().all(|x| x.is_nan()));
        assert!(a.dsl_exp().iter().all(|x| x.is_nan()));
    }
    // Whose squares overflow, or vanish.
    for scale in [1e300, 1e-300] {
        let a = SMatrix::<f64, 2, 2>::new(3.0, 0.0, 0.0, 4.0) * scale;
        assert_eq!(svd(&a).singular_values, SVector::<f64, 2>::new(4.0, 3.0) * scale);
        assert_eq!(symmetric_eigen(&a).eigenvalues, SVector::<f64, 2>::new(3.0, 4.0) * scale);
    }
}

/// Checks `exp`. Of a symmetric matrix it has the eigenvalues' exponentials, within 64 n roundings times the norms. The
/// exponential of the negative is the inverse; of a nilpotent matrix it is a polynomial.
#[test]
fn exponentials() {
    let mut random = Random(5);
    for (index, kind) in [0, 2, 3].into_iter().cycle().take(60).enumerate() {
        let scale = [0.01, 1.0, 12.0][index / 3 % 3];
        let a = matrix::<f64, 4, 4>(kind, &mut random) * scale;
        let symmetric = a + a.transpose();
        let eigen = symmetric.symmetric_eigen();
        let values = SMatrix::from_diagonal(&eigen.eigenvalues.map(f64::exp));
        let expected = eigen.eigenvectors * values * eigen.eigenvectors.transpose();
        let found = symmetric.dsl_exp();
        let bound = 256.0 * f64::EPSILON * (1.0 + symmetric.norm()) * expected.norm();
        assert!((found - expected).norm() <= bound, "{kind} {scale}: {found} {expected}");

        let b = matrix::<f32, 3, 3>(kind, &mut random);
        let product = b.dsl_exp() * (-b).dsl_exp() - SMatrix::identity();
        assert!(product.norm() <= 1e-4, "{product}");

        let mut shift = SMatrix::<f64, 3, 3>::zeros();
        (shift[(0, 1)], shift[(1, 2)], shift[(0, 2)]) = (a[(0, 0)], a[(1, 1)], a[(2, 2)]);
        let expected = SMatrix::identity() + shift + shift * shift * 0.5;
        let off = (shift.dsl_exp() - expected).norm();
        assert!(off <= 64.0 * f64::EPSILON * (1.0 + shift.norm()) * expected.norm(), "{off}");
    }
}
