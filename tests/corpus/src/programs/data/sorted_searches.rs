//! `partition_point` and `binary_search` search a sorted slice; among
//! equal elements `binary_search` finds the first, in the simulation, too.

use bessemer::prelude::*;

/// A point of a curve.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    pub code: u16,
    pub value: f64,
}

/// Number of steps below a number.
#[function]
pub fn below(steps: &[f64; 6], x: f64) -> usize {
    steps.partition_point(|step| *step < x)
}

/// The index of a code, or where it could be inserted.
#[function]
pub fn place(codes: &[u8; 7], code: u8) -> Result<usize, usize> {
    codes.binary_search(&code)
}

/// Value of a code in a list of points.
#[function]
pub fn value(points: &List<Point, 5>, code: u16) -> Option<f64> {
    let at = points.binary_search_by_key(&code, |point| point.code).ok()?;
    Some(points[at].value)
}

/// The index of the first float not below a number.
#[function]
pub fn nearest(sorted: &[f32; 5], x: f32) -> usize {
    match sorted.binary_search_by(|value| value.total_cmp(&x)) {
        Ok(at) => at,
        Err(0) => 0,
        Err(at) => at - 1,
    }
}
