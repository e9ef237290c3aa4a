//! A component has state, entry points, and methods of its own that are `static` in the C.

use bessemer::prelude::*;

/// Tells whether a contact is closed, once it has been stable.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contact {
    closed: bool,
    agreeing: u8,
}

#[component]
impl Contact {
    /// Number of samples that must agree.
    const STABLE: u8 = 3;

    /// One sample of the pin.
    #[entry(infallible)]
    pub fn sample(&mut self, level: bool) -> bool {
        self.count(level);
        if self.agreeing >= Self::STABLE {
            self.closed = level;
            self.agreeing = 0;
        }
        self.closed
    }

    /// Forgets what was seen.
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
