//! Scalar types, their ranges, and their representation as 64-bit words.
//!
//! All values are exchanged as *words* (constants, the interpreter, a C process): a float is its bits, zero-extended;
//! an integer is sign- or zero-extended; `bool` is 0 or 1.

use serde::{Deserialize, Serialize};

/// An integer type. `usize` and `isize` are 64 bits wide on every target, as in the simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[allow(missing_docs)]
pub enum Int {
    I8,
    I16,
    I32,
    I64,
    Isize,
    U8,
    U16,
    U32,
    U64,
    Usize,
}

impl Int {
    /// All integer types.
    pub const ALL: [Int; 10] = [
        Int::I8,
        Int::I16,
        Int::I32,
        Int::I64,
        Int::Isize,
        Int::U8,
        Int::U16,
        Int::U32,
        Int::U64,
        Int::Usize,
    ];

    /// Returns the width in bits.
    pub const fn bits(self) -> u32 {
        match self {
            Int::I8 | Int::U8 => 8,
            Int::I16 | Int::U16 => 16,
            Int::I32 | Int::U32 => 32,
            Int::I64 | Int::U64 | Int::Isize | Int::Usize => 64,
        }
    }

    /// Returns true for a signed type.
    pub const fn signed(self) -> bool {
        matches!(self, Int::I8 | Int::I16 | Int::I32 | Int::I64 | Int::Isize)
    }

    /// Returns the unsigned type of this width.
    pub const fn unsigned(self) -> Int {
        match self {
            Int::I8 | Int::U8 => Int::U8,
            Int::I16 | Int::U16 => Int::U16,
            Int::I32 | Int::U32 => Int::U32,
            Int::I64 | Int::U64 => Int::U64,
            Int::Isize | Int::Usize => Int::Usize,
        }
    }

    /// Returns the signed type of this width.
    pub const fn with_sign(self) -> Int {
        match self {
            Int::I8 | Int::U8 => Int::I8,
            Int::I16 | Int::U16 => Int::I16,
            Int::I32 | Int::U32 => Int::I32,
            Int::I64 | Int::U64 => Int::I64,
            Int::Isize | Int::Usize => Int::Isize,
        }
    }

    /// Returns the smallest value.
    pub const fn min(self) -> i128 {
        if self.signed() { -(1i128 << (self.bits() - 1)) } else { 0 }
    }

    /// Returns the largest value.
    pub const fn max(self) -> i128 {
        if self.signed() { (1i128 << (self.bits() - 1)) - 1 } else { (1i128 << self.bits()) - 1 }
    }

    /// Returns the name of the type in Rust.
    pub const fn name(self) -> &'static str {
        match self {
            Int::I8 => "i8",
            Int::I16 => "i16",
            Int::I32 => "i32",
            Int::I64 => "i64",
            Int::Isize => "isize",
            Int::U8 => "u8",
            Int::U16 => "u16",
            Int::U32 => "u32",
            Int::U64 => "u64",
            Int::Usize => "usize",
        }
    }

    /// Returns the value of a word.
    pub const fn from_word(self, word: u64) -> i128 {
        if self.signed() { word as i64 as i128 } else { word as i128 }
    }
}

/// A floating-point type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[allow(missing_docs)]
pub enum Float {
    F32,
    F64,
}

impl Float {
    /// Returns the unsigned integer type of this width.
    pub const fn bits_type(self) -> Int {
        match self {
            Float::F32 => Int::U32,
            Float::F64 => Int::U64,
        }
    }

    /// Returns the name of the type in Rust.
    pub const fn name(self) -> &'static str {
        match self {
            Float::F32 => "f32",
            Float::F64 => "f64",
        }
    }
}

/// A type whose values are one word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[allow(missing_docs)]
pub enum Scalar {
    Bool,
    Int(Int),
    Float(Float),
}

impl Scalar {
    /// Returns the scalar type with this name in Rust.
    pub fn from_name(name: &str) -> Option<Scalar> {
        match name {
            "bool" => Some(Scalar::Bool),
            "f32" => Some(Scalar::Float(Float::F32)),
            "f64" => Some(Scalar::Float(Float::F64)),
            _ => Int::ALL.into_iter().find(|int| int.name() == name).map(Scalar::Int),
        }
    }

    /// Returns the name of the type in Rust.
    pub const fn name(self) -> &'static str {
        match self {
            Scalar::Bool => "bool",
            Scalar::Int(int) => int.name(),
            Scalar::Float(float) => float.name(),
        }
    }
}

/// Returns true for the name of an integer of 128 bits, which is a struct of the library.
pub fn is_wide(name: &str) -> bool {
    matches!(name, "u128" | "i128")
}

/// Returns true for the name of a number or of `bool`.
pub fn is_number(name: &str) -> bool {
    Scalar::from_name(name).is_some() || is_wide(name)
}
