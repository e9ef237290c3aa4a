//! A text that is compared.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct StringWithin {
    pub last: bool,
}

#[component]
impl StringWithin {
    #[entry]
    pub fn step(&mut self, code: u8) -> bool {
        let name = if code == 0 { "idle".to_string() } else { String::from("run") };
        self.last = name == "run";
        self.last
    }
}
