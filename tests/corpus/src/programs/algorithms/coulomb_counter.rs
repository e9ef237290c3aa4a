//! State of charge: coulombs counted, corrected by the open-circuit voltage at rest.
use bessemer::prelude::*;

/// Open-circuit voltage by state of charge, 0 to 1.
const TABLE: [(f32, f32); 7] =
    [(0.0, 3.0), (0.1, 3.45), (0.2, 3.55), (0.4, 3.65), (0.6, 3.80), (0.8, 3.98), (1.0, 4.2)];

#[function]
fn charge_at(voltage: f32) -> f32 {
    let Some(i) = TABLE.iter().position(|&(_, v)| v > voltage) else { return 1.0 };
    if i == 0 {
        return 0.0;
    }
    let ((c0, v0), (c1, v1)) = (TABLE[i - 1], TABLE[i]);
    c0 + (c1 - c0) * (voltage - v0) / (v1 - v0)
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Health {
    #[default]
    Good,
    Weak,
    Bad,
}

#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Gauge {
    charge: f32,
    capacity: f32,
    resting: u32,
    history: [f32; 8],
    at: usize,
}

impl Default for Gauge {
    fn default() -> Self {
        Gauge { charge: 0.5, capacity: 3.2 * 3600.0, resting: 0, history: [0.0; 8], at: 0 }
    }
}

#[component]
impl Gauge {
    const REST: u32 = 600;

    #[entry]
    pub fn step(&mut self, voltage: f32, current: f32, dt: f32) -> (f32, Health) {
        let Self { charge, capacity, resting, .. } = self;
        *charge = (*charge - current * dt / *capacity).clamp(0.0, 1.0);
        *resting = if current.abs() < 0.05 { *resting + 1 } else { 0 };
        if *resting > Self::REST {
            let true_charge = charge_at(voltage);
            *charge += 0.01 * (true_charge - *charge);
        }
        self.history[self.at] = voltage;
        self.at = (self.at + 1) % self.history.len();
        let lowest = self.history.iter().copied().fold(f32::INFINITY, f32::min);
        let mean = self.history.iter().sum::<f32>() / self.history.len() as f32;
        let sag = mean - lowest;
        let health = match sag {
            s if s < 0.1 => Health::Good,
            s if s < 0.3 => Health::Weak,
            _ => Health::Bad,
        };
        (self.charge, if self.charge < 0.05 { Health::Bad } else { health })
    }
}
