//! Variants whose names have no letter, or begin with a digit behind an underscore, and variants that a block imports.

use bessemer::prelude::*;

/// Rate of a code.
#[data]
#[derive(Clone, Copy, PartialEq)]
pub enum Rate {
    _4_5,
    _4_6,
    _7kHz,
    _7KHz,
    _Whole,
}

#[data]
impl Rate {
    /// Denominator of the rate.
    pub fn denominator(self) -> i32 {
        match self {
            Rate::_4_5 => 5,
            Rate::_4_6 => 6,
            Rate::_7kHz => 7,
            Rate::_7KHz => 8,
            Rate::_Whole => 1,
        }
    }
}

/// Passes variants as arguments, where a function could be, too.
#[function]
pub fn names_of_variants_sum(n: i32) -> i32 {
    let most = |rate: Rate, n: i32| if n > 3 { rate.denominator() } else { n };
    most(Rate::_4_5, n) + chosen(Rate::_4_6, n) + chosen(Rate::_7kHz, n) + most(Rate::_7KHz, n) - chosen(Rate::_Whole, n)
}

#[function]
fn chosen(rate: Rate, n: i32) -> i32 {
    if rate == Rate::_4_6 { n % 100 } else { rate.denominator() }
}

/// Result of a step.
#[data]
#[derive(Clone, Copy)]
pub enum Pushed {
    Single(u8),
    Pair { first: u8, second: u8 },
    Nothing,
}

/// Another type with a variant of an equal name.
#[data]
#[derive(Clone, Copy)]
pub enum Popped {
    Single(u8),
    Nothing,
}

#[function]
fn pushed(n: u8) -> Pushed {
    use Pushed::*;
    match n % 3 {
        0 => Nothing,
        1 => Single(n),
        _ => Pair { first: n, second: n / 2 },
    }
}

/// Imports within loops, arms and branches; the names end with their block.
#[function]
pub fn names_of_variants_imported(numbers: [u8; 6]) -> [u32; 3] {
    let mut sums = [0_u32; 3];
    for n in numbers {
        use Pushed::*;
        match pushed(n) {
            Single(one) => sums[0] += u32::from(one),
            Pair { first, second } => {
                use crate::programs::data::corner_cases::names_of_variants::chosen as picked;
                sums[1] += u32::from(first) + u32::from(second);
                sums[2] += picked(Rate::_7KHz, 2) as u32;
            }
            Nothing => {
                use Popped::*;
                let last = if n > 9 { Single(n) } else { Popped::Nothing };
                if let Single(it) = last {
                    sums[2] += u32::from(it);
                }
            }
        }
    }
    sums
}
