//! `break 'label value` leaves a labelled block. In the C, the rest
//! is in the other branch; if a loop is left, a flag records it.

use bessemer::prelude::*;

/// The index of the first reading beyond a limit, or the number of readings.
#[function]
pub fn first_above(readings: &[f64; 6], limit: f64) -> usize {
    let at = 'found: {
        for (i, reading) in readings.iter().enumerate() {
            if *reading > limit {
                break 'found i;
            }
        }
        readings.len()
    };
    at
}

/// Heat level of a motor: each step requires less than the one before.
#[function]
pub fn level(temperature: f32, rise: f32) -> u8 {
    'level: {
        if temperature > 90.0 {
            break 'level 3;
        }
        let soon = temperature + 10.0 * rise;
        if soon > 90.0 {
            break 'level 2;
        }
        if soon > 70.0 { 1 } else { 0 }
    }
}

/// Arms the motor unless one of the conditions forbids it.
#[function]
pub fn arm(ready: bool, voltage: f32, armed: &mut bool, refusals: &mut u8) {
    'arm: {
        if !ready {
            *refusals += 1;
            break 'arm;
        }
        if voltage < 14.0 {
            break 'arm;
        }
        *armed = true;
    }
}
