//! C signatures of functions.

use bessemer_ir::{ConstId, Type};

use super::tree::Storage;

/// Passing mode of a parameter in C.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Passing {
    /// A word, by value.
    Value,
    /// A pointer to const, or an array of const elements.
    Input,
    /// A pointer or an array that the callee reads and writes.
    InOut,
    /// A pointer or an array that receives the result.
    Output,
}

/// A parameter of a C function.
#[derive(Clone, Debug, PartialEq)]
pub struct Param {
    /// Name of the parameter.
    pub name: String,
    /// Type of the value; for a pointer, of the pointee.
    pub ty: Type,
    /// Constants that name its lengths.
    pub sizes: Vec<Option<ConstId>>,
    /// Passing mode.
    pub passing: Passing,
}

/// Result of a C function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Returned {
    /// No returned value, `void`.
    Nothing,
    /// The result.
    Value(Type),
    /// The status.
    Status,
}

/// C signature of a function.
#[derive(Clone, Debug, PartialEq)]
pub struct Signature {
    /// Name of the function.
    pub name: String,
    /// Storage class.
    pub storage: Storage,
    /// Parameters of the Rust function in order, followed by one for the result if it has none by value.
    pub params: Vec<Param>,
    /// Result.
    pub returned: Returned,
    /// Header that declares it; for a static function, the header of its source.
    pub header: String,
    /// Functions of `math.h` whose results it returns; empty if it has a body of its own.
    pub parts: &'static [&'static str],
}
