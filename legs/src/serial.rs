//! Frames of words over a serial line; an incomplete or damaged frame is an error.
//!
//! A word is sent as the number of its significant bytes and these bytes, least significant first. A frame is words
//! and a CRC-32 of their bytes, encoded without zeros (COBS) and terminated by a zero. `c/link/link.c` is the other
//! end.
//!
//! Invariant: it never waits for longer than the line's timeout. What it must not know: the meaning of the words.

use std::io::{self, Read, Write};

/// Largest number of bytes of a frame, more than any board sends.
const MOST: usize = 1 << 16;

/// Reason why a frame could not be sent or received.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The other end closed the line.
    #[error("the line is closed: the other end is gone")]
    Closed,
    /// The other end does not answer.
    #[error("nothing comes over the line: the other end does not run, or at another speed")]
    Silent,
    /// The received bytes are not a valid frame.
    #[error("what came over the line is garbled: {0}")]
    Garbled(&'static str),
    /// The error of the system.
    #[error("the line: {0}")]
    System(io::Error),
}

impl From<io::Error> for Error {
    fn from(error: io::Error) -> Self {
        use io::ErrorKind::{BrokenPipe, ConnectionReset, TimedOut, UnexpectedEof, WouldBlock};
        match error.kind() {
            BrokenPipe | ConnectionReset | UnexpectedEof => Self::Closed,
            TimedOut | WouldBlock => Self::Silent,
            _ => Self::System(error),
        }
    }
}

/// Packs bytes into words of a frame: their number, and then eight bytes in a word, least significant first.
pub fn packed(bytes: &[u8]) -> impl Iterator<Item = u64> {
    let word = |some: &[u8]| some.iter().rev().fold(0, |word, byte| word << 8 | u64::from(*byte));
    std::iter::once(bytes.len() as u64).chain(bytes.chunks(8).map(word))
}

/// Unpacks bytes from such words; `None` if the words are not in that form.
pub fn unpacked(words: &[u64]) -> Option<Vec<u8>> {
    let (count, words) = words.split_first()?;
    let count = usize::try_from(*count).ok()?;
    let mut bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    let whole = count.div_ceil(8) == words.len();
    bytes.truncate(count);
    whole.then_some(bytes)
}

/// A serial line for frames in both directions. Its timeouts are those of the line's reads.
#[derive(Debug)]
pub struct Serial<L> {
    line: L,
    buffer: Vec<u8>,
}

impl<L: Read + Write> Serial<L> {
    /// Creates a serial line for frames.
    pub fn new(line: L) -> Self {
        Self { line, buffer: Vec::new() }
    }

    /// Returns the underlying line.
    pub fn line(&mut self) -> &mut L {
        &mut self.line
    }

    /// Sends a frame.
    ///
    /// # Errors
    ///
    /// The line did not accept it.
    pub fn send(&mut self, words: &[u64]) -> Result<(), Error> {
        self.line.write_all(&framed(words))?;
        Ok(self.line.flush()?)
    }

    /// Waits for a frame.
    ///
    /// # Errors
    ///
    /// No frame was received, or an invalid one.
    pub fn receive(&mut self) -> Result<Vec<u64>, Error> {
        loop {
            while let Some(end) = self.buffer.iter().position(|byte| *byte == 0) {
                let frame: Vec<u8> = self.buffer.drain(..=end).take(end).collect();
                // Zeros before a frame say nothing.
                if !frame.is_empty() {
                    return words(&frame);
                }
            }
            if self.buffer.len() > MOST {
                return Err(Error::Garbled("it does not end"));
            }
            let mut some = [0; 4096];
            match self.line.read(&mut some) {
                Ok(0) => return Err(Error::Closed),
                Ok(count) => self.buffer.extend_from_slice(&some[..count]),
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(error.into()),
            }
        }
    }
}

/// Encodes words as the bytes of a frame.
fn framed(words: &[u64]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(2 * words.len());
    for word in words {
        let count = 8 - word.leading_zeros() as usize / 8;
        bytes.push(count as u8);
        bytes.extend_from_slice(&word.to_le_bytes()[..count]);
    }
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    let mut stuffed = cobs::encode_vec(&bytes);
    stuffed.push(0);
    stuffed
}

