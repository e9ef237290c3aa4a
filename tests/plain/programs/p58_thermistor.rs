//! NTC thermistor linearisation with interchangeable characteristics.

use nalgebra::ComplexField;

#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Ohms(pub f32);

#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Celsius(pub f32);

#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Kelvin(pub f32);

impl From<Kelvin> for Celsius {
    fn from(k: Kelvin) -> Self {
        Celsius(k.0 - 273.15)
    }
}

impl From<Celsius> for Kelvin {
    fn from(c: Celsius) -> Self {
        Kelvin(c.0 + 273.15)
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SensorFault {
    OpenCircuit,
    ShortCircuit,
    OutOfRange(Ohms),
}

/// Thermistor to ground, fixed resistor to the ADC reference.
#[derive(Debug, Clone, Copy)]
pub struct Divider {
    pub pull_up: Ohms,
    pub full_scale: u16,
}

impl Divider {
    /// Counts next to the rails that are taken for a broken or shorted wire.
    const RAIL_MARGIN: u16 = 8;

    pub fn resistance(&self, raw: u16) -> Result<Ohms, SensorFault> {
        if raw <= Self::RAIL_MARGIN {
            Err(SensorFault::ShortCircuit)
        } else if raw >= self.full_scale - Self::RAIL_MARGIN {
            Err(SensorFault::OpenCircuit)
        } else {
            let ratio = f32::from(raw) / f32::from(self.full_scale - raw);
            Ok(Ohms(self.pull_up.0 * ratio))
        }
    }
}

pub trait Characteristic {
    /// Temperature for a resistance, if it lies within the valid range.
    fn temperature(&self, resistance: Ohms) -> Option<Celsius>;

    fn convert(&self, divider: &Divider, raw: u16) -> Result<Celsius, SensorFault> {
        let resistance = divider.resistance(raw)?;
        self.temperature(resistance).ok_or(SensorFault::OutOfRange(resistance))
    }
}

/// 1/T = a + b ln R + c (ln R)³
#[derive(Debug, Clone, Copy)]
pub struct SteinhartHart {
    a: f32,
    b: f32,
    c: f32,
}

impl SteinhartHart {
    pub const fn new(a: f32, b: f32, c: f32) -> Self {
        Self { a, b, c }
    }

    /// The two-parameter form given in most data sheets.
    pub fn from_beta(beta: f32, nominal: Ohms, at: Celsius) -> Self {
        Self { a: Kelvin::from(at).0.recip() - nominal.0.ln() / beta, b: beta.recip(), c: 0.0 }
    }
}

impl Characteristic for SteinhartHart {
    fn temperature(&self, Ohms(r): Ohms) -> Option<Celsius> {
        if r <= 0.0 {
            return None;
        }
        let ln_r = r.ln();
        let inverse = self.a + ln_r * (self.b + self.c * ln_r * ln_r);
        (inverse > 0.0).then(|| Kelvin(inverse.recip()).into())
    }
}

/// Table of the manufacturer, sorted by falling resistance.
#[derive(Debug, Clone, Copy)]
pub struct ResistanceTable<'a> {
    points: &'a [(Ohms, Celsius)],
}

impl<'a> ResistanceTable<'a> {
    pub const fn new(points: &'a [(Ohms, Celsius)]) -> Self {
        Self { points }
    }
}

impl Characteristic for ResistanceTable<'_> {
    fn temperature(&self, r: Ohms) -> Option<Celsius> {
        self.points.windows(2).find_map(|pair| {
            let [(r0, t0), (r1, t1)] = *pair else {
                return None;
            };
            (r <= r0 && r >= r1).then(|| {
                // The curve is nearly straight over the logarithm.
                let t = (r.0 / r0.0).ln() / (r1.0 / r0.0).ln();
                Celsius(t0.0 + t * (t1.0 - t0.0))
            })
        })
    }
}

/// Hottest of several sensors that share a divider type, faults excluded.
pub fn hottest(
    characteristic: &dyn Characteristic,
    divider: &Divider,
    readings: &[u16],
) -> Option<Celsius> {
    readings
        .iter()
        .filter_map(|&raw| characteristic.convert(divider, raw).ok())
        .max_by(|a, b| a.0.total_cmp(&b.0))
}
