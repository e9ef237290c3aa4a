//! Enums whose numbers are not their indices: a condition on the number limits the possible variants.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(i8)]
pub enum Trim {
    Down = -1,
    #[default]
    Level = 0,
    Up = 1,
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    #[default]
    A = 10,
    B = 20,
    C = 30,
}

#[function]
pub fn at_most_level(trim: Trim, table: &[i32; 1]) -> i32 {
    if trim as i8 <= 0 {
        return table[(trim as i8 + 1) as usize];
    }
    0
}

#[function]
pub fn divided(trim: Trim, value: i32) -> i32 {
    if trim as i8 <= 0 {
        return value % (trim as i32 * 5);
    }
    value
}

#[function]
pub fn asserted(kind: Kind) -> u8 {
    if kind as u32 >= 10 {
        assert!(kind == Kind::C);
    }
    1
}

#[function]
pub fn less(kind: Kind) -> u8 {
    match kind as u8 {
        10 => kind as u8 - 25,
        20 => 25 - kind as u8,
        _ => 0,
    }
}

/// Trims that are indexed by a variant's number without a check.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trims {
    pub seen: [u32; 3],
}

#[component]
impl Trims {
    #[entry(infallible)]
    pub fn count(&mut self, trim: Trim, kind: Kind) -> u32 {
        let at = (trim as i8 + 1) as usize;
        self.seen[at] = self.seen[at].saturating_add(kind as u32 / 10);
        if trim != Trim::Up {
            return self.seen[(trim as i8 + 2) as usize];
        }
        self.seen[kind as usize / 10 - 1]
    }
}
