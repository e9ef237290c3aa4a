//! Two names that are one number in the C, one of them the default of a field.
use bessemer::prelude::*;

#[component]
pub struct DefaultChecksum {
    pub name: &'static str,
}

impl Default for DefaultChecksum {
    fn default() -> Self {
        DefaultChecksum { name: "plumless" }
    }
}

#[component]
impl DefaultChecksum {
    #[entry]
    pub fn step(&mut self) -> bool {
        let known = self.name == "buckeroo";
        self.name = "minnow";
        known
    }
}
