//! A bounded queue of events, in the order of their due times.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Happening {
    #[default]
    Tick,
    Pressed {
        button: u8,
    },
    Measured(f32),
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Appointment {
    pub due: u32,
    pub event: Happening,
}

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Agenda {
    entries: List<Appointment, 8>,
}

#[component]
impl Agenda {
    /// Adds an event; returns false if the queue is full.
    #[entry]
    pub fn add(&mut self, due: u32, event: &Happening) -> bool {
        if self.entries.len() >= self.entries.capacity() {
            return false;
        }
        let at =
            self.entries.iter().position(|entry| entry.due > due).unwrap_or(self.entries.len());
        self.entries.insert(at, Appointment { due, event: *event });
        true
    }

    /// Returns the next due event, if any.
    #[entry]
    pub fn next(&mut self, now: u32) -> Option<Happening> {
        match self.entries.first() {
            Some(entry) if entry.due <= now => Some(self.entries.remove(0).event),
            _ => None,
        }
    }

    /// The due time of the next event.
    #[entry]
    pub fn soonest(&self) -> Option<u32> {
        self.entries.iter().map(|entry| entry.due).min()
    }

    /// Removes all `Tick` events.
    #[entry]
    pub fn drop_ticks(&mut self) {
        self.entries.retain(|entry| !matches!(entry.event, Happening::Tick));
    }
}
