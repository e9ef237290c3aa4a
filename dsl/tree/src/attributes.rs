//! The author's wishes for the C of an item.
//!
//! Invariant: none of it changes what is computed.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use crate::Site;

/// The author's attributes of a type, a variant, a field, a parameter or a table: `#[c(…)]`, `#[unit("…")]`, `#[range(…)]`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Given {
    /// Its name in the C, in place of the one that the tool would choose.
    pub name: Option<String>,
    /// The unit of its numbers.
    pub unit: Option<String>,
    /// The range of its numbers.
    pub range: Option<Range>,
    /// The section of the object file in which it stands.
    pub section: Option<String>,
    /// True if a constant is `pub`.
    pub public: bool,
    /// True if the author writes a constant in hexadecimal.
    pub hexadecimal: bool,
    /// Expression of a constant, or of a field in a `Default`, if it is more than a literal.
    pub expression: Option<String>,
    /// Constants by which the author writes the lengths of a field, a parameter or a result. They are ordered from the
    /// outside in, rows before columns; a length that is a number has none. In the tree they are names, in the IR
    /// paths.
    pub sizes: Vec<String>,
    /// Site of the name in the item's file; without a name, the range.
    pub site: Site,
}

/// The least and the greatest number that the author means a field or a parameter to have. It is reported to whoever sets it;
/// nothing that is computed depends on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Range {
    // The bits of two `f64`s, so that ranges are equal where they are the same.
    low: u64,
    high: u64,
}

impl Range {
    /// A range of finite numbers in order; none for others.
    pub fn new(low: f64, high: f64) -> Option<Range> {
        let sound = low.is_finite() && high.is_finite() && low <= high;
        sound.then_some(Range { low: low.to_bits(), high: high.to_bits() })
    }

    /// The least number.
    pub fn low(self) -> f64 {
        f64::from_bits(self.low)
    }

    /// The greatest number.
    pub fn high(self) -> f64 {
        f64::from_bits(self.high)
    }
}

/// The author's wishes for the C of a function.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Attributes {
    /// Its name in the C, in place of the one that the tool would choose.
    pub name: Option<String>,
    /// The section of the object file in which it stands.
    pub section: Option<String>,
    /// Inlining that compilers may do.
    pub inlining: Inlining,
    /// An entry point that leaves everything as it was if it faults.
    pub atomic: bool,
    /// An entry point that reaches no operation in double and none of 64 bits.
    #[serde(default)]
    pub single: bool,
    /// The header of a function that the firmware brings; what is in the Rust is in for it.
    pub external: Option<String>,
    /// The attributes of its parameters, each by its name in the Rust.
    #[serde(default)]
    pub parameters: Vec<(String, Given)>,
    /// The attributes of its result.
    #[serde(default)]
    pub result: Given,
}

impl Attributes {
    /// The attributes of a parameter, if it has any.
    pub fn parameter(&self, name: &str) -> Option<&Given> {
        self.parameters.iter().find(|(known, _)| known == name).map(|(_, given)| given)
    }
}

/// Inlining of a function by compilers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Inlining {
    /// As they like.
    #[default]
    Free,
    /// Never: `#[inline(never)]`.
    Never,
    /// Always: `#[inline(always)]`.
    Always,
}
