//! A counter in a global.
use bessemer::prelude::*;

static mut COUNT: u32 = 0;

#[component]
#[derive(Default)]
pub struct StaticMut {
    pub last: u32,
}

#[component]
impl StaticMut {
    #[entry]
    pub fn step(&mut self) -> u32 {
        unsafe {
            COUNT = COUNT.wrapping_add(1);
            self.last = COUNT;
        }
        self.last
    }
}
