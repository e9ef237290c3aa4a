//! The larger and the smaller of elements, where a loop computes them: in conditions, in loops, and in the place that is read.

use bessemer::prelude::*;

pub type SixNumbers = SVector<f32, 6>;
pub type ThreeByThree = SMatrix<f64, 3, 3>;

/// Halves a vector until its elements are near those of another; returns the number of steps.
#[function]
pub fn approached(a: &SixNumbers, b: &SixNumbers) -> (u32, SixNumbers) {
    let mut a = *a;
    let mut steps = 0;
    #[bound(200)]
    while (a - b).amax() > 0.5 && steps < 90 {
        a = (a + b) / 2.0;
        steps += 1;
    }
    (steps, a)
}

/// Chooses by the extremes of several sums.
#[function]
pub fn class(a: &SixNumbers, b: &SixNumbers, limit: f32) -> u8 {
    if limit > 1.0 && (a + b).amax() > limit {
        1
    } else if (a - b).amin() > limit || a.abs().sup(b).inf(&(a * 2.0)).amax() < limit {
        2
    } else {
        assert!((a - b).amax() < 1e6);
        3
    }
}

/// Writes to the place that it reads.
#[function]
pub fn kept(a: &mut ThreeByThree, b: &ThreeByThree) -> f64 {
    *a = a.sup(&b.transpose()).inf(&(b * a[(1, 1)])).abs();
    *a = (*a + a.transpose()).inf(b);
    a[(0, 0)] = a.amax() + (*a - a.transpose()).amin();
    let worst = (*a - *b).amax();
    worst + a[(0, 0)]
}
