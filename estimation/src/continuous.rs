//! Discrete models of continuous ones.

use bessemer::prelude::*;

use crate::Symmetric;

/// Number of terms of the series over the shortest part of the period.
const TERMS: usize = 14;

/// Returns the transition e^(A t) over a period t, and the process noise ∫ e^(A s) Q e^(Aᵀ s) ds that Q adds meanwhile.
///
/// The period is halved `halvings` times until |A| t is below 0.5; a series of fourteen terms is then exact to the
/// rounding. Each doubling squares the transition, and adds the noise of the first half, carried through the second.
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

/// Returns e^A. A is halved `halvings` times until its norm is below 0.5; a series of fourteen terms is then exact to
/// the rounding, and each doubling squares it.
#[function]
pub fn exponential<T: Real, const N: usize>(
    matrix: &SMatrix<T, N, N>,
    halvings: usize,
) -> SMatrix<T, N, N> {
    let mut part = T::ONE;
    for _ in 0..halvings {
        part *= real(0.5);
    }
    let mut sum = SMatrix::<T, N, N>::identity();
    let mut power = SMatrix::<T, N, N>::identity();
    for k in 1..TERMS {
        power = matrix * power * (part / real(k as f64));
        sum += power;
    }
    for _ in 0..halvings {
        sum = sum * sum;
    }
    sum
}

/// Returns the state after a period, by one step of the classical Runge-Kutta method of fourth order; `law` gives its
/// rate.
#[function]
pub fn runge_kutta<T: Real, const N: usize>(
    state: &SVector<T, N>,
    period: T,
    law: impl Fn(&SVector<T, N>) -> SVector<T, N>,
) -> SVector<T, N> {
    let half = period * real(0.5);
    let one = law(state);
    let two = law(&(state + one * half));
    let three = law(&(state + two * half));
    let four = law(&(state + three * period));
    state + (one + (two + three) * real::<T>(2.0) + four) * (period / real(6.0))
}

/// Returns the state of [`runge_kutta`] and its Jacobian by the state before; `law` gives the rate and the rate's
/// Jacobian. The Jacobian belongs to the step, not to the continuous flow: a covariance follows what the filter
/// computes.
#[function]
pub fn runge_kutta_jacobian<T: Real, const N: usize>(
    state: &SVector<T, N>,
    period: T,
    law: impl Fn(&SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>),
) -> (SVector<T, N>, SMatrix<T, N, N>) {
    let half = period * real(0.5);
    let sixth = period / real(6.0);
    let identity = SMatrix::<T, N, N>::identity();
    let (one, slope_one) = law(state);
    let (two, by_two) = law(&(state + one * half));
    let slope_two = by_two * (identity + slope_one * half);
    let (three, by_three) = law(&(state + two * half));
    let slope_three = by_three * (identity + slope_two * half);
    let (four, by_four) = law(&(state + three * period));
    let slope_four = by_four * (identity + slope_three * period);
    let next = state + (one + (two + three) * real::<T>(2.0) + four) * sixth;
    let jacobian =
        identity + (slope_one + (slope_two + slope_three) * real::<T>(2.0) + slope_four) * sixth;
    (next, jacobian)
}
