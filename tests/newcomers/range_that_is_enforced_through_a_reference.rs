//! A parameter behind a reference that shall be clamped.
use bessemer::prelude::*;

#[function]
fn scaled(#[range(0.0..=1.0, clamp)] share: &f64) -> f64 {
    2.0 * share
}

#[component]
#[derive(Default)]
pub struct RangeThatIsEnforcedThroughAReference {
    pub last: f64,
}

#[component]
impl RangeThatIsEnforcedThroughAReference {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = scaled(&x);
        self.last
    }
}
