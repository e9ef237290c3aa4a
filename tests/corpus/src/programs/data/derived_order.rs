//! A struct that derives `PartialOrd` is compared part by part, a newtype by its number.

use bessemer::prelude::*;

/// A height above the ground, m.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Height(pub f64);

/// A version of the firmware.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Version {
    /// Not compatible with another.
    pub major: u8,
    /// Adds to the last.
    pub minor: u8,
    /// Mends the last.
    pub patch: u16,
}

/// Source of a message.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Source {
    /// The pilot.
    #[default]
    Pilot,
    /// The ground.
    Ground,
}

/// Key by which messages are ordered.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Key {
    /// The pilot's before the ground's.
    pub source: Source,
    /// Then by version.
    pub version: Version,
    /// Then by two numbers.
    pub numbers: [i16; 2],
}

/// Returns true if it is too low, or the limit is none.
#[function]
pub fn is_low(height: Height, limit: Height) -> bool {
    height < limit || !(limit >= Height(0.0))
}

/// The lower of three.
#[function]
pub fn lowest(heights: [Height; 3]) -> Height {
    let mut least = heights[0];
    for height in heights {
        if height < least {
            least = height;
        }
    }
    least
}

/// Returns true if a message of one version is read by another.
#[function]
pub fn is_read(one: &Version, by: &Version) -> bool {
    one <= by && one.major == by.major
}

/// The newer of the two, and at least the first that flew.
#[function]
pub fn newer(one: Version, other: Version) -> Version {
    let first = Version { major: 1, minor: 2, patch: 0 };
    one.max(other).clamp(first, Version { major: u8::MAX, ..first })
}

/// Order of two messages.
#[function]
pub fn order(one: &Key, other: &Key) -> core::cmp::Ordering {
    one.cmp(other).reverse()
}

/// The messages in their order.
#[function]
pub fn sorted(keys: &[Key; 4]) -> [Key; 4] {
    let mut sorted = *keys;
    sorted.sort_unstable_by(|one, other| one.cmp(other));
    sorted
}

/// The place of the last that is not behind `limit`.
#[function]
pub fn place_of(keys: &[Key; 4], limit: Key) -> Option<usize> {
    keys.iter().rposition(|key| *key <= limit)
}

/// A NaN has no place.
#[function]
pub fn compared(one: Height, other: Height) -> Option<core::cmp::Ordering> {
    one.partial_cmp(&other)
}
