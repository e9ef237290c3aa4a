//! Comparisons with a literal variant: its payload is evaluated in its position, whether or not it is compared.

use bessemer::prelude::*;

/// State of a valve.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Duty {
    #[default]
    Idle,
    Open(u8),
    Hold {
        from: i16,
        share: f32,
    },
}

/// Payloads that may fault although there is nothing to compare them with.
#[function]
pub fn numbers(count: Option<u8>, n: u8, at: usize, table: &[u8; 4]) -> [bool; 5] {
    let known = count == Some(3);
    let other = Some(n) != count;
    let more = count == Some(n + 1);
    let listed = Some(table[at]) == count;
    [known, other, more, listed, count == None]
}

/// A payload that a conversion computes, with nothing to compare it with.
#[function]
pub fn widened(wide: Option<u16>, n: u8) -> bool {
    wide == Some(u16::from(n))
}

/// Variants with several payloads, and nested variants.
#[function]
pub fn duties(last: Option<Duty>, duty: Duty, from: i16) -> [bool; 6] {
    [
        duty == Duty::Open(7),
        Duty::Idle == duty,
        duty == Duty::Hold { from, share: 0.5 },
        last == Some(duty),
        last != Some(Duty::Open(1)),
        last == None,
    ]
}

/// Increments the number; `None` if it was above nine.
#[function]
pub fn advanced(n: &mut u8) -> Option<u8> {
    let before = *n;
    *n = n.wrapping_add(3);
    (before > 9).then_some(before)
}

/// One side of the comparison changes a variable that the other reads.
#[function]
pub fn in_turn(n: u8) -> (bool, bool, u8) {
    let mut n = n;
    let first = Some(n) == advanced(&mut n);
    let second = advanced(&mut n) == Some(n.wrapping_sub(3));
    (first, second, n)
}