/// Decodes a frame without the zero at its end.
fn words(frame: &[u8]) -> Result<Vec<u64>, Error> {
    let bytes = cobs::decode_vec(frame).map_err(|_| Error::Garbled("it is cut short"))?;
    let (content, sum) = bytes.split_last_chunk().ok_or(Error::Garbled("it is cut short"))?;
    if u32::from_le_bytes(*sum) != crc32fast::hash(content) {
        return Err(Error::Garbled("its checksum is wrong"));
    }
    let (mut words, mut rest) = (Vec::new(), content);
    while let Some((count, behind)) = rest.split_first() {
        let count = usize::from(*count);
        let word = behind.get(..count).filter(|_| count <= 8);
        let word = word.ok_or(Error::Garbled("it holds what is no word"))?;
        words.push(word.iter().rev().fold(0, |all, byte| all << 8 | u64::from(*byte)));
        rest = &behind[count..];
    }
    Ok(words)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// Test line: bytes to read, and bytes written.
    struct Line(Vec<u8>, Vec<u8>);

    impl Read for Line {
        fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
            let count = to.len().min(self.0.len()).min(7);
            to[..count].copy_from_slice(&self.0[..count]);
            self.0.drain(..count);
            Ok(count)
        }
    }

    impl Write for Line {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.1.extend_from_slice(bytes);
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    fn received(bytes: Vec<u8>) -> Result<Vec<u64>, Error> {
        Serial::new(Line(bytes, Vec::new())).receive()
    }

    #[test]
    fn the_checksum_is_that_of_the_standard() {
        assert_eq!(crc32fast::hash(b"123456789"), 0xCBF4_3926);
    }

    #[test]
    fn what_goes_in_comes_out() {
        let mut random = Random(7);
        for length in (0..40).chain([61, 62, 63, 64, 300]) {
            for shift in [0, 8, 31, 56, 63] {
                let sent: Vec<u64> = (0..length).map(|_| random.bits() >> shift).collect();
                let bytes = framed(&sent);
                assert!(!bytes[..bytes.len() - 1].contains(&0));
                let noise = [vec![0, 0], bytes, vec![9]].concat();
                assert_eq!(received(noise).expect("a frame"), sent);
            }
        }
    }

    #[test]
    fn bytes_come_out_as_they_went_in() {
        for length in [0, 1, 7, 8, 9, 64, 1000] {
            let bytes: Vec<u8> = (0..length).map(|n| n as u8).collect();
            let words: Vec<u64> = packed(&bytes).collect();
            assert_eq!(unpacked(&words), Some(bytes));
            assert_eq!(unpacked(&[&words[..], &[1]].concat()), None);
        }
        assert_eq!(unpacked(&[]), None);
        assert_eq!(unpacked(&[u64::MAX, 1]), None);
    }

    /// The end of a full block adds no zero, even next to zeros.
    #[test]
    fn full_blocks_are_taken_apart() {
        for before in 25..36 {
            for zeros in 0..3 {
                let mut sent = vec![u64::MAX; before];
                sent.extend(vec![0; zeros]);
                sent.extend(vec![u64::MAX; 32]);
                assert_eq!(received(framed(&sent)).expect("a frame"), sent);
            }
        }
    }

    #[test]
    fn no_bit_is_lost_in_silence() {
        let sent = [0, 1, 0x1234_5678, u64::MAX, 0x00FF_0000_0000_00FF];
        let bytes = framed(&sent);
        for place in 0..8 * bytes.len() {
            let mut garbled = bytes.clone();
            garbled[place / 8] ^= 1 << (place % 8);
            let wrong = received(garbled);
            assert!(matches!(wrong, Err(Error::Garbled(_) | Error::Closed)), "{place}: {wrong:?}");
        }
    }

    #[test]
    fn the_end_is_told() {
        let cut = framed(&[5; 9])[..7].to_vec();
        assert!(matches!(received(cut), Err(Error::Closed)));
        assert!(matches!(received(vec![3; MOST + 8192]), Err(Error::Garbled(_))));
        let error = |kind: io::ErrorKind| Error::from(io::Error::from(kind)).to_string();
        assert!(error(io::ErrorKind::WouldBlock).starts_with("nothing comes"));
        assert!(error(io::ErrorKind::BrokenPipe).starts_with("the line is closed"));
    }
}
