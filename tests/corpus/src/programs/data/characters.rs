//! Characters; in the C they are code points.

use bessemer::prelude::*;

/// The keys of a telephone.
const KEYS: [[char; 3]; 4] =
    [['1', '2', '3'], ['4', '5', '6'], ['7', '8', '9'], ['*', '0', '#']];

/// The key in a row and a column, if there is one.
#[function]
pub fn key(row: usize, column: usize) -> Option<char> {
    KEYS.get(row)?.get(column).copied()
}

/// Class of a character.
#[function]
pub fn class(code: u32) -> u8 {
    let Some(letter) = char::from_u32(code) else { return 0 };
    match letter {
        '0'..='9' => 1,
        'a'..='z' | 'A'..='Z' | '_' => 2,
        ' ' | '\t' | '\n' => 3,
        'ä' | '°' => 4,
        other if other > '\u{7f}' => 5,
        _ => 6,
    }
}

/// The value of a number in a base; it ends at the first byte that is not a digit.
#[function]
pub fn value(bytes: &[u8; 4], base: u8) -> u32 {
    let base = u32::from(base & 15) + 2;
    let mut value = 0;
    for byte in bytes {
        let Some(digit) = char::from(*byte).to_digit(base) else { break };
        value = value * base + digit;
    }
    value
}

/// Returns true for a hexadecimal digit.
#[function]
pub fn is_sixteenth(byte: u8) -> bool {
    char::from(byte).is_digit(16)
}

/// The character of a digit's value.
#[function]
pub fn digit(value: u32) -> u8 {
    let shown = char::from_digit(value, 36).unwrap_or('?');
    if shown.is_ascii_lowercase() { shown.to_ascii_uppercase() as u8 } else { shown as u8 }
}

/// The last letter received, and how often it was received in a row.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Listener {
    /// The last letter received.
    pub last: Option<char>,
    /// Number of occurrences.
    pub count: u8,
}

#[component]
impl Listener {
    /// Takes one byte.
    #[entry(infallible)]
    pub fn hear(&mut self, byte: u8) -> u32 {
        let letter = byte as char;
        if !letter.is_ascii_alphanumeric() || letter == 'x' {
            return 0;
        }
        if self.last.replace(letter) == Some(letter) {
            self.count = self.count.saturating_add(1);
        } else {
            self.count = 1;
        }
        letter as u32 + u32::from(letter.is_ascii_hexdigit())
    }
}
