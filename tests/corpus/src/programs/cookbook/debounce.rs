//! A debounced push button that reports presses, short and long ones: the blocks `Debounce` and `Timer`.

use bessemer::prelude::*;
pub use bessemer_blocks::{Debounce, Timer};

/// Number of equal samples for a change: 5 ms at 1 kHz, longer than the contacts of small buttons bounce.
pub const STABLE_SAMPLES: u32 = 5;
/// Number of samples for a long press: 800 ms.
pub const LONG_SAMPLES: u32 = 800;

/// Event of a button at a sample.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ButtonEvent {
    /// Nothing happened.
    #[default]
    Steady,
    /// The button was released before the press was long.
    Short,
    /// The press became long.
    Long,
}

/// A debounced push button.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PushButton {
    contact: Debounce,
    /// Time for which it is pressed.
    held: Timer,
    /// True if the press is long.
    is_long: bool,
}

#[component]
impl PushButton {
    /// Takes one sample of the pin; `closed` is true if the contact is closed.
    #[entry(infallible)]
    pub fn sample(&mut self, closed: bool) -> ButtonEvent {
        let contact = self.contact.step(STABLE_SAMPLES, closed);
        let was_long = self.is_long;
        self.is_long = self.held.step(LONG_SAMPLES, contact.is_on);
        if self.is_long && !was_long {
            ButtonEvent::Long
        } else if contact.fell && !was_long {
            ButtonEvent::Short
        } else {
            ButtonEvent::Steady
        }
    }
}
