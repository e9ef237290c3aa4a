//! A state machine whose states carry data: a connection with timeouts and growing pauses between retries.

use bessemer::prelude::*;

/// State of the connection.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Link {
    /// Waits a number of ticks before the next attempt.
    #[default]
    Idle,
    Waiting { ticks: u16, tries: u8 },
    /// A request was sent `ticks` ticks ago, after `tries` attempts.
    Asking { ticks: u16, tries: u8 },
    /// The connection is established; the number of ticks since something was last received.
    Up(u16),
    Failed,
}

/// The state machine.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Connection {
    link: Link,
}

#[component]
impl Connection {
    /// One tick. `heard` is true if something was received; returns true if a request is to be sent now.
    #[entry(infallible)]
    pub fn tick(&mut self, heard: bool) -> bool {
        let (next, send) = match self.link {
            Link::Idle => (Link::Asking { ticks: 0, tries: 1 }, true),
            Link::Waiting { ticks: 0, tries } => (Link::Asking { ticks: 0, tries }, true),
            Link::Waiting { ticks, tries } => (Link::Waiting { ticks: ticks.saturating_sub(1), tries }, false),
            Link::Asking { .. } if heard => (Link::Up(0), false),
            Link::Asking { ticks, tries } if ticks < 10 => {
                (Link::Asking { ticks: ticks + 1, tries }, false)
            }
            Link::Asking { tries, .. } if tries >= 4 => (Link::Failed, false),
            Link::Asking { tries, .. } => {
                (Link::Waiting { ticks: 5_u16 << (tries & 7), tries: tries.wrapping_add(1) }, false)
            }
            Link::Up(_) if heard => (Link::Up(0), false),
            Link::Up(quiet) if quiet < 50 => (Link::Up(quiet + 1), false),
            Link::Up(_) | Link::Failed => (Link::Idle, false),
        };
        self.link = next;
        send
    }
}
