//! An author's methods with the names of those of `bool`, and those of `bool` itself.

use bessemer::prelude::*;

/// A switch.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Switch {
    pub on: bool,
    pub asked: u8,
}

#[data]
impl Switch {
    /// The value if the switch is off; counts the calls.
    pub fn then_some(&mut self, value: u8) -> Option<u8> {
        self.asked = self.asked.wrapping_add(1);
        if self.on { None } else { Some(value) }
    }

    /// The other switch, if this one is on.
    pub fn then(self, other: Switch) -> Switch {
        Switch { on: self.on && other.on, asked: other.asked }
    }
}

/// Calls the author's methods.
#[function]
pub fn chosen(switch: &mut Switch, other: Switch, value: u8) -> Option<u8> {
    let chosen = switch.then_some(value.wrapping_mul(3));
    *switch = switch.then(other);
    chosen
}

/// Methods of `bool`: the argument of `then_some` is evaluated first, and may fault.
#[function]
pub fn given(switch: Switch, value: u8) -> Option<u8> {
    let quotient = switch.on.then_some(200 / value);
    let same = (value > 7).then_some(switch.asked);
    let later = (!switch.on).then(|| value.wrapping_add(1));
    quotient.or(same).or(later)
}
