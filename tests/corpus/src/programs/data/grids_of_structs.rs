//! Two-dimensional arrays of structs.

use bessemer::prelude::*;

/// A square of a map.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Square {
    pub height: f32,
    pub seen: bool,
}

/// The highest known square, or 0.
#[function]
pub fn highest(map: &[[Square; 3]; 2]) -> f32 {
    let mut most = 0.0_f32;
    for row in map {
        for cell in row {
            if cell.seen {
                most = most.max(cell.height);
            }
        }
    }
    most
}
