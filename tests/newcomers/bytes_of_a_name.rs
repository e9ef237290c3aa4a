//! A name that is sent as bytes.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SentName {
    pub name: &'static str,
    pub last: usize,
}

#[component]
impl SentName {
    #[entry]
    pub fn step(&mut self, name: &'static str) -> usize {
        self.last = usize::from(name.as_bytes()[0]);
        self.last
    }
}
