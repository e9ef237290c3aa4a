//! Author's attributes for the C of an item.
//!
//! Invariant: no computation depends on them.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use crate::Site;

/// Author's attributes of a type, a variant, a field, a parameter or a table: `#[c(…)]`, `#[unit("…")]`,
/// `#[range(…)]`, `#[axes(…)]`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Given {
    /// Name in the C, instead of the generated one.
    pub name: Option<String>,
    /// Unit of its numbers.
    pub unit: Option<String>,
    /// Range of its numbers.
    pub range: Option<Range>,
    /// Fields beside it with the points of its axes, the outer one first. In the tree and the IR they are names in Rust.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub axes: Vec<String>,
    /// Section of the object file.
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
    /// True for the variant as which a value counts in the C that is no variant.
    #[serde(default, skip_serializing_if = "core::ops::Not::not")]
    pub fallback: bool,
    /// Site of the name in the item's file; without a name, site of the range or the axes.
    pub site: Site,
}

/// Least and greatest intended number of a field or a parameter. It is documentation: what becomes of other numbers is in the
/// body of the function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Range {
    // The bits of two `f64`s, so that ranges are equal where they are the same.
    low: u64,
    high: u64,
    #[serde(default)]
    beyond: Beyond,
}

/// Meaning of a parameter outside of its range.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Beyond {
    /// The function computes with it.
    #[default]
    Taken,
    /// The nearest number of the range replaces it.
    Clamped,
    /// It is a fault.
    Reported,
}

impl Range {
    /// Returns a range with finite, ordered ends; none for others.
    pub fn new(low: f64, high: f64) -> Option<Range> {
        let sound = low.is_finite() && high.is_finite() && low <= high;
        sound.then_some(Range { low: low.to_bits(), high: high.to_bits(), beyond: Beyond::Taken })
    }

    /// Returns the range with another meaning for numbers outside of it.
    pub fn with(self, beyond: Beyond) -> Range {
        Range { beyond, ..self }
    }

    /// Returns what becomes of numbers outside of the range.
    pub fn beyond(self) -> Beyond {
        self.beyond
    }

    /// Returns true if the nearest number of the range replaces others.
    pub fn clamps(self) -> bool {
        self.beyond == Beyond::Clamped
    }

    /// Returns the range enforced in the way that a word of [`Range::enforced`] names.
    pub fn enforced_as(self, word: &str) -> Range {
        let clamps = word == "clamped";
        self.with(if clamps { Beyond::Clamped } else { Beyond::Reported })
    }

    /// Returns the word for what becomes of numbers outside of an enforced range.
    pub fn enforced(self) -> Option<&'static str> {
        match self.beyond {
            Beyond::Taken => None,
            Beyond::Clamped => Some("clamped"),
            Beyond::Reported => Some("reported"),
        }
    }

    /// Returns the least number.
    pub fn low(self) -> f64 {
        f64::from_bits(self.low)
    }

    /// Returns the greatest number.
    pub fn high(self) -> f64 {
        f64::from_bits(self.high)
    }
}

/// Author's attributes for the C of a function.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Attributes {
    /// Name in the C, instead of the generated one.
    pub name: Option<String>,
    /// Section of the object file.
    pub section: Option<String>,
    /// Requested inlining.
    pub inlining: Inlining,
    /// True for an entry point that leaves everything unchanged if it faults.
    pub atomic: bool,
    /// True for an entry point that reaches no operation in double or 64 bits.
    #[serde(default)]
    pub single: bool,
    /// Header of a function that the firmware defines; the Rust body is its stand-in.
    pub external: Option<String>,
    /// Attributes of its parameters, by their names in Rust.
    #[serde(default)]
    pub parameters: Vec<(String, Given)>,
    /// Attributes of its result.
    #[serde(default)]
    pub result: Given,
}

impl Attributes {
    /// Returns the attributes of a parameter, if it has any.
    pub fn parameter(&self, name: &str) -> Option<&Given> {
        self.parameters.iter().find(|(known, _)| known == name).map(|(_, given)| given)
    }
}

/// Inlining of a function by compilers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Inlining {
    /// The compiler decides.
    #[default]
    Free,
    /// `#[inline(never)]`.
    Never,
    /// `#[inline(always)]`.
    Always,
}
