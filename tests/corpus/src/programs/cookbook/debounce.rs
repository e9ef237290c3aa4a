//! A debounced push button that reports edges: a level counts after a fixed number of equal samples in a row.

use bessemer::prelude::*;

/// Number of equal samples for a change: 5 ms at 1 kHz, longer than the contacts of small buttons bounce.
pub const STABLE_SAMPLES: u8 = 5;

/// Change of the debounced level at a sample.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ButtonEdge {
    /// The level did not change.
    #[default]
    Steady,
    /// The button was pressed.
    Pressed,
    /// The button was released.
    Released,
}

/// A debounced push button.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PushButton {
    /// The debounced state: true if the button is pressed.
    pressed: bool,
    /// Number of consecutive samples that differ from `pressed`; below `STABLE_SAMPLES`.
    differing: u8,
}

#[component]
impl PushButton {
    /// Takes one sample of the pin; `closed` is true if the contact is closed.
    #[entry(infallible)]
    pub fn sample(&mut self, closed: bool) -> ButtonEdge {
        if closed == self.pressed {
            self.differing = 0;
            return ButtonEdge::Steady;
        }
        self.differing = self.differing.saturating_add(1);
        if self.differing < STABLE_SAMPLES {
            return ButtonEdge::Steady;
        }
        self.differing = 0;
        self.pressed = closed;
        if closed { ButtonEdge::Pressed } else { ButtonEdge::Released }
    }

    /// Returns true if it is pressed.
    #[entry(infallible)]
    pub fn is_pressed(&self) -> bool {
        self.pressed
    }
}
