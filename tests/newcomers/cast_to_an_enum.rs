//! A mode from its number.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, PartialEq)]
pub enum Gear {
    Park,
    Drive,
}

#[component]
#[derive(Default)]
pub struct CastToAnEnum {
    pub last: u8,
}

#[component]
impl CastToAnEnum {
    #[entry]
    pub fn step(&mut self, code: u8) -> bool {
        self.last = code;
        let gear = code as Gear;
        gear == Gear::Drive
    }
}
