//! Texts of bounded length: an array of bytes, and the number of bytes in use.
//!
//! Written in the DSL itself. Exceeding the capacity is a panic, and a fault in the C. Bytes beyond the length are
//! zero, so that texts can be compared field by field, and C finds a terminating zero unless the text is full.

// The checks of indices are proved of loops over them.
#![allow(clippy::manual_memcpy, clippy::needless_range_loop)]

use crate::data;

/// A text of at most `N` bytes.
///
/// ```
/// use bessemer::Text;
/// let mut name: Text<8> = Text::of(b"motor");
/// name.push(b'2');
/// assert!(name.is(b"motor2") && name.len() == 6 && name != Text::of(b"motor"));
/// ```
#[data]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Text<const N: usize> {
    /// Number of bytes.
    length: usize,
    /// The bytes; zero beyond the length.
    bytes: [u8; N],
}

#[data]
impl<const N: usize> Text<N> {
    /// An empty text.
    pub const fn new() -> Self {
        Text { length: 0, bytes: [0; N] }
    }

    /// The text of these bytes, as in `Text::of(b"motor")`.
    ///
    /// # Panics
    ///
    /// If they exceed the capacity.
    pub fn of(bytes: &[u8]) -> Self {
        crate::__room!(bytes.len() <= N);
        let mut text = Text { length: bytes.len(), bytes: [0; N] };
        for i in 0..bytes.len() {
            text.bytes[i] = bytes[i];
        }
        text
    }

    /// Number of bytes.
    pub fn len(&self) -> usize {
        self.length.min(N)
    }

    /// Returns true if the text has no bytes.
    pub fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// Largest number of bytes.
    pub fn capacity(&self) -> usize {
        N
    }

    /// The whole array of bytes; those beyond the length are zero.
    pub fn bytes(&self) -> [u8; N] {
        self.bytes
    }

    /// The byte at an index; `None` beyond the length.
    pub fn get(&self, index: usize) -> Option<u8> {
        if index < self.length.min(N) { Some(self.bytes[index]) } else { None }
    }

    /// Adds a byte at the end.
    ///
    /// # Panics
    /// If the text is full.
    pub fn push(&mut self, byte: u8) {
        crate::__room!(self.length < N);
        self.bytes[self.length] = byte;
        self.length += 1;
    }

    /// Removes and returns the last byte.
    pub fn pop(&mut self) -> Option<u8> {
        if self.length == 0 || self.length > N {
            return None;
        }
        self.length -= 1;
        let last = self.bytes[self.length];
        self.bytes[self.length] = 0;
        Some(last)
    }

    /// Appends bytes.
    ///
    /// # Panics
    ///
    /// If they exceed the capacity.
    pub fn append(&mut self, bytes: &[u8]) {
        crate::__room!(self.length <= N && bytes.len() <= N - self.length);
        for i in 0..bytes.len() {
            self.bytes[self.length] = bytes[i];
            self.length += 1;
        }
    }

    /// Shortens the text to `length` bytes; a shorter text stays as it is.
    pub fn truncate(&mut self, length: usize) {
        if length < self.length {
            for index in length..N {
                self.bytes[index] = 0;
            }
            self.length = length;
        }
    }

    /// Removes all bytes.
    pub fn clear(&mut self) {
        self.length = 0;
        self.bytes = [0; N];
    }

    /// Returns true if the text consists of these bytes, as in `name.is(b"motor")`.
    pub fn is(&self, bytes: &[u8]) -> bool {
        self.length == bytes.len() && self.starts_with(bytes)
    }

    /// Returns true if the text begins with these bytes.
    pub fn starts_with(&self, bytes: &[u8]) -> bool {
        if bytes.len() > self.length.min(N) {
            return false;
        }
        for i in 0..bytes.len() {
            if self.bytes[i] != bytes[i] {
                return false;
            }
        }
        true
    }
}

impl<const N: usize> Default for Text<N> {
    fn default() -> Self {
        Text { length: 0, bytes: [0; N] }
    }
}
