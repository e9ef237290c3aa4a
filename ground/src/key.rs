//! The seal on commands: a counter and a keyed checksum over the packet, as `models::gate` expects them.
//!
//! Written from the description of the packets, not with the models' code. A key is never shown: it has no `Display`,
//! and its `Debug` hides it.

use models::packet::Packet;
use sim::ground_station::{framed, unframed};
use siphasher::sip::SipHasher24;
use std::fmt;
use std::path::{Path, PathBuf};

/// A secret of 16 bytes.
#[derive(Clone, PartialEq, Eq)]
pub struct Key([u8; 16]);

impl fmt::Debug for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Key(hidden)")
    }
}

/// Why there is no key.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The file cannot be read.
    #[error("the key `{path}` cannot be read: {source}")]
    File {
        /// The file.
        path: PathBuf,
        /// An error of the system.
        source: std::io::Error,
    },
    /// The file does not hold a key.
    #[error(
        "`{path}` holds no key: it takes {} hexadecimal digits, such as `openssl rand -hex {bytes}` prints",
        2 * bytes
    )]
    Content {
        /// The file.
        path: PathBuf,
        /// Length of the key, bytes.
        bytes: usize,
    },
}

/// Reads a secret of `N` bytes from a file of hexadecimal digits.
///
/// # Errors
/// The file cannot be read, or holds something else.
pub fn secret<const N: usize>(path: &Path) -> Result<[u8; N], Error> {
    let text = std::fs::read_to_string(path)
        .map_err(|source| Error::File { path: path.to_owned(), source })?;
    digits(text.trim()).ok_or_else(|| Error::Content { path: path.to_owned(), bytes: N })
}

fn digits<const N: usize>(text: &str) -> Option<[u8; N]> {
    if text.len() != 2 * N || !text.bytes().all(|it| it.is_ascii_hexdigit()) {
        return None;
    }
    let mut bytes = [0; N];
    for (n, byte) in bytes.iter_mut().enumerate() {
        *byte = u8::from_str_radix(&text[2 * n..2 * n + 2], 16).ok()?;
    }
    Some(bytes)
}

impl Key {
    /// Creates a key from its bytes.
    pub fn new(bytes: [u8; 16]) -> Self {
        Self(bytes)
    }

    /// Reads a file of 32 hexadecimal digits.
    ///
    /// # Errors
    /// The file cannot be read, or holds something else.
    pub fn read(path: &Path) -> Result<Self, Error> {
        secret(path).map(Self)
    }

    /// The key as a line for the onboard program's standard input.
    pub(crate) fn line(&self) -> String {
        self.0.iter().map(|byte| format!("{byte:02x}")).collect()
    }

    /// The two halves of the key, for the gate of the onboard program.
    pub(crate) fn halves(&self) -> [u64; 2] {
        let all = u128::from_le_bytes(self.0);
        [all as u64, (all >> 64) as u64]
    }

    /// Adds counter and checksum to a packet; `None` if it is too long or not a packet.
    pub fn seal(&self, packet: &Packet, counter: u64) -> Option<Packet> {
        let bytes = packet.bytes.get(..packet.length)?;
        let (kind, payload) = unframed(bytes)?;
        let mut sealed = [payload, &counter.to_le_bytes()[..6]].concat();
        let size = u8::try_from(sealed.len() + 8).ok().filter(|size| *size <= 56)?;
        let summed = [&[kind, bytes[3], bytes[4], size], sealed.as_slice()].concat();
        sealed.extend(SipHasher24::new_with_key(&self.0).hash(&summed).to_le_bytes());
        Some(framed(kind, u16::from_le_bytes([bytes[3], bytes[4]]), &sealed))
    }
}
