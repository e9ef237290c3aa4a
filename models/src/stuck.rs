//! A sensor that repeats itself to the last bit is dead: noise never does.

use bessemer::prelude::*;

/// So many equal readings in a row are no accident.
const MOST_EQUAL: u32 = 8;

/// Watches three readings of one sensor.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stuck {
    /// The last reading.
    pub last: Vector3<f64>,
    /// How many like it came in a row.
    pub equal: u32,
}

#[component]
impl Stuck {
    /// A new reading: whether the sensor is alive.
    #[entry(infallible)]
    pub fn alive(&mut self, reading: &Vector3<f64>) -> bool {
        let same = reading.x == self.last.x && reading.y == self.last.y && reading.z == self.last.z;
        if same {
            self.equal = self.equal.saturating_add(1);
        } else {
            self.equal = 0;
        }
        self.last = *reading;
        self.equal < MOST_EQUAL
    }
}
