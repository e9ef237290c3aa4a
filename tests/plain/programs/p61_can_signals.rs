//! Packing and unpacking of CAN signals described by a table, with the bit
//! numbering used in DBC files.

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ByteOrder {
    /// `start_bit` is the least significant bit.
    Intel,
    /// `start_bit` is the most significant bit.
    Motorola,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SignalError {
    Unknown,
    OutOfRange,
    DoesNotFit,
}

#[derive(Debug, Clone, Copy)]
pub struct Signal {
    pub name: &'static str,
    pub start_bit: u8,
    pub length: u8,
    pub order: ByteOrder,
    pub signed: bool,
    pub scale: f64,
    pub offset: f64,
}

impl Signal {
    pub const fn unsigned(name: &'static str, start_bit: u8, length: u8) -> Self {
        Self {
            name,
            start_bit,
            length,
            order: ByteOrder::Intel,
            signed: false,
            scale: 1.0,
            offset: 0.0,
        }
    }

    pub const fn signed(self) -> Self {
        Self { signed: true, ..self }
    }

    pub const fn motorola(self) -> Self {
        Self { order: ByteOrder::Motorola, ..self }
    }

    pub const fn scaled(self, scale: f64, offset: f64) -> Self {
        Self { scale, offset, ..self }
    }

    const fn mask(&self) -> u64 {
        u64::MAX >> (64 - self.length)
    }

    /// Position of the lowest bit when the payload is read in the byte order.
    fn shift(&self) -> Result<u32, SignalError> {
        let start = u32::from(self.start_bit);
        let length = u32::from(self.length);
        let shift = match self.order {
            ByteOrder::Intel => (start + length <= 64).then_some(start),
            ByteOrder::Motorola => {
                let from_top = (start / 8) * 8 + (7 - start % 8);
                64u32.checked_sub(from_top + length)
            }
        };
        shift.ok_or(SignalError::DoesNotFit)
    }

    fn load(&self, payload: &[u8; 8]) -> u64 {
        match self.order {
            ByteOrder::Intel => u64::from_le_bytes(*payload),
            ByteOrder::Motorola => u64::from_be_bytes(*payload),
        }
    }

    fn store(&self, bits: u64) -> [u8; 8] {
        match self.order {
            ByteOrder::Intel => bits.to_le_bytes(),
            ByteOrder::Motorola => bits.to_be_bytes(),
        }
    }

    pub fn decode(&self, payload: &[u8; 8]) -> Result<f64, SignalError> {
        let raw = (self.load(payload) >> self.shift()?) & self.mask();
        let number = if self.signed {
            let unused = 64 - u32::from(self.length);
            ((raw << unused) as i64 >> unused) as f64
        } else {
            raw as f64
        };
        Ok(number * self.scale + self.offset)
    }

    pub fn encode(&self, payload: &mut [u8; 8], value: f64) -> Result<(), SignalError> {
        let shift = self.shift()?;
        let scaled = (value - self.offset) / self.scale;
        let number = (scaled + 0.5f64.copysign(scaled)) as i64;
        let (min, max) = if self.signed {
            let half = (self.mask() >> 1) as i64;
            (-half - 1, half)
        } else {
            (0, i64::try_from(self.mask()).unwrap_or(i64::MAX))
        };
        if !(min..=max).contains(&number) {
            return Err(SignalError::OutOfRange);
        }
        let kept = self.load(payload) & !(self.mask() << shift);
        *payload = self.store(kept | (number as u64 & self.mask()) << shift);
        Ok(())
    }
}

/// A message layout, the signals it carries.
#[derive(Debug, Clone, Copy)]
pub struct Message<'a> {
    pub signals: &'a [Signal],
}

impl Message<'_> {
    pub fn signal(&self, name: &str) -> Result<&Signal, SignalError> {
        self.signals.iter().find(|s| s.name == name).ok_or(SignalError::Unknown)
    }

    /// Builds a payload from name and value pairs, unnamed signals are zero.
    pub fn build<'v>(
        &self,
        values: impl IntoIterator<Item = (&'v str, f64)>,
    ) -> Result<[u8; 8], SignalError> {
        values.into_iter().try_fold([0; 8], |mut payload, (name, value)| {
            self.signal(name)?.encode(&mut payload, value)?;
            Ok(payload)
        })
    }

    pub fn values<'s>(&'s self, payload: &'s [u8; 8]) -> impl Iterator<Item = (&'s str, f64)> {
        self.signals.iter().filter_map(|signal| Some((signal.name, signal.decode(payload).ok()?)))
    }
}
