//! A counter that interrupts may read.
use bessemer::prelude::*;
use core::sync::atomic::{AtomicU32, Ordering};

static STEPS: AtomicU32 = AtomicU32::new(0);

#[component]
#[derive(Default)]
pub struct AtomicCounter {
    pub last: u32,
}

#[component]
impl AtomicCounter {
    #[entry]
    pub fn step(&mut self) -> u32 {
        self.last = STEPS.fetch_add(1, Ordering::Relaxed);
        self.last
    }
}
