//! A sensor that repeats itself to the last bit is dead: noise never does.

use bessemer::prelude::*;

/// Watches three readings of one sensor.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stuck {
    /// The last reading.
    pub last: Vector3<f64>,
}

#[component]
impl Stuck {
    /// Whether a reading is a new one. Two that are equal by chance cost one of them, which is no loss; a
    /// sensor that sticks is not believed even once.
    #[entry(infallible)]
    pub fn says(&mut self, reading: &Vector3<f64>) -> bool {
        let new = *reading != self.last;
        self.last = *reading;
        new
    }
}
