//! A function of the firmware, declared as in C.
use bessemer::prelude::*;

unsafe extern "C" {
    fn adc_read() -> u16;
}

#[component]
#[derive(Default)]
pub struct ExternFunction {
    pub last: u16,
}

#[component]
impl ExternFunction {
    #[entry]
    pub fn step(&mut self) -> u16 {
        self.last = unsafe { adc_read() };
        self.last
    }
}
