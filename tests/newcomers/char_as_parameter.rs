//! A letter of a command.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct CharAsParameter {
    pub last: u8,
}

#[component]
impl CharAsParameter {
    #[entry]
    pub fn step(&mut self, letter: char) -> u8 {
        self.last = letter as u8;
        self.last
    }
}
