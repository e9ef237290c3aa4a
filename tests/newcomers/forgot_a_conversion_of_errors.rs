//! The conversion of an error without an attribute, by `?`.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub enum Inner {
    Low,
    High,
}

#[data]
#[derive(Clone, Copy)]
pub enum Outer {
    Sensor,
    Other,
}

impl From<Inner> for Outer {
    fn from(_: Inner) -> Outer {
        Outer::Sensor
    }
}

#[function]
fn read(x: f64) -> Result<f64, Inner> {
    if x < 0.0 { Err(Inner::Low) } else { Ok(x) }
}

#[function]
fn twice(x: f64) -> Result<f64, Outer> {
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
