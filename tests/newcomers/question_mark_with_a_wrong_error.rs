//! An error passed on.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub enum Broken {
    Range,
}

#[data]
#[derive(Clone, Copy)]
pub enum Failed {
    Sensor,
}

#[function]
fn checked(x: f64) -> Result<f64, Broken> {
    if x > 9.0 { Err(Broken::Range) } else { Ok(x) }
}

#[component]
#[derive(Default)]
pub struct QuestionMarkWithAWrongError {
    pub last: f64,
}

#[component]
impl QuestionMarkWithAWrongError {
    #[entry]
    pub fn step(&mut self, x: f64) -> Result<f64, Failed> {
        self.last = checked(x)?;
        Ok(self.last)
    }
}
