//! `iter_mut` changes the elements in place.

use bessemer::prelude::*;

/// Limits every command to `most`.
#[function]
pub fn limit(commands: &mut [f64; 4], most: f64) {
    for command in commands.iter_mut() {
        if command.abs() > most {
            *command = most.copysign(*command);
        }
    }
}
