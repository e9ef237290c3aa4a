//! Bytes of a flight log that are still to be read, with their place in the file. Numbers are little-endian.
//!
//! Invariant: no input panics.

/// The rest of a file or of a part of it.
#[derive(Clone, Copy)]
pub(super) struct Bytes<'b> {
    rest: &'b [u8],
    /// Offset of the rest in the file.
    pub at: usize,
}

impl<'b> Bytes<'b> {
    pub fn new(file: &'b [u8]) -> Bytes<'b> {
        Bytes { rest: file, at: 0 }
    }

    pub fn rest(&self) -> &'b [u8] {
        self.rest
    }

    pub fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    /// The next bytes; none, and nothing is read, if there are fewer.
    pub fn take(&mut self, count: usize) -> Option<&'b [u8]> {
        let taken = self.rest.split_off(..count)?;
        self.at += count;
        Some(taken)
    }

    /// The next bytes, with their place.
    pub fn part(&mut self, count: usize) -> Option<Bytes<'b>> {
        let at = self.at;
        self.take(count).map(|rest| Bytes { rest, at })
    }

    pub fn array<const N: usize>(&mut self) -> Option<[u8; N]> {
        self.take(N)?.try_into().ok()
    }

    pub fn u8(&mut self) -> Option<u8> {
        self.array().map(u8::from_le_bytes)
    }

    pub fn u16(&mut self) -> Option<u16> {
        self.array().map(u16::from_le_bytes)
    }

    pub fn u64(&mut self) -> Option<u64> {
        self.array().map(u64::from_le_bytes)
    }
}

/// A number of a log, of which no bit is lost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Number {
    Int(i64),
    Whole(u64),
    Float(f64),
}

impl Number {
    /// The text that reads back to the same number.
    pub fn text(self) -> String {
        match self {
            Number::Int(number) => number.to_string(),
            Number::Whole(number) => number.to_string(),
            Number::Float(number) => format!("{number:?}"),
        }
    }

    /// The nearest `f64`.
    pub fn float(self) -> f64 {
        match self {
            Number::Int(number) => number as f64,
            Number::Whole(number) => number as f64,
            Number::Float(number) => number,
        }
    }
}

/// A type of numbers in a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F16,
    F32,
    F64,
}

impl Kind {
    /// Reads a number.
    pub fn read(self, bytes: &mut Bytes<'_>) -> Option<Number> {
        Some(match self {
            Kind::I8 => Number::Int(i8::from_le_bytes(bytes.array()?).into()),
            Kind::U8 => Number::Int(bytes.u8()?.into()),
            Kind::I16 => Number::Int(i16::from_le_bytes(bytes.array()?).into()),
            Kind::U16 => Number::Int(bytes.u16()?.into()),
            Kind::I32 => Number::Int(i32::from_le_bytes(bytes.array()?).into()),
            Kind::U32 => Number::Int(u32::from_le_bytes(bytes.array()?).into()),
            Kind::I64 => Number::Int(i64::from_le_bytes(bytes.array()?)),
            Kind::U64 => Number::Whole(bytes.u64()?),
            Kind::F16 => Number::Float(half(bytes.u16()?)),
            Kind::F32 => Number::Float(f32::from_le_bytes(bytes.array()?).into()),
            Kind::F64 => Number::Float(f64::from_le_bytes(bytes.array()?)),
        })
    }
}

/// The value of a number in half precision (IEEE 754 binary16).
fn half(bits: u16) -> f64 {
    let (exponent, fraction) = (i32::from(bits >> 10 & 0x1f), f64::from(bits & 0x3ff));
    let size = match exponent {
        0 => fraction * 2.0_f64.powi(-24),
        31 if fraction == 0.0 => f64::INFINITY,
        31 => f64::NAN,
        _ => (1024.0 + fraction) * 2.0_f64.powi(exponent - 25),
    };
    if bits & 0x8000 == 0 { size } else { -size }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_are_what_ieee_754_says() {
        let cases = [
            (0x3c00, 1.0),
            (0xc000, -2.0),
            (0x7bff, 65504.0),
            (0x0001, 2.0_f64.powi(-24)),
            (0x0400, 2.0_f64.powi(-14)),
            (0x7c00, f64::INFINITY),
            (0x3555, 0.333251953125),
        ];
        for (bits, expected) in cases {
            assert_eq!(half(bits), expected, "{bits:04x}");
        }
        assert!(half(0x7e00).is_nan() && half(0x8000).is_sign_negative());
    }

    #[test]
    fn short_bytes_are_not_read() {
        let mut bytes = Bytes::new(&[1, 2, 3]);
        assert_eq!((Kind::U32.read(&mut bytes), bytes.at), (None, 0));
        assert_eq!((Kind::U16.read(&mut bytes), bytes.at), (Some(Number::Int(0x201)), 2));
    }
}
