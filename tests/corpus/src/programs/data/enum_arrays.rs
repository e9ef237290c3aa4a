//! Arrays of enums, and enums as indices.

use bessemer::prelude::*;

/// A direction.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Way {
    #[default]
    North,
    East,
    South,
    West,
}

/// Steps to the east and to the north for each direction.
const STEPS: [[i32; 2]; 4] = [[0, 1], [1, 0], [0, -1], [-1, 0]];

/// The end point of a path.
#[function]
pub fn walked(path: &[Way; 5]) -> [i32; 2] {
    let mut place = [0, 0];
    for way in path {
        let step = STEPS[*way as usize];
        place[0] += step[0];
        place[1] += step[1];
    }
    place
}
