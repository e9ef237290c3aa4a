//! Consistent overhead byte stuffing: encoder as an iterator over the stuffed
//! bytes, decoder fed byte by byte from the UART interrupt.

/// Byte between frames; never occurs inside one.
pub const DELIMITER: u8 = 0;

/// Largest encoded size of `len` payload bytes, delimiter included.
pub const fn max_encoded_len(len: usize) -> usize {
    len + len / 254 + 2
}

/// Iterator over the encoded bytes of a frame, ending with the delimiter.
#[derive(Clone, Debug)]
pub struct Encoder<'a> {
    rest: &'a [u8],
    /// Bytes of the present block still to be copied.
    block: &'a [u8],
    phase: Phase,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    Code,
    Copy { more: bool },
    Finished,
}

impl<'a> Encoder<'a> {
    const MAX_RUN: usize = 254;

    pub fn new(payload: &'a [u8]) -> Self {
        Self { rest: payload, block: &[], phase: Phase::Code }
    }

    /// Cuts the next block off the rest and returns its code byte.
    fn next_block(&mut self) -> u8 {
        let window = &self.rest[..self.rest.len().min(Self::MAX_RUN)];
        let run = window.iter().position(|&b| b == DELIMITER);
        let (len, consumed, more) = match run {
            Some(at) => (at, at + 1, true),
            None if window.len() == Self::MAX_RUN => {
                (Self::MAX_RUN, Self::MAX_RUN, self.rest.len() > Self::MAX_RUN)
            }
            None => (window.len(), window.len(), false),
        };
        self.block = &self.rest[..len];
        self.rest = &self.rest[consumed..];
        self.phase = Phase::Copy { more };
        len as u8 + 1
    }
}

impl Iterator for Encoder<'_> {
    type Item = u8;

    fn next(&mut self) -> Option<u8> {
        match (self.phase, self.block) {
            (Phase::Code, _) => Some(self.next_block()),
            (Phase::Copy { .. }, [first, tail @ ..]) => {
                self.block = tail;
                Some(*first)
            }
            (Phase::Copy { more: true }, []) => Some(self.next_block()),
            (Phase::Copy { more: false }, []) => {
                self.phase = Phase::Finished;
                Some(DELIMITER)
            }
            (Phase::Finished, _) => None,
        }
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = self.rest.len() + self.block.len();
        (left, Some(max_encoded_len(left)))
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CobsError {
    /// The delimiter came in the middle of a block.
    Truncated,
    /// Frame longer than the buffer.
    TooLong,
}

/// Decoder with room for `N` payload bytes.
#[derive(Clone, Debug)]
pub struct Decoder<const N: usize> {
    buf: [u8; N],
    len: usize,
    /// Bytes left in the present block.
    left: u8,
    /// A zero is owed before the next block.
    zero_due: bool,
    overflow: bool,
}

impl<const N: usize> Decoder<N> {
    pub const fn new() -> Self {
        Self { buf: [0; N], len: 0, left: 0, zero_due: false, overflow: false }
    }

    /// Feeds one byte; on a delimiter gives the payload of the frame.
    pub fn push(&mut self, byte: u8) -> Option<Result<&[u8], CobsError>> {
        match byte {
            DELIMITER => return self.finish(),
            b if self.left > 0 => {
                self.left -= 1;
                self.store(b);
            }
            code => {
                if core::mem::replace(&mut self.zero_due, code != 0xFF) {
                    self.store(0);
                }
                self.left = code - 1;
            }
        }
        None
    }

    fn store(&mut self, b: u8) {
        match self.buf.get_mut(self.len) {
            Some(slot) => {
                *slot = b;
                self.len += 1;
            }
            None => self.overflow = true,
        }
    }

    fn finish(&mut self) -> Option<Result<&[u8], CobsError>> {
        let Self { len, left, zero_due, overflow, .. } = *self;
        (self.len, self.left, self.zero_due, self.overflow) = (0, 0, false, false);
        match (left, overflow) {
            // Idle delimiters between frames.
            (0, false) if len == 0 && !zero_due => None,
            (_, true) => Some(Err(CobsError::TooLong)),
            (0, false) => Some(Ok(&self.buf[..len])),
            _ => Some(Err(CobsError::Truncated)),
        }
    }
}

impl<const N: usize> Default for Decoder<N> {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_vectors() {
        assert!(Encoder::new(&[]).eq([1, 0]));
        assert!(Encoder::new(&[0]).eq([1, 1, 0]));
        assert!(Encoder::new(&[0x11, 0x22, 0, 0x33]).eq([3, 0x11, 0x22, 2, 0x33, 0]));
    }

    #[test]
    fn round_trip_of_all_lengths() {
        let mut data = [0_u8; 600];
        data.iter_mut().enumerate().for_each(|(i, b)| *b = (i * i / 7 % 300).min(255) as u8);
        let ones = [1_u8; 600];
        let mut dec = Decoder::<600>::new();
        for payload in (0..600).flat_map(|n| [&data[..n], &ones[..n]]) {
            let encoded = Encoder::new(payload);
            assert!(encoded.clone().count() <= max_encoded_len(payload.len()));
            let mut matches = 0;
            for b in encoded {
                if let Some(frame) = dec.push(b) {
                    assert_eq!(frame, Ok(payload));
                    matches += 1;
                }
            }
            assert_eq!(matches, 1, "{}", payload.len());
        }
    }

    #[test]
    fn errors_do_not_stick() {
        let mut dec = Decoder::<2>::default();
        for b in [5, 1, 2] {
            assert!(dec.push(b).is_none());
        }
        assert_eq!(dec.push(0), Some(Err(CobsError::Truncated)));
        assert_eq!([4, 1, 2, 3].iter().filter(|&&b| dec.push(b).is_some()).count(), 0);
        assert_eq!(dec.push(0), Some(Err(CobsError::TooLong)));
        assert_eq!(dec.push(0), None);
        [2, 9].iter().for_each(|&b| assert!(dec.push(b).is_none()));
        assert_eq!(dec.push(0), Some(Ok(&[9][..])));
    }
}
