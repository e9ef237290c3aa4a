//! More adapters: `skip_while`, `map_while` and `take_while` end or begin a chain, `scan` carries a state; two arrays
//! are combined, one of them reversed.

use bessemer::prelude::*;

/// The energy of the samples from the first one beyond a threshold.
#[function]
pub fn energy(samples: &[f64; 8], threshold: f64) -> f64 {
    samples.iter().skip_while(|x| x.abs() < threshold).map(|x| x * x).sum()
}

/// The value of the digits at the beginning of a text, and their number.
#[function]
pub fn leading_number(text: &[u8; 6]) -> u32 {
    text.iter()
        .map_while(|byte| if byte.is_ascii_digit() { Some(byte - b'0') } else { None })
        .fold(0, |value, digit| 10 * value + u32::from(digit))
}

/// The highest level of a tank with these inflows and outflows; the iteration ends when it is empty.
#[function]
pub fn highest(flows: &[i32; 6], start: i32) -> Option<i32> {
    flows
        .iter()
        .scan(start, |level, flow| {
            *level += flow;
            if *level >= 0 { Some(*level) } else { None }
        })
        .max()
}

/// A filter with symmetric coefficients.
#[function]
pub fn folded(samples: &[f32; 4], coefficients: &[f32; 4]) -> f32 {
    samples.iter().zip(coefficients.iter().rev()).map(|(x, c)| x * c).sum()
}

/// The second valid reading, and the index of the last zero.
#[function]
pub fn places(readings: &[u16; 6]) -> (Option<u16>, Option<usize>) {
    let second = readings.iter().copied().filter(|x| *x < 4096).nth(1);
    (second, readings.iter().rposition(|x| *x == 0))
}
