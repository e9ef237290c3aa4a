//! A pattern that names a matched number by mutable reference: the number itself changes, not a copy.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Gear {
    #[default]
    Neutral,
    First,
    Second,
}

#[function]
pub fn of_a_number(mut level: u32) -> u32 {
    let rule = match &mut level {
        3 => 7,
        n if *n > 20 => {
            *n = 5;
            1
        }
        n @ 10..20 => {
            *n -= 6;
            2
        }
        n => {
            *n += 1;
            4
        }
    };
    level * 10 + rule
}

#[function]
pub fn of_an_argument(level: &mut i8) -> i8 {
    match level {
        -3 => 7,
        n => {
            *n = n.wrapping_mul(5);
            1
        }
    }
}

#[function]
pub fn of_an_element(levels: &mut [u8; 3], mut at: usize) -> u8 {
    match &mut levels[at] {
        3 => 7,
        n => {
            at = 0;
            *n ^= 5;
            at as u8
        }
    }
}

#[function]
pub fn of_an_enum(gear: &mut Gear, up: bool) -> bool {
    let mut fast = up;
    match &mut *gear {
        Gear::Second => {}
        other if up => *other = Gear::Second,
        other => *other = Gear::Neutral,
    }
    match &mut fast {
        true => {}
        other => *other = *gear == Gear::Neutral,
    }
    fast
}
