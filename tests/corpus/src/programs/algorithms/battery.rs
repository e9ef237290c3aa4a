//! State of charge by counting coulombs, corrected by the voltage at rest.

use bessemer::prelude::*;

/// Voltage at rest for each tenth of the charge, mV.
const REST: [u16; 11] =
    [3000, 3450, 3550, 3600, 3640, 3680, 3740, 3820, 3920, 4050, 4200];

/// Estimator of a battery's state of charge.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Gauge {
    /// Charge, mA·s.
    charge: i64,
    resting: u16,
}

#[component]
impl Gauge {
    /// One second: takes the current out of the battery in mA and the voltage in mV, and returns the charge in ‰.
    #[entry]
    pub fn step(&mut self, current: i32, voltage: u16, capacity: u32) -> u16 {
        assert!(capacity > 0);
        let full = i64::from(capacity) * 3600;
        self.charge = (self.charge - i64::from(current)).clamp(0, full);
        self.resting = if current.abs() < 50 { self.resting.saturating_add(1) } else { 0 };
        if self.resting >= 600 {
            self.charge = full * i64::from(at_rest(voltage)) / 1000;
            self.resting = 0;
        }
        (self.charge * 1000 / full) as u16
    }
}

/// The charge that belongs to an open-circuit voltage, in ‰.
#[function]
pub fn at_rest(voltage: u16) -> u16 {
    for i in 1..11 {
        if voltage < REST[i] {
            let below = voltage.max(REST[i - 1]) - REST[i - 1];
            let part = u32::from(below) * 100 / u32::from(REST[i] - REST[i - 1]);
            return (i as u16 - 1) * 100 + part as u16;
        }
    }
    1000
}
