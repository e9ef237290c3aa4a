//! A component may have many entry points; each returns what its signature says.

use bessemer::prelude::*;

/// A counter of events with a limit.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Events {
    count: u32,
}

#[component]
impl Events {
    /// One event: whether the limit is reached.
    #[entry(infallible)]
    pub fn happened(&mut self, limit: u32) -> bool {
        self.count = self.count.saturating_add(1);
        self.count >= limit
    }

    /// Number of samples.
    #[entry(infallible)]
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Starts anew; how many there were.
    #[entry(infallible)]
    pub fn clear(&mut self) -> u32 {
        let count = self.count;
        self.count = 0;
        count
    }
}
