//! Writes to parts of matrices in place: a constant position, or one bounded by a loop, needs no check.

use bessemer::prelude::*;

/// A covariance whose blocks are set individually.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Blocks {
    p: SMatrix<f64, 6, 6>,
}

#[component]
impl Blocks {
    /// Sets the blocks of the bias.
    #[entry(infallible)]
    pub fn reset(&mut self, cross: &Matrix3<f64>, noise: f64) {
        self.p.fixed_view_mut::<3, 3>(0, 3).copy_from(cross);
        self.p.fixed_view_mut::<3, 3>(3, 3).fill_diagonal(noise);
        self.p.fixed_view_mut::<2, 2>(3, 4).fill(0.5);
    }

    /// Swaps two states.
    #[entry(infallible)]
    pub fn exchange(&mut self) {
        self.p.swap_rows(0, 1);
        self.p.swap_columns(0, 1);
    }

    /// Adds to some columns and clears others.
    #[entry(infallible)]
    pub fn update(&mut self, gain: &SVector<f64, 6>, row: &SMatrix<f64, 1, 6>) {
        for i in 0..3 {
            self.p.column_mut(i).copy_from(gain);
        }
        self.p.column_mut(4).copy_from(&(gain * 2.0));
        self.p.row_mut(5).copy_from(row);
        self.p.column_mut(3).fill(0.0);
    }

    /// Writes a part at a computed position, which is checked.
    #[entry]
    pub fn set(&mut self, at: usize, part: &Vector3<f64>) {
        self.p.fixed_view_mut::<3, 1>(at, at).copy_from(part);
    }
}
