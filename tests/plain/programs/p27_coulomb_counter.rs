//! Battery coulomb counter: charge in physical units, state of charge corrected
//! from the open-circuit voltage at rest, capacity learned between rests.

use core::ops::{Add, AddAssign, Div, Mul, Sub};

/// Charge in milliampere-hours.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct MilliampHours(pub f32);

/// Current into the battery in milliamperes.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Milliamps(pub f32);

#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Seconds(pub f32);

#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Volts(pub f32);

/// State of charge, 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Soc(f32);

impl Mul<Seconds> for Milliamps {
    type Output = MilliampHours;
    fn mul(self, t: Seconds) -> MilliampHours {
        MilliampHours(self.0 * t.0 / 3600.0)
    }
}

impl Add for MilliampHours {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        Self(self.0 + rhs.0)
    }
}

impl AddAssign for MilliampHours {
    fn add_assign(&mut self, rhs: Self) {
        *self = *self + rhs;
    }
}

impl Div for MilliampHours {
    type Output = f32;
    fn div(self, rhs: Self) -> f32 {
        self.0 / rhs.0
    }
}

impl Sub for Soc {
    type Output = f32;
    fn sub(self, rhs: Self) -> f32 {
        self.0 - rhs.0
    }
}

impl Soc {
    /// Open-circuit voltage of one cell in steps of 10 %.
    const OCV: [f32; 11] =
        [3.00, 3.45, 3.55, 3.60, 3.64, 3.69, 3.77, 3.86, 3.95, 4.06, 4.20];

    pub fn new(fraction: f32) -> Self {
        Self(fraction.clamp(0.0, 1.0))
    }

    pub fn from_ocv(Volts(v): Volts) -> Self {
        match Self::OCV.iter().position(|&ocv| ocv >= v) {
            Some(0) => Self(0.0),
            None => Self(1.0),
            Some(i) => {
                let (low, high) = (Self::OCV[i - 1], Self::OCV[i]);
                Self::new(((i - 1) as f32 + (v - low) / (high - low)) / 10.0)
            }
        }
    }

    pub fn percent(self) -> u8 {
        (self.0 * 100.0).round() as u8
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    Empty,
    Full,
    /// Rested long enough; carries what the voltage added to the count.
    Corrected { by: f32 },
}

#[derive(Clone, Debug)]
pub struct CoulombCounter {
    capacity: MilliampHours,
    soc: Soc,
    resting: Seconds,
    /// State of charge at the last rest and the charge moved since.
    anchor: Option<(Soc, MilliampHours)>,
}

impl CoulombCounter {
    const REST_CURRENT: Milliamps = Milliamps(20.0);
    const REST_TIME: Seconds = Seconds(1800.0);
    const CHARGE_EFFICIENCY: f32 = 0.99;
    /// Swing between two rests from which the capacity may be learned.
    const LEARN_SWING: f32 = 0.4;
    const LEARN_RATE: f32 = 0.25;

    pub fn new(capacity: MilliampHours, at_rest: Volts) -> Self {
        Self { capacity, soc: Soc::from_ocv(at_rest), resting: Seconds(0.0), anchor: None }
    }

    pub fn step(&mut self, current: Milliamps, voltage: Volts, dt: Seconds) -> Option<Event> {
        let before = self.soc;
        let charge = match current * dt {
            MilliampHours(q) if q > 0.0 => MilliampHours(q * Self::CHARGE_EFFICIENCY),
            discharged => discharged,
        };
        self.soc = Soc::new(self.soc.0 + charge / self.capacity);
        if let Some((_, moved)) = &mut self.anchor {
            *moved += charge;
        }

        if Milliamps(current.0.abs()) < Self::REST_CURRENT {
            self.resting.0 += dt.0;
        } else {
            self.resting = Seconds(0.0);
        }
        if self.resting >= Self::REST_TIME {
            self.resting = Seconds(0.0);
            return Some(Event::Corrected { by: self.correct(voltage) });
        }
        match (before.0, self.soc.0) {
            (b, 0.0) if b > 0.0 => Some(Event::Empty),
            (b, 1.0) if b < 1.0 => Some(Event::Full),
            _ => None,
        }
    }

    fn correct(&mut self, voltage: Volts) -> f32 {
        let from_voltage = Soc::from_ocv(voltage);
        match self.anchor.replace((from_voltage, MilliampHours::default())) {
            Some((then, moved)) if (from_voltage - then).abs() > Self::LEARN_SWING => {
                let seen = moved.0 / (from_voltage - then);
                self.capacity.0 += Self::LEARN_RATE * (seen - self.capacity.0);
            }
            // Too small a swing: keep counting from the old anchor.
            Some(old @ (then, _)) if (from_voltage - then).abs() > 0.02 => self.anchor = Some(old),
            _ => {}
        }
        let by = from_voltage - self.soc;
        self.soc = from_voltage;
        by
    }

    pub fn soc(&self) -> Soc {
        self.soc
    }

    pub fn capacity(&self) -> MilliampHours {
        self.capacity
    }

    /// Time to empty at the given discharge; `None` when not discharging.
    pub fn time_left(&self, current: Milliamps) -> Option<Seconds> {
        (current < -Milliamps(1.0)).then(|| {
            Seconds(3600.0 * self.soc.0 * self.capacity.0 / -current.0)
        })
    }
}

impl core::ops::Neg for Milliamps {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rest(c: &mut CoulombCounter, v: f32) -> Option<Event> {
        (0..30).find_map(|_| c.step(Milliamps(0.0), Volts(v), Seconds(60.0)))
    }

    #[test]
    fn counts_down_and_reports_empty_once() {
        let mut c = CoulombCounter::new(MilliampHours(1000.0), Volts(3.69));
        assert_eq!(c.soc().percent(), 50);
        let left = c.time_left(-Milliamps(500.0)).unwrap();
        assert!((left.0 - 3600.0).abs() < 1.0);
        let empties = (0..80)
            .filter_map(|_| c.step(Milliamps(-500.0), Volts(3.5), Seconds(60.0)))
            .filter(|e| *e == Event::Empty)
            .count();
        assert_eq!((empties, c.soc().percent()), (1, 0));
        assert_eq!(c.time_left(Milliamps(100.0)), None);
    }

    #[test]
    fn rest_corrects_from_the_voltage() {
        let mut c = CoulombCounter::new(MilliampHours(1000.0), Volts(3.69));
        let event = rest(&mut c, 3.86);
        assert!(matches!(event, Some(Event::Corrected { by }) if (by - 0.2).abs() < 1e-3));
        assert_eq!(c.soc().percent(), 70);
    }

    #[test]
    fn learns_a_worn_capacity() {
        let mut c = CoulombCounter::new(MilliampHours(1000.0), Volts(4.06));
        rest(&mut c, 4.06);
        // 480 mAh out take the worn cell (800 mAh) from 90 % to 30 %.
        for _ in 0..60 {
            c.step(Milliamps(-480.0), Volts(3.6), Seconds(60.0));
        }
        rest(&mut c, 3.60);
        assert!((c.capacity().0 - 950.0).abs() < 2.0, "{:?}", c.capacity());
    }
}
