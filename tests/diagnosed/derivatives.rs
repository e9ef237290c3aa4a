//! Functions without a derivative, each at its line.
#![no_std]
use bessemer::prelude::*;

/// Two numbers.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pair {
    pub first: f64,
    pub count: u32,
}

/// Writes through a reference.
#[function]
pub fn moved(x: &mut f64, by: f64) -> f64 {
    *x += by;
    *x
}

#[function(derivative(moved, by))]
pub fn moved_slope(x: &mut f64, by: f64) -> (f64, f64) {
    todo!()
}

#[function]
pub fn scaled(x: f64, times: u32) -> f64 {
    x * times as f64
}

/// By a whole number.
#[function(derivative(scaled, times))]
pub fn scaled_by_count(x: f64, times: u32) -> (f64, f64) {
    todo!()
}

/// By a parameter that is missing.
#[function(derivative(scaled, factor))]
pub fn scaled_by_another(x: f64, times: u32) -> (f64, f64) {
    todo!()
}

/// By a struct with a whole number.
#[function]
pub fn of_pair(pair: &Pair) -> f64 {
    pair.first
}

#[function(gradient(of_pair, pair))]
pub fn pair_gradient(pair: &Pair) -> (f64, Pair) {
    todo!()
}

#[function]
pub fn advanced(state: &Vector3<f64>, push: f64) -> Vector3<f64> {
    Vector3::new(state.x + state.y, state.y + push, state.z)
}

/// A covariance of another size.
#[function(derivative(advanced, state))]
pub fn predicted(state: &Vector3<f64>, push: f64, covariance: &mut Matrix2<f64>) -> Vector3<f64> {
    todo!()
}

/// A Jacobian of another size.
#[function(derivative(advanced, state))]
pub fn advanced_jacobian(state: &Vector3<f64>, push: f64) -> (Vector3<f64>, Matrix2<f64>) {
    todo!()
}

/// A selection out of range.
#[function]
pub fn fourth(state: &Vector3<f64>) -> f64 {
    let rows = state.fixed_rows::<2>(2);
    rows[0] * rows[1]
}

#[function(derivative(fourth, state))]
pub fn fourth_jacobian(state: &Vector3<f64>) -> (f64, RowVector3<f64>) {
    todo!()
}

/// A function that is no model's.
pub fn plain(x: f64) -> f64 {
    x
}

#[function(derivative(plain, x))]
pub fn plain_slope(x: f64) -> (f64, f64) {
    todo!()
}
