//! The name of a state, for the display.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct StrResult {
    pub code: u8,
}

#[component]
impl StrResult {
    #[entry]
    pub fn name(&self) -> &'static str {
        match self.code {
            0 => "idle",
            _ => "run",
        }
    }
}
