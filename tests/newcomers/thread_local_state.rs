//! A counter of each thread.
use bessemer::prelude::*;
use std::cell::Cell;

thread_local! {
    static CALLS: Cell<u32> = const { Cell::new(0) };
}

#[component]
#[derive(Default)]
pub struct ThreadLocal {
    pub last: u32,
}

#[component]
impl ThreadLocal {
    #[entry]
    pub fn step(&mut self) -> u32 {
        CALLS.with(|calls| calls.set(calls.get().wrapping_add(1)));
        self.last = CALLS.with(|calls| calls.get());
        self.last
    }
}
