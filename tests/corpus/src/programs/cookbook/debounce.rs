//! A debounced push button that reports edges: a level counts after a fixed number of equal samples in a row.

use bessemer::prelude::*;

/// Samples that have to agree: 5 ms at 1 kHz, longer than what contacts of small buttons take to settle.
pub const STABLE_SAMPLES: u8 = 5;

/// Edge at a sample.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ButtonEdge {
    /// The level is what it was.
    #[default]
    Steady,
    /// It was pressed.
    Pressed,
    /// It was released.
    Released,
}

/// A push button.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PushButton {
    /// True if it is held to be pressed.
    pressed: bool,
    /// Samples in a row that said otherwise, below `STABLE_SAMPLES`.
    differing: u8,
}

#[component]
impl PushButton {
    /// One sample of the pin; `closed`: whether the contact is closed.
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
