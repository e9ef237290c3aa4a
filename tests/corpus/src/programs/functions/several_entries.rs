//! A component may have several entry points; each has its own result.

use bessemer::prelude::*;

/// A counter of events with a limit.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Events {
    count: u32,
}

#[component]
impl Events {
    /// Counts an event; returns true if the limit is reached.
    #[entry(infallible)]
    pub fn happened(&mut self, limit: u32) -> bool {
        self.count = self.count.saturating_add(1);
        self.count >= limit
    }

    /// Number of events.
    #[entry(infallible)]
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Resets the counter; returns its last value.
    #[entry(infallible)]
    pub fn clear(&mut self) -> u32 {
        let count = self.count;
        self.count = 0;
        count
    }
}
