//! Matrices of blocks compute the bits of dense ones.

use bessemer::prelude::*;
use bessemer_estimation::{BlockSparse, Status, Symmetric, pattern, stored};

const STEP: u64 = pattern(&["xx..", ".xxx", "..xx", "...x"]);
const ROWS: u64 = pattern(&["x.x.", ".x.."]);
const BOTH: u64 = pattern(&["xxxx", ".xxx"]);
const SQUARE: u64 = pattern(&["xxxx", ".xxx", "..xx", "...x"]);

type Step = BlockSparse<f64, 12, 12, 3, { stored(STEP) }, STEP>;
type Measured = BlockSparse<f64, 6, 12, 3, { stored(ROWS) }, ROWS>;

/// A matrix of numbers without a pattern.
fn dense<const R: usize, const C: usize>(seed: u64) -> SMatrix<f64, R, C> {
    let mut state = seed;
    SMatrix::from_fn(|_, _| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    })
}

fn bits<const R: usize, const C: usize>(matrix: &SMatrix<f64, R, C>) -> Vec<u64> {
    matrix.iter().map(|it| it.to_bits()).collect()
}

#[test]
fn products_and_sums_are_dense_ones() {
    let (step, measured) = (Step::of_matrix(&dense(1)), Measured::of_matrix(&dense(2)));
    let (a, h) = (step.matrix(), measured.matrix());
    assert_eq!(a.iter().filter(|it| **it != 0.0).count(), 9 * stored(STEP));

    let right = dense::<12, 5>(3);
    assert_eq!(bits(&step.times(&right)), bits(&(a * right)));
    assert_eq!(bits(&measured.times(&right)), bits(&(h * right)));
    let right = dense::<6, 2>(4);
    assert_eq!(bits(&measured.transposed_times(&right)), bits(&(h.transpose() * right)));

    let product: BlockSparse<f64, 6, 12, 3, { stored(BOTH) }, BOTH> = measured.product(&step);
    assert_eq!(bits(&product.matrix()), bits(&(h * a)));
    let square: BlockSparse<f64, 12, 12, 3, { stored(SQUARE) }, SQUARE> = step.product(&step);
    assert_eq!(bits(&square.matrix()), bits(&(a * a)));
    let sum: BlockSparse<f64, 6, 12, 3, { stored(BOTH) }, BOTH> = measured.sum(&product);
    assert_eq!(bits(&sum.matrix()), bits(&(h + h * a)));

    let p = Symmetric::of_lower(&dense::<12, 12>(5));
    let mut expected = p;
    expected.congruence(&a);
    assert_eq!(bits(step.congruence(&p).matrix()), bits(expected.matrix()));
    let corner = measured.congruence(&p);
    assert!((corner.matrix() - h * p.matrix() * h.transpose()).amax() < 1e-13);
    assert_eq!(*corner.matrix(), corner.matrix().transpose());
}

#[test]
fn a_correction_is_the_joint_one() {
    let measured = Measured::of_matrix(&dense(9));
    let root = dense::<12, 12>(10);
    let (innovation, noise) = (dense::<6, 1>(11), Symmetric::diagonal(&SVector::from([0.5; 6])));
    let mut sparse = Symmetric::of_lower(&(root * root.transpose()));
    let mut joint = sparse;
    let (mut state, mut expected) = (SVector::zeros(), SVector::zeros());
    let report = sparse.correct_sparse(&mut state, &measured, &innovation, &noise, 1e9);
    let jacobian = measured.matrix();
    assert_eq!(joint.correct_jointly(&mut expected, &jacobian, &innovation, &noise, 1e9), report);
    assert_eq!(report.status, Status::Corrected);
    assert_eq!(bits(&state), bits(&expected));
    assert_eq!(bits(sparse.matrix()), bits(joint.matrix()));
}

#[test]
fn a_block_has_its_place() {
    let mut measured = Measured::zeros();
    let block = dense::<3, 3>(6);
    measured.set::<1, 1>(&block);
    assert_eq!(measured.matrix().fixed_view::<3, 3>(3, 3).into_owned(), block);
    assert_eq!(measured.block::<1, 1>(), block);
    assert_eq!(measured.matrix().iter().filter(|it| **it != 0.0).count(), 9);
}

/// A pattern of 64 blocks uses each bit.
#[test]
fn a_full_pattern_is_dense() {
    let full = BlockSparse::<f64, 8, 8, 1, 64, { u64::MAX }>::of_matrix(&dense(7));
    let vector = dense::<8, 1>(8);
    assert_eq!(bits(&full.times(&vector)), bits(&(full.matrix() * vector)));
}

#[test]
#[should_panic(expected = "the same length")]
fn rows_of_different_lengths_are_refused() {
    pattern(&["x.", "x"]);
}

#[test]
#[should_panic(expected = "at most 64 blocks")]
fn a_pattern_beyond_64_blocks_is_refused() {
    pattern(&["xxxxxxxxx"; 8]);
}
