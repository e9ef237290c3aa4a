//! `Default` is evaluated when the C is generated, and becomes a constant.

use bessemer::prelude::*;

/// Settings of a filter.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Weight of the new value, 0 to 1.
    pub share: f64,
    /// Values to wait for.
    pub count: u16,
    pub on: bool,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings { share: 0.25, count: 100, on: true }
    }
}

/// Settings for a fast filter.
#[function]
pub fn fast(share: f64) -> Settings {
    Settings { share, ..Default::default() }
}
