//! Bit reader and writer, most significant bit first, and a small trait for
//! records that pack themselves, as used on the 12-byte radio payload.

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BitError {
    /// Wanted more bits than there are.
    OutOfSpace { wanted: u32, left: usize },
    /// The value does not fit in the field.
    TooWide { value: u32, bits: u32 },
    /// A field holds something that is not allowed.
    Invalid,
}

/// Writes into a borrowed buffer, which is cleared as it goes.
#[derive(Debug)]
pub struct BitWriter<'a> {
    buf: &'a mut [u8],
    at: usize,
}

impl<'a> BitWriter<'a> {
    pub fn new(buf: &'a mut [u8]) -> Self {
        buf.fill(0);
        Self { buf, at: 0 }
    }

    pub fn bits_left(&self) -> usize {
        8 * self.buf.len() - self.at
    }

    pub fn put(&mut self, value: u32, bits: u32) -> Result<&mut Self, BitError> {
        if value.checked_shr(bits).unwrap_or(0) != 0 {
            return Err(BitError::TooWide { value, bits });
        }
        if self.bits_left() < bits as usize {
            return Err(BitError::OutOfSpace { wanted: bits, left: self.bits_left() });
        }
        let mut remaining = bits;
        while remaining > 0 {
            let free = 8 - (self.at % 8) as u32;
            let n = free.min(remaining);
            let chunk = value >> (remaining - n) & ((1 << n) - 1);
            self.buf[self.at / 8] |= (chunk << (free - n)) as u8;
            self.at += n as usize;
            remaining -= n;
        }
        Ok(self)
    }

    /// Two's complement in `bits` bits.
    pub fn put_signed(&mut self, value: i32, bits: u32) -> Result<&mut Self, BitError> {
        let unused = 32 - bits.clamp(1, 32);
        if value << unused >> unused != value {
            return Err(BitError::TooWide { value: value as u32, bits });
        }
        self.put((value as u32) << unused >> unused, bits)
    }

    pub fn put_bool(&mut self, flag: bool) -> Result<&mut Self, BitError> {
        self.put(flag.into(), 1)
    }

    /// Elias gamma code of `value + 1`: small numbers are short.
    pub fn put_gamma(&mut self, value: u16) -> Result<&mut Self, BitError> {
        let v = u32::from(value) + 1;
        let log = v.ilog2();
        self.put(0, log)?.put(v, log + 1)
    }

    /// The bytes written so far, the last one padded with zeros.
    pub fn finish(self) -> &'a [u8] {
        let used = self.at.div_ceil(8);
        &self.buf[..used]
    }
}

/// Reads what a [`BitWriter`] wrote.
#[derive(Clone, Debug)]
pub struct BitReader<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> BitReader<'a> {
    pub const fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0 }
    }

    pub fn bits_left(&self) -> usize {
        8 * self.bytes.len() - self.at
    }

    pub fn take(&mut self, bits: u32) -> Result<u32, BitError> {
        let left = self.bits_left();
        if left < bits as usize {
            return Err(BitError::OutOfSpace { wanted: bits, left });
        }
        let value = (self.at..self.at + bits as usize)
            .map(|i| self.bytes[i / 8] >> (7 - i % 8) & 1)
            .fold(0, |acc, bit| acc << 1 | u32::from(bit));
        self.at += bits as usize;
        Ok(value)
    }

    pub fn take_signed(&mut self, bits: u32) -> Result<i32, BitError> {
        let unused = 32 - bits.clamp(1, 32);
        self.take(bits).map(|v| (v << unused) as i32 >> unused)
    }

    pub fn take_bool(&mut self) -> Result<bool, BitError> {
        Ok(self.take(1)? == 1)
    }

    pub fn take_gamma(&mut self) -> Result<u16, BitError> {
        let mut log = 0;
        while !self.take_bool()? {
            log += 1;
        }
        if log > 16 {
            return Err(BitError::Invalid);
        }
        let rest = self.take(log)?;
        u16::try_from((1 << log | rest) - 1).map_err(|_| BitError::Invalid)
    }
}

/// A record with a bit-level layout.
pub trait Record: Sized {
    fn write(&self, w: &mut BitWriter<'_>) -> Result<(), BitError>;
    fn read(r: &mut BitReader<'_>) -> Result<Self, BitError>;
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    #[default]
    Idle,
    Survey,
    Return,
}

impl TryFrom<u32> for Mode {
    type Error = BitError;
    fn try_from(raw: u32) -> Result<Self, BitError> {
        match raw {
            0 => Ok(Self::Idle),
            1 => Ok(Self::Survey),
            2 => Ok(Self::Return),
            _ => Err(BitError::Invalid),
        }
    }
}

/// The radio's status record.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Status {
    pub mode: Mode,
    pub armed: bool,
    /// 0.1 °C, 11 bits signed.
    pub temperature: i16,
    /// Altitude over home in metres, if known.
    pub altitude: Option<u16>,
    pub packet: u16,
}

impl Record for Status {
    fn write(&self, w: &mut BitWriter<'_>) -> Result<(), BitError> {
        w.put(self.mode as u32, 2)?
            .put_bool(self.armed)?
            .put_signed(self.temperature.into(), 11)?
            .put_bool(self.altitude.is_some())?;
        if let Some(altitude) = self.altitude {
            w.put(altitude.into(), 13)?;
        }
        w.put_gamma(self.packet).map(drop)
    }

    fn read(r: &mut BitReader<'_>) -> Result<Self, BitError> {
        Ok(Self {
            mode: r.take(2)?.try_into()?,
            armed: r.take_bool()?,
            temperature: r.take_signed(11)? as i16,
            altitude: r.take_bool()?.then(|| r.take(13)).transpose()?.map(|a| a as u16),
            packet: r.take_gamma()?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_land_in_order() {
        let mut buf = [0xFF; 3];
        let mut w = BitWriter::new(&mut buf);
        w.put(0b101, 3).unwrap().put(0x3FF, 10).unwrap().put_signed(-2, 3).unwrap();
        assert_eq!(w.finish(), [0b1011_1111, 0b1111_1110]);
    }

    #[test]
    fn records_round_trip() {
        let first = Status { mode: Mode::Return, armed: true, temperature: -405, ..Default::default() };
        let second = Status { altitude: Some(4321), packet: u16::MAX, ..first };
        let mut buf = [0; 16];
        let mut w = BitWriter::new(&mut buf);
        for status in [first, second] {
            status.write(&mut w).unwrap();
        }
        let mut r = BitReader::new(w.finish());
        assert_eq!(Status::read(&mut r), Ok(first));
        assert_eq!(Status::read(&mut r), Ok(second));
        assert!(r.bits_left() < 8);
    }

    #[test]
    fn errors() {
        let mut buf = [0; 1];
        let mut w = BitWriter::new(&mut buf);
        assert_eq!(w.put(8, 3).err(), Some(BitError::TooWide { value: 8, bits: 3 }));
        assert!(w.put_signed(-5, 3).is_err());
        assert!(matches!(w.put(0, 9), Err(BitError::OutOfSpace { wanted: 9, left: 8 })));
        assert_eq!(Status::read(&mut BitReader::new(&[0xC0; 4])), Err(BitError::Invalid));
        assert!(BitReader::new(&[0; 3]).take_gamma().is_err());
    }
}
