//! Nested conditions, and an `if` without `else`.

use bessemer::prelude::*;

/// The current that a charger may supply, mA.
#[function]
pub fn current(voltage: u16, temperature: i8, fast: bool) -> u16 {
    let mut current = 500;
    if temperature > 0 {
        if temperature < 45 {
            if fast {
                current = 2000;
            } else {
                current = 1000;
            }
        }
    } else {
        current = 0;
    }
    if voltage > 4200 {
        current /= 4;
    }
    current
}
