//! Closures of methods of `Option` and `Result`: with side effects, with faults, nested, and in unusual positions.

#![allow(dropping_copy_types)]

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pair {
    pub left: Option<i16>,
    pub right: Option<i16>,
}

/// A closure that changes captured variables.
#[function]
pub fn counted(values: [Option<u8>; 4]) -> (u32, u32) {
    let mut count = 0;
    let mut sum = 0;
    for value in values {
        let add = value.map(|value| {
            count += 1;
            u32::from(value)
        });
        sum += add.unwrap_or(0);
    }
    (count, sum)
}

/// `map_or` evaluates its first argument in any case, so this may fault even if the argument is not needed.
#[function]
pub fn eager(value: Option<u8>, part: u8, whole: u8) -> u8 {
    value.map_or(part / whole, |value| value / 2)
}

/// `unwrap_or_else` calls its closure only if needed.
#[function]
pub fn lazy(value: Option<u8>, part: u8, whole: u8) -> u8 {
    value.unwrap_or_else(|| part / whole)
}

/// Nested closures with parameters of the same name.
#[function]
pub fn nested(pair: &Pair) -> Option<i16> {
    pair.left.and_then(|x| pair.right.map(|y| x.wrapping_sub(y))).or_else(|| {
        pair.left.or_else(|| pair.right.map(|x| x.wrapping_neg()))
    })
}

/// A closure may change the tested variable.
#[function]
pub fn tested(mut value: Option<i16>) -> (bool, Option<i16>) {
    let asked = value;
    let yes = asked.is_some_and(|x| {
        value = None;
        x > 0
    });
    (yes, value)
}

/// A filter's closure may change the filtered variable.
#[function]
pub fn filtered(mut value: Option<i16>, limit: i16) -> (Option<i16>, Option<i16>) {
    let asked = &mut value;
    let before = asked.filter(|x| {
        *asked = None;
        *x > limit
    });
    (before, value)
}

/// A condition that can fault, evaluated only if there is content.
#[function]
pub fn fits(value: Option<u8>, room: [u8; 3]) -> bool {
    value.is_some_and(|at| room[usize::from(at)] > 0) && value != Some(1)
}

/// Functions instead of closures, and a named closure.
#[function]
pub fn named(value: Option<i8>, gain: f32) -> f32 {
    let scaled = |x: f32| gain * x;
    value.map(f32::from).map(scaled).map(f32::abs).unwrap_or_default()
}

/// A constructor instead of a closure.
#[function]
pub fn wrapped(value: Option<i8>) -> Option<Option<i8>> {
    value.filter(|x| *x != 0).map(Some)
}

/// Flattens the result.
#[function]
pub fn unwrapped(value: Option<Option<i8>>) -> Option<i8> {
    value.flatten()
}

/// References to the content.
#[function]
pub fn larger(pair: &Pair) -> Option<i16> {
    let left = pair.left.as_ref();
    left.map(|x| pair.right.as_ref().map_or(*x, |y| (*x).max(*y)))
}

/// A result without a value, whose success counts.
#[function]
pub fn checked(value: Result<(), u8>, limit: u8) -> Result<u8, u8> {
    value.map(|()| limit).or_else(|error| if error < limit { Ok(error) } else { Err(error) })
}

/// Tests of results.
#[function]
pub fn asked(value: Result<u8, i8>) -> (bool, bool, u8) {
    let part = value.map_or_else(|error| error.unsigned_abs(), |value| value.wrapping_mul(2));
    (value.is_ok_and(|x| x > 3), value.is_err_and(|error| error < 0), part)
}

/// Calls as statements, for their side effects.
#[function]
pub fn effects(value: Option<u8>, total: &mut u8) {
    value.map(|x| *total = total.wrapping_add(x));
    let _ = value.map(|x| x.wrapping_add(1));
}

/// Calls in `match`, `if let`, an index and an assignment.
#[function]
pub fn places(value: Option<u8>, table: &mut [u8; 3]) -> u8 {
    table[value.map_or(0, |x| usize::from(x % 3))] = value.map_or(9, |x| x / 2);
    if let Some(x) = value.filter(|x| *x > 3) {
        return x;
    }
    match value.map(|x| x + 1) {
        Some(2) => table[0],
        Some(x) if value.is_none_or(|y| y > 1) => x,
        _ => table[1],
    }
}

/// An array's `map` inside an option's, and the reverse.
#[function]
pub fn arrays(values: [Option<i16>; 3], offset: Option<i16>) -> ([i16; 3], Option<[i16; 3]>) {
    let shift = offset.map_or(0, |x| x / 2);
    let plain = values.map(|value| value.map_or(shift, |x| x.wrapping_add(shift)));
    (plain, offset.map(|by| plain.map(|x| x.wrapping_mul(by))))
}

/// `inspect` with side effects, and discarded content.
#[function]
pub fn shown(value: Option<u8>, error: i8, seen: &mut [i16; 3]) -> (Option<u8>, Option<()>, Result<(), i8>) {
    let kept = value.inspect(|x| seen[0] = i16::from(*x));
    let result = value.ok_or(error).inspect(|x| seen[1] ^= i16::from(*x));
    let result = result.inspect_err(|error| seen[2] ^= i16::from(*error));
    drop(kept);
    (kept.filter(|x| *x > 4), value.map(drop), result.map(drop))
}
