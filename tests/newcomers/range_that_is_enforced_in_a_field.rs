//! A field that shall be clamped.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Gain {
    #[range(0.0..=1.0, clamp)]
    pub value: f64,
}

#[component]
#[derive(Default)]
pub struct RangeThatIsEnforcedInAField {
    pub last: f64,
}

#[component]
impl RangeThatIsEnforcedInAField {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        let gain = Gain { value: x };
        self.last = gain.value;
        self.last
    }
}
