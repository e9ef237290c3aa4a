//! A `Default` that panics: its value is computed when the C is written.
use bessemer::prelude::*;

/// The gains of a loop.
#[data]
#[derive(Clone, Copy)]
pub struct Gains {
    /// Gain of the error.
    pub p: f64,
}

impl Default for Gains {
    fn default() -> Gains {
        let of_orders = [1.0, 2.0];
        let order = of_orders.len();
        Gains { p: of_orders[order] }
    }
}

/// A loop.
#[component]
#[derive(Clone, Copy, Default)]
pub struct Loop {
    /// Its gains.
    pub gains: Gains,
}

#[component]
impl Loop {
    /// One period.
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.gains.p * x
    }
}
