//! A `Text` is an array of bytes with a bounded length.

use bessemer::prelude::*;

/// A channel of the log.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct LogChannel {
    pub name: Text<8>,
    pub unit: Text<4>,
}

impl Default for LogChannel {
    fn default() -> Self {
        LogChannel { name: Text::of(b"height"), unit: Text::of(b"m") }
    }
}

#[component]
impl LogChannel {
    /// Changes the name; a fault if it is too long.
    #[entry]
    pub fn rename(&mut self, name: &Text<12>) {
        self.name.clear();
        let letters = name.bytes();
        self.name.append(&letters[..name.len()]);
    }

    /// Returns the name with a number, such as `height2`.
    #[entry]
    pub fn number(&mut self, number: u8) -> Text<8> {
        self.name.push(b'0' + number % 10);
        self.name
    }

    /// Returns true if the channel has its initial unit.
    #[entry]
    pub fn is_length(&mut self) -> bool {
        self.unit.is(b"m") || self.unit == Text::of(b"cm")
    }
}
