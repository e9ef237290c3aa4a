//! `try_for_each` calls a closure for each item until it fails.

use bessemer::prelude::*;

/// Reason of a failure.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// An item is too large: its value.
    Large(u8),
    /// There are too many items.
    Many,
}

/// Copies items up to the first that fails.
#[function]
pub fn copied(values: &[u8; 5], most: u8, out: &mut [u8; 4]) -> Result<(), Fault> {
    let mut count = 0_usize;
    values.iter().try_for_each(|value| {
        if *value > most {
            return Err(Fault::Large(*value));
        }
        *out.get_mut(count).ok_or(Fault::Many)? = value.wrapping_add(1);
        count += 1;
        Ok(())
    })
}

/// Checks that none of the last elements equals a value.
#[function]
pub fn without(values: &[u8], one: u8) -> Option<()> {
    values.iter().rev().take(4).try_for_each(|value| (*value != one).then_some(()))
}

/// Uses `?` on the result of `try_for_each`.
#[function]
pub fn both(values: &[u8; 5], most: u8) -> Result<u32, Fault> {
    let mut sum = 0_u32;
    values.iter().enumerate().try_for_each(|(i, value)| {
        sum = sum.wrapping_mul(31).wrapping_add(u32::from(*value) ^ i as u32);
        if *value > most { Err(Fault::Large(i as u8)) } else { Ok(()) }
    })?;
    without(values, most).ok_or(Fault::Many)?;
    Ok(sum)
}
