//! A register of the peripheral.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct RawRegister {
    pub last: u32,
}

#[component]
impl RawRegister {
    #[entry]
    pub fn step(&mut self) -> u32 {
        self.last = unsafe { core::ptr::read_volatile(0x4000_0000 as *const u32) };
        self.last
    }
}
