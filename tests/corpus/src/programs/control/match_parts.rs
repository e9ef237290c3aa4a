//! `match` destructures structs, tuples and variants, nested.

use bessemer::prelude::*;

/// A key and how long it has been pressed.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Key {
    pub code: u8,
    pub held: Option<u16>,
}

/// Action of a key.
#[function]
pub fn action(key: &Key, shift: bool) -> u8 {
    match (key, shift) {
        (Key { held: None, .. }, _) => 0,
        (Key { code: 65..=90, held: Some(0..=9) }, false) => 1,
        (Key { code, held: Some(time) }, true) if *time > 100 => *code,
        (Key { held: Some(_), .. }, _) => 2,
    }
}

/// A segment of a line.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stretch {
    Point(f32),
    Between((f32, f32)),
    Around { centre: f32, half: f32 },
}

/// Length of a segment.
#[function]
pub fn length(stretch: &Stretch) -> f32 {
    match *stretch {
        Stretch::Point(_) => 0.0,
        Stretch::Between((from, to)) => to - from,
        Stretch::Around { half, .. } => 2.0 * half,
    }
}
