//! A struct that derives `PartialOrd` is compared field by field, a newtype by its number.

use bessemer::prelude::*;

/// A height above the ground, m.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Height(pub f64);

/// A version of the firmware.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Version {
    /// Changes when compatibility breaks.
    pub major: u8,
    /// Changes when functions are added.
    pub minor: u8,
    /// Changes when errors are corrected.
    pub patch: u16,
}

/// Source of a message.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Source {
    /// Sent by the pilot.
    #[default]
    Pilot,
    /// Sent by the ground station.
    Ground,
}

/// Key by which messages are ordered.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Key {
    /// First criterion: the pilot's messages precede the ground's.
    pub source: Source,
    /// Second criterion.
    pub version: Version,
    /// Third criterion.
    pub numbers: [i16; 2],
}

/// Returns true if the height is below the limit, or the limit is negative.
#[function]
pub fn is_low(height: Height, limit: Height) -> bool {
    height < limit || !(limit >= Height(0.0))
}

/// The lowest of three heights.
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

/// Returns true if a message of one version can be read by another.
#[function]
pub fn is_read(one: &Version, by: &Version) -> bool {
    one <= by && one.major == by.major
}

/// The newer of two versions, and at least the first that flew.
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

/// The messages in order.
#[function]
pub fn sorted(keys: &[Key; 4]) -> [Key; 4] {
    let mut sorted = *keys;
    sorted.sort_unstable_by(|one, other| one.cmp(other));
    sorted
}

/// The index of the last message not after `limit`.
#[function]
pub fn place_of(keys: &[Key; 4], limit: Key) -> Option<usize> {
    keys.iter().rposition(|key| *key <= limit)
}

/// Compares two heights; `None` if one is a NaN.
#[function]
pub fn compared(one: Height, other: Height) -> Option<core::cmp::Ordering> {
    one.partial_cmp(&other)
}
