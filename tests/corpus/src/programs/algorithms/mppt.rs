//! Maximum power point tracking by perturbation, with a voter for three current sensors.

use bessemer::prelude::*;

/// The median of three measurements, and whether all agree within a tolerance.
#[function]
fn voted<T: Real>(readings: [T; 3], tolerance: T) -> (T, bool) {
    let [a, b, c] = readings;
    let middle = a.max(b).min(a.min(b).max(c));
    (middle, readings.iter().all(|reading| (*reading - middle).abs() <= tolerance))
}

/// Direction in which the voltage changes.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Way {
    #[default]
    Up,
    Down,
}

#[data]
impl Way {
    fn turned(self) -> Self {
        match self {
            Self::Up => Self::Down,
            Self::Down => Self::Up,
        }
    }

    fn signed(self, step: f32) -> f32 {
        if self == Way::Up { step } else { -step }
    }
}

/// The tracker of a solar panel.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Tracker {
    way: Way,
    #[unit("V")]
    voltage: f32,
    #[unit("W")]
    best: f32,
    #[unit("V")]
    step: f32,
    disagreed: u16,
}

impl Default for Tracker {
    fn default() -> Self {
        Self { way: Way::Up, voltage: 17.5, best: 0.0, step: 0.2, disagreed: 0 }
    }
}

#[component]
impl Tracker {
    const LOWEST: f32 = 12.0;
    const HIGHEST: f32 = 21.0;

    /// Takes the voltage in V and the currents in A; returns the voltage to hold until the next call, V.
    #[entry(infallible)]
    pub fn step(&mut self, voltage: f32, currents: &[f32; 3]) -> f32 {
        let (current, agree) = voted(*currents, 0.05);
        if !agree {
            self.disagreed = self.disagreed.saturating_add(1);
        }
        let power = voltage * current;
        let turned = power < self.best;
        if turned {
            self.way = self.way.turned();
        }
        // Near the top the steps get shorter.
        self.step = (self.step * if turned { 0.7 } else { 1.05 }).clamp(0.02, 0.5);
        self.best = power;
        self.voltage = (self.voltage + self.way.signed(self.step)).clamp(Self::LOWEST, Self::HIGHEST);
        self.voltage
    }
}
