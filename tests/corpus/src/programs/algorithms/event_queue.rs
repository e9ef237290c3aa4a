//! A bounded queue of events, by the time when they are due.

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
    /// Notes what is due; whether there is room.
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

    /// When the next is due.
    #[entry]
    pub fn soonest(&self) -> Option<u32> {
        self.entries.iter().map(|entry| entry.due).min()
    }

    /// Forgets the ticks.
    #[entry]
    pub fn drop_ticks(&mut self) {
        self.entries.retain(|entry| !matches!(entry.event, Happening::Tick));
    }
}
