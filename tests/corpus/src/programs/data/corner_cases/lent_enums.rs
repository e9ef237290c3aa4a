//! Enums in memory that a function gets by reference: its content before the call is not checked for valid variants,
//! while the caller's arguments are.

use bessemer::prelude::*;

/// Duty of a day.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Duty {
    /// Free.
    #[default]
    Rest,
    /// On duty.
    Work,
}

/// A table that is large enough to be passed by reference, and an enum next to it.
#[component]
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Roster {
    duty: Duty,
    hours: [[u64; 16]; 16],
}

#[component]
impl Roster {
    /// Enters the duty at an hour of a day; if the day is out of range, nothing changes.
    #[entry(atomic)]
    pub fn note(&mut self, duty: Duty, day: u8, hour: u8) -> u64 {
        self.duty = duty;
        let hours = &mut self.hours[usize::from(day)];
        hours[usize::from(hour % 16)] += u64::from(duty == Duty::Work);
        hours[usize::from(hour % 16)]
    }
}
