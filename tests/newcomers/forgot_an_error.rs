//! An error type without an attribute.
use bessemer::prelude::*;

#[derive(Clone, Copy)]
pub enum Trouble {
    Low,
}

#[function]
fn checked(x: f64) -> Result<f64, Trouble> {
    if x < 0.0 { Err(Trouble::Low) } else { Ok(x) }
}

#[component]
#[derive(Default)]
pub struct ForgotAnError {
    pub last: f64,
}

#[component]
impl ForgotAnError {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = checked(x).unwrap_or(0.0);
        self.last
    }
}
