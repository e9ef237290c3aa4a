//! A component has state, entry points, and private methods, which are `static` in the C.

use bessemer::prelude::*;

/// Debounces a contact.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contact {
    closed: bool,
    agreeing: u8,
}

#[component]
impl Contact {
    /// Number of equal samples for a change.
    const STABLE: u8 = 3;

    /// Takes one sample of the pin; returns the debounced level.
    #[entry(infallible)]
    pub fn sample(&mut self, level: bool) -> bool {
        self.count(level);
        if self.agreeing >= Self::STABLE {
            self.closed = level;
            self.agreeing = 0;
        }
        self.closed
    }

    /// Restarts at a level.
    #[entry(infallible)]
    pub fn reset(&mut self, closed: bool) {
        self.closed = closed;
        self.agreeing = 0;
    }

    fn count(&mut self, level: bool) {
        if level == self.closed {
            self.agreeing = 0;
        } else {
            self.agreeing = self.agreeing.saturating_add(1);
        }
    }
}
