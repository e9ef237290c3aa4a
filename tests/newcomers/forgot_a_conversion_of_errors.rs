//! The conversion of an error without an attribute, by `?`.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub enum ReadTrouble {
    Low,
    High,
}

#[data]
#[derive(Clone, Copy)]
pub enum StepTrouble {
    Sensor,
    Other,
}

impl From<ReadTrouble> for StepTrouble {
    fn from(_: ReadTrouble) -> StepTrouble {
        StepTrouble::Sensor
    }
}

#[function]
fn read(x: f64) -> Result<f64, ReadTrouble> {
    if x < 0.0 { Err(ReadTrouble::Low) } else { Ok(x) }
}

#[function]
fn twice(x: f64) -> Result<f64, StepTrouble> {
    Ok(2.0 * read(x)?)
}

#[component]
#[derive(Default)]
pub struct ForgotAConversionOfErrors {
    pub last: f64,
}

#[component]
impl ForgotAConversionOfErrors {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = twice(x).unwrap_or(0.0);
        self.last
    }
}
