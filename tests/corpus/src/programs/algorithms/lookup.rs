//! Tables with one and two inputs: linear between the breakpoints, constant outside.

use bessemer::prelude::*;

/// Breakpoints of the rows: speeds.
const SPEEDS: [f64; 5] = [0.0, 10.0, 20.0, 40.0, 80.0];
/// Breakpoints of the columns: loads.
const LOADS: [f64; 4] = [0.0, 0.25, 0.5, 1.0];
/// Ignition advance for each speed and load, °.
const ADVANCE: [[f64; 4]; 5] = [
    [5.0, 5.0, 4.0, 2.0],
    [12.0, 11.0, 9.0, 6.0],
    [18.0, 17.0, 14.0, 10.0],
    [26.0, 24.0, 20.0, 15.0],
    [30.0, 28.0, 25.0, 20.0],
];

/// A position between two breakpoints of an axis.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Between {
    pub below: usize,
    /// Fraction of the distance: 0 at the lower breakpoint, 1 at the upper one.
    pub share: f64,
}

/// The position of a speed among the breakpoints.
#[function]
pub fn speed_place(speed: f64) -> Between {
    let mut below = 0;
    for i in 1..4 {
        if speed >= SPEEDS[i] {
            below = i;
        }
    }
    let share = (speed - SPEEDS[below]) / (SPEEDS[below + 1] - SPEEDS[below]);
    Between { below, share: share.clamp(0.0, 1.0) }
}

/// The position of a load among the breakpoints.
#[function]
pub fn load_place(load: f64) -> Between {
    let mut below = 0;
    for i in 1..3 {
        if load >= LOADS[i] {
            below = i;
        }
    }
    let share = (load - LOADS[below]) / (LOADS[below + 1] - LOADS[below]);
    Between { below, share: share.clamp(0.0, 1.0) }
}

/// The ignition advance at a speed and a load, °.
#[function]
pub fn advance(speed: f64, load: f64) -> f64 {
    let row = speed_place(speed);
    let column = load_place(load);
    let mut along = [0.0; 2];
    for (i, value) in along.iter_mut().enumerate() {
        let left = ADVANCE[row.below + i][column.below];
        let right = ADVANCE[row.below + i][column.below + 1];
        *value = left + (right - left) * column.share;
    }
    along[0] + (along[1] - along[0]) * row.share
}
