//! `.chunks(n)` iterates over groups of elements, of which the last may be shorter; `.take_while(…)` ends a loop
//! early.

use bessemer::prelude::*;

/// The largest sum of a group of three; the last group may be shorter.
#[function]
pub fn busiest(values: &[f64; 8]) -> f64 {
    let mut most = f64::MIN;
    for part in values.chunks(3) {
        most = most.max(part.iter().sum::<f64>());
    }
    most
}

/// The index of the group at which the sum of all bytes so far exceeds a limit.
#[function]
pub fn passed(bytes: &[u8; 10], used: usize, limit: u32) -> Option<usize> {
    let used = used.min(bytes.len());
    let mut sum = 0;
    for (block, part) in bytes[..used].chunks(4).enumerate() {
        for byte in part {
            sum += u32::from(*byte);
        }
        if sum > limit {
            return Some(block);
        }
    }
    None
}

/// The number at the beginning of a text; `None` if it is too large.
#[function]
pub fn leading_number(text: &[u8; 6]) -> Option<u16> {
    let mut number: u16 = 0;
    for &digit in text.iter().take_while(|letter| letter.is_ascii_digit()) {
        number = number.checked_mul(10)?.checked_add(u16::from(digit - b'0'))?;
    }
    Some(number)
}

/// The sum of the readings up to the first that is not above a limit, without those above 100.
#[function]
pub fn first_run(values: &[i32; 8], limit: i32) -> i32 {
    values.iter().take_while(|&&value| value > limit).filter(|&&value| value <= 100).sum()
}
