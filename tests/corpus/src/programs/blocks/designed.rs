//! A cart that is held at a position: regulator, observer and filter have constants that `bessemer-design` computed.
//!
//! Here the constants are a committed file, `designed.in`; in a package of your own a build script can write them.

use bessemer::prelude::*;
pub use bessemer_blocks::Cascade;

include!("designed.in");

/// Holds a cart at a position.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cart {
    /// Estimated position and speed.
    estimate: Vector2<f64>,
    smooth: Cascade<f64, 2>,
}

#[component]
impl Cart {
    /// Advances one period of 10 ms; returns the force, N.
    #[entry(infallible)]
    pub fn step(&mut self, #[unit("m")] target: f64, #[unit("m")] measured: f64) -> f64 {
        let innovation = measured - self.estimate.x;
        self.estimate += OBSERVER * innovation;
        let wanted = self.smooth.step(&SMOOTH, target);
        let force = (GAIN * (Vector2::new(wanted, 0.0) - self.estimate)).x;
        self.estimate = TRANSITION * self.estimate + INPUT * force;
        force
    }
}
