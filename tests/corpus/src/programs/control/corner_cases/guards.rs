//! `match`: ranges, guards, names.

use bessemer::prelude::*;

/// Kind of a press of a button.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Press {
    /// No press.
    #[default]
    None,
    /// A press shorter than half a second.
    Short,
    /// A longer press.
    Long,
    /// Two presses in a row.
    Double,
}

/// Classifies temperatures into levels.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Level {
    /// Number of occurrences of each level.
    pub count: [u32; 4],
}

/// Temperature above which the level is hot, °C.
const HOT: i32 = 80;

#[component]
impl Level {
    /// The level of a temperature.
    #[entry]
    pub fn run(&mut self, celsius: i32) -> i32 {
        let level = match celsius {
            ..=0 => 0,
            1..=4 | 7 => 1,
            // What the table has no word for.
            5..HOT => 2,
            HOT.. => 3,
        };
        self.count[level as usize] += 1;
        level
    }
}

/// Arms with guards and names for the matched value.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Guarded {
    /// The last large value.
    pub last: u8,
}

#[component]
impl Guarded {
    /// Selects the first arm that matches.
    #[entry]
    pub fn run(&mut self, value: u8, limit: u8, armed: bool) -> i32 {
        match value {
            0 => 0,
            n if n > limit && armed => {
                self.last = n;
                n as i32
            }
            n @ 1..=9 if 100 / limit > n => 1,
            mut n @ (10..=19 | 30..=39) => {
                n += limit;
                (n as i32) * 2
            }
            _ if armed => -1,
            other => -(other as i32),
        }
    }
}

/// Short lists of patterns with a name for the value.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pressed {
    /// Last press.
    pub last: Press,
}

#[component]
impl Pressed {
    /// Code of a press.
    #[entry(infallible)]
    pub fn run(&mut self, press: Press, twice: bool) -> u32 {
        match self.last {
            before @ (Press::Short | Press::Double) if before == press => {
                self.last = Press::None;
                10
            }
            Press::Long if twice => 20,
            before => {
                self.last = press;
                let code = match before {
                    Press::None => 0,
                    Press::Short => return 31,
                    other if other != press => 2,
                    _ => 3,
                };
                40 + code
            }
        }
    }
}

/// A match with lists of values.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Listed {
    /// The sum so far.
    pub sum: i64,
}

#[component]
impl Listed {
    /// Adds a number that depends on `kind`.
    #[entry]
    pub fn run(&mut self, kind: i16, negative: bool) -> i64 {
        match kind {
            1..=3 => self.sum += 1,
            -2..=-1 | 5 => self.sum -= 1,
            n @ 10..=12 => self.sum *= n as i64,
            _ => {}
        }
        match negative {
            true if self.sum > 5 => -self.sum,
            true => self.sum,
            minus => minus as i64,
        }
    }
}
