//! Methods, associated functions and associated constants of data.

use bessemer::prelude::*;

/// A version as three numbers.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Version {
    pub major: u8,
    pub minor: u8,
    pub patch: u16,
}

#[data]
impl Version {
    /// The packed form of the first version.
    pub const FIRST: u32 = 1 << 24;

    /// Unpacks a version.
    pub fn unpacked(word: u32) -> Version {
        Version { major: (word >> 24) as u8, minor: (word >> 16) as u8, patch: word as u16 }
    }

    /// Packs a version into one word, in which versions compare correctly.
    pub fn packed(&self) -> u32 {
        u32::from(self.major) << 24 | u32::from(self.minor) << 16 | u32::from(self.patch)
    }

    /// Increments the patch number.
    pub fn patch(&mut self) {
        self.patch = self.patch.wrapping_add(1);
    }
}

/// The next patch of a packed version, and whether it is a release.
#[function]
pub fn patched(word: u32) -> [u32; 2] {
    let mut version = Version::unpacked(word);
    version.patch();
    let packed = version.packed();
    [packed, if packed >= Version::FIRST { 1 } else { 0 }]
}
