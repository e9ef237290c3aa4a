//! Enums in memory that is lent: what it holds before the call is not looked at, while what the caller passes is.

use bessemer::prelude::*;

/// Present duty.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Duty {
    /// Nothing.
    #[default]
    Rest,
    /// Something.
    Work,
}

/// A table, which is large enough for its copy to be lent, and an enum beside it.
#[component]
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Roster {
    duty: Duty,
    hours: [[u64; 16]; 16],
}

#[component]
impl Roster {
    /// Writes down an hour of a day; where there is no such day, nothing is as if it had been called.
    #[entry(atomic)]
    pub fn note(&mut self, duty: Duty, day: u8, hour: u8) -> u64 {
        self.duty = duty;
        let hours = &mut self.hours[usize::from(day)];
        hours[usize::from(hour % 16)] += u64::from(duty == Duty::Work);
        hours[usize::from(hour % 16)]
    }
}
