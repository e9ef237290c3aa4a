//! A `loop` may have a value of any type, also as a branch of an `if` or a `match`.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Found {
    #[default]
    Nothing,
    At(usize),
    Pair([u8; 2]),
}

#[function]
pub fn of_arrays(x: [u8; 2], limit: u8) -> [u8; 2] {
    let mut passes = 0;
    let mut sum = loop {
        if passes >= 4 {
            break x;
        }
        passes += 1;
        if passes > limit {
            break [x[1], passes];
        }
    };
    sum = [sum[1], sum[0].wrapping_add(2)];
    sum
}

#[function]
pub fn of_enums(values: [u8; 5], wanted: u8) -> Found {
    let mut at = 0;
    let mut found = loop {
        if at >= 5 {
            break Found::Nothing;
        }
        if values[at] == wanted {
            break Found::At(at);
        }
        at += 1;
    };
    if found == Found::Nothing {
        found = Found::Pair([values[0], wanted]);
    }
    found
}

#[function]
pub fn in_branches(x: u8, up: bool) -> (u8, bool) {
    let mut n = 0;
    let pair = if up {
        n = 1;
        #[bound(300)]
        let found = loop {
            if n > x {
                break (n, up);
            }
            n *= 2;
        };
        found
    } else {
        match x {
            0 => (x, true),
            _ => loop {
                if n >= x {
                    break (n, false);
                }
                n += 1;
            },
        }
    };
    (pair.0 ^ n, pair.1)
}
