//! `let` destructures structs, arrays and tuple expressions.

use bessemer::prelude::*;

/// A line `a·x + b·y = c`.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Line {
    pub a: f64,
    pub b: f64,
    pub c: f64,
}

/// Signed distance of a point from a line, times the length of its normal.
#[function]
pub fn side(line: &Line, point: [f64; 2]) -> f64 {
    let Line { a, b, c: offset } = *line;
    let [x, y] = point;
    let (along, across) = (a * x, b * y);
    along + across - offset
}
