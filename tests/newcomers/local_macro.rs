//! A macro of one's own that hides a `return`.
use bessemer::prelude::*;

macro_rules! bail {
    ($value:expr) => {
        return $value
    };
}

#[component]
#[derive(Default)]
pub struct LocalMacro {
    pub last: f64,
}

#[component]
impl LocalMacro {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        if x < 0.0 {
            bail!(0.0);
        }
        self.last = x;
        self.last
    }
}
