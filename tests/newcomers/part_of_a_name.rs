//! A name without its prefix.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct ShortName {
    pub last: usize,
}

#[component]
impl ShortName {
    #[entry]
    pub fn step(&mut self, name: &'static str) -> usize {
        if &name[2..] == "speed" {
            self.last += 1;
        }
        self.last
    }
}
