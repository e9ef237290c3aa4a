//! A text that says what is wrong.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct TextAsError {
    pub last: f64,
}

#[component]
impl TextAsError {
    #[entry]
    pub fn step(&mut self, x: f64) -> Result<f64, &'static str> {
        if x < 0.0 {
            return Err("negative");
        }
        self.last = x;
        Ok(self.last)
    }
}
