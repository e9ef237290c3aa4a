//! Detection of a stuck sensor: noise never repeats a reading to the last bit.

use bessemer::prelude::*;

/// Stuck detection of a sensor with three readings.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stuck {
    /// The last reading.
    pub last: Vector3<f64>,
}

#[component]
impl Stuck {
    /// Returns true if a reading differs from the last one. Two readings equal by chance lose one of them; a stuck
    /// sensor is not used even once.
    #[requirement("HLR-22")]
    #[entry(infallible)]
    pub fn is_new(&mut self, reading: &Vector3<f64>) -> bool {
        let is_new = *reading != self.last;
        self.last = *reading;
        is_new
    }
}
