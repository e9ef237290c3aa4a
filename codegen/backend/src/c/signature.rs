//! The C face of a function.

use bessemer_ir::{ConstId, Type};

use super::tree::Storage;

/// Passing mode of a parameter in C.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Passing {
    /// A word, by value.
    Value,
    /// A pointer to const, or an array of const elements.
    Input,
    /// A pointer or an array that is read and written.
    InOut,
    /// A pointer or an array that only receives the result.
    Output,
}

/// A parameter of a C function.
#[derive(Clone, Debug, PartialEq)]
pub struct Param {
    /// Its name.
    pub name: String,
    /// The type of the value, of the pointee for a pointer.
    pub ty: Type,
    /// The constants that say how many elements it has.
    pub sizes: Vec<Option<ConstId>>,
    /// Passing mode.
    pub passing: Passing,
}

/// Result of a C function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Returned {
    /// `void`.
    Nothing,
    /// The result itself.
    Value(Type),
    /// The status.
    Status,
}

/// The C face of a function.
#[derive(Clone, Debug, PartialEq)]
pub struct Signature {
    /// Its name.
    pub name: String,
    /// Storage class.
    pub storage: Storage,
    /// The parameters of the Rust function, in order; after them the result's, if it has one.
    pub params: Vec<Param>,
    /// Result.
    pub returned: Returned,
    /// The header that declares it (for a static function, the one beside its source).
    pub header: String,
}
