//! Packing of physical signals into CAN payloads the way a DBC file describes
//! them: start bit, length, byte order, sign, scale and offset.

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ByteOrder {
    /// Start bit is the least significant one, bits count upwards.
    Intel,
    /// Start bit is the most significant one, in the DBC's saw-tooth numbering.
    Motorola,
}

/// Description of one signal; make it with the `const` builder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Signal {
    start: u8,
    len: u8,
    order: ByteOrder,
    signed: bool,
    scale: f64,
    offset: f64,
}

/// Payload of a classic CAN frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Payload(pub [u8; 8]);

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PackError {
    OutOfRange { min: f64, max: f64 },
    NotANumber,
}

impl Signal {
    pub const fn intel(start: u8, len: u8) -> Self {
        assert!(len >= 1 && start as usize + len as usize <= 64);
        Self { start, len, order: ByteOrder::Intel, signed: false, scale: 1.0, offset: 0.0 }
    }

    pub const fn motorola(start: u8, len: u8) -> Self {
        let signal =
            Self { start, len, order: ByteOrder::Motorola, signed: false, scale: 1.0, offset: 0.0 };
        assert!(len >= 1 && signal.msb_index() as usize + len as usize <= 64);
        signal
    }

    pub const fn signed(self) -> Self {
        Self { signed: true, ..self }
    }

    pub const fn scaled(self, scale: f64, offset: f64) -> Self {
        Self { scale, offset, ..self }
    }

    const fn mask(&self) -> u64 {
        u64::MAX >> (64 - self.len)
    }

    /// Distance of the start bit from the top of the big-endian payload.
    const fn msb_index(&self) -> u8 {
        self.start / 8 * 8 + 7 - self.start % 8
    }

    const fn shift(&self) -> u32 {
        match self.order {
            ByteOrder::Intel => self.start as u32,
            ByteOrder::Motorola => 64 - self.msb_index() as u32 - self.len as u32,
        }
    }

    fn raw_limits(&self) -> (f64, f64) {
        match self.mask() {
            mask if self.signed => (-((mask / 2) as f64) - 1.0, (mask / 2) as f64),
            mask => (0.0, mask as f64),
        }
    }

    fn to_physical(&self, raw: f64) -> f64 {
        raw * self.scale + self.offset
    }
}

impl Payload {
    fn word(&self, order: ByteOrder) -> u64 {
        match order {
            ByteOrder::Intel => u64::from_le_bytes(self.0),
            ByteOrder::Motorola => u64::from_be_bytes(self.0),
        }
    }

    /// Reads a signal in physical units.
    pub fn get(&self, signal: &Signal) -> f64 {
        let raw = self.word(signal.order) >> signal.shift() & signal.mask();
        let value = if signal.signed {
            // Sign-extend by shifting up and back.
            let unused = 64 - u32::from(signal.len);
            ((raw << unused) as i64 >> unused) as f64
        } else {
            raw as f64
        };
        signal.to_physical(value)
    }

    /// Writes a signal, rounding to the nearest raw value.
    pub fn set(&mut self, signal: &Signal, value: f64) -> Result<&mut Self, PackError> {
        let raw = ((value - signal.offset) / signal.scale).round();
        if raw.is_nan() {
            return Err(PackError::NotANumber);
        }
        let (low, high) = signal.raw_limits();
        if !(low..=high).contains(&raw) {
            let (a, b) = (signal.to_physical(low), signal.to_physical(high));
            return Err(PackError::OutOfRange { min: a.min(b), max: a.max(b) });
        }
        let raw = if signal.signed { raw as i64 as u64 } else { raw as u64 };
        let bits = (raw & signal.mask()) << signal.shift();
        let kept = self.word(signal.order) & !(signal.mask() << signal.shift());
        self.0 = match signal.order {
            ByteOrder::Intel => (kept | bits).to_le_bytes(),
            ByteOrder::Motorola => (kept | bits).to_be_bytes(),
        };
        Ok(self)
    }

    /// As `set`, but values out of range go to the nearest end.
    pub fn set_clamped(&mut self, signal: &Signal, value: f64) -> &mut Self {
        let limited = match self.set(signal, value) {
            Err(PackError::OutOfRange { min, max }) => value.clamp(min, max),
            _ => return self,
        };
        // The ends themselves are always in range.
        let _ = self.set(signal, limited);
        self
    }
}

/// The drive status message of the inverter.
pub mod drive_status {
    use super::{PackError, Payload, Signal};

    pub const SPEED_RPM: Signal = Signal::intel(0, 16).signed().scaled(0.5, 0.0);
    pub const TORQUE_NM: Signal = Signal::motorola(23, 12).signed().scaled(0.1, 0.0);
    pub const TEMPERATURE_C: Signal = Signal::intel(40, 8).scaled(1.0, -40.0);
    pub const COUNTER: Signal = Signal::intel(60, 4);

    pub fn encode(rpm: f64, torque: f64, celsius: f64, n: u8) -> Result<Payload, PackError> {
        let mut p = Payload::default();
        p.set(&SPEED_RPM, rpm)?
            .set(&TORQUE_NM, torque)?
            .set_clamped(&TEMPERATURE_C, celsius)
            .set(&COUNTER, f64::from(n & 0xF))?;
        Ok(p)
    }
}

#[cfg(test)]
mod tests {
    use super::drive_status::*;
    use super::*;

    #[test]
    fn known_bytes() {
        let p = encode(-100.0, 25.6, 60.0, 5).unwrap();
        // -200 little-endian, 256 in the upper 12 bits of bytes 2..4.
        assert_eq!(p.0, [0x38, 0xFF, 0x10, 0x00, 0, 100, 0, 0x50]);
    }

    #[test]
    fn round_trip_keeps_neighbours() {
        let mut p = encode(1234.5, -204.8, 300.0, 15).unwrap();
        assert_eq!(p.get(&TEMPERATURE_C), 215.0);
        p.set(&TORQUE_NM, 204.7).unwrap();
        assert_eq!((p.get(&SPEED_RPM), p.get(&COUNTER)), (1234.5, 15.0));
        assert!((p.get(&TORQUE_NM) - 204.7).abs() < 1e-9);
    }

    #[test]
    fn range_is_checked() {
        let mut p = Payload::default();
        assert_eq!(p.set(&COUNTER, 16.0), Err(PackError::OutOfRange { min: 0.0, max: 15.0 }));
        assert!(matches!(p.set(&SPEED_RPM, f64::NAN), Err(PackError::NotANumber)));
        assert_eq!(p, Payload::default());
        let wide = Signal::motorola(7, 64);
        assert_eq!(p.set(&wide, 1.0).unwrap().0, [0, 0, 0, 0, 0, 0, 0, 1]);
    }
}
