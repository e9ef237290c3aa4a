//! Discrete models of continuous ones.

use bessemer::prelude::*;

use crate::Symmetric;

/// Number of terms of the series over the shortest part of the period.
const TERMS: usize = 14;

/// Returns the transition e^(A t) over a period t, and the process noise ∫ e^(A s) Q e^(Aᵀ s) ds that Q adds meanwhile.
///
/// The period is halved `halvings` times until |A| t is below 0.5; a series of fourteen terms is then exact to the rounding. Each
/// doubling squares the transition, and adds the noise of the first half, carried through the second.
#[function]
pub fn discretized<const N: usize>(
    system: &SMatrix<f64, N, N>,
    noise: &Symmetric<f64, N>,
    period: f64,
    halvings: usize,
) -> (SMatrix<f64, N, N>, Symmetric<f64, N>) {
    let mut part = period;
    for _ in 0..halvings {
        part *= 0.5;
    }

    // e^(A s) is the sum of the terms (A s)ᵏ / k!, and the noise of Tₖ = (A Tₖ₋₁ + Tₖ₋₁ Aᵀ) s / (k + 1).
    let mut transition = SMatrix::<f64, N, N>::identity();
    let mut power = SMatrix::<f64, N, N>::identity();
    let mut added = *noise.matrix() * part;
    let mut term = added;
    for k in 1..TERMS {
        power = system * power * (part / k as f64);
        transition += power;
        let half = system * term;
        term = (half + half.transpose()) * (part / (k + 1) as f64);
        added += term;
    }
    let mut total = Symmetric::of_lower(&added);
    for _ in 0..halvings {
        let mut carried = total;
        carried.congruence(&transition);
        total.add(&carried);
        transition = transition * transition;
    }
    (transition, total)
}
