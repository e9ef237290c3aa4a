//! Validity of words as values of a type; all legs exchange values in this form.
//!
//! Does not allocate: a value is checked in place, so the interpreter can check the arguments of every call.

use core::fmt;

use crate::{Float, Module, Scalar, Type};

/// Error in words that should be a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum WordsError {
    /// The number of words is wrong.
    Count {
        /// Number of words of the type.
        expected: usize,
        /// Number of words found.
        found: usize,
    },
    /// A word is not a value of its leaf's type.
    Value {
        /// Index of the word.
        index: usize,
        /// The word.
        word: u64,
    },
}

impl core::error::Error for WordsError {}

impl fmt::Display for WordsError {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Count { expected, found } => {
                write!(to, "{expected} words make a value of this type, not {found}")
            }
            Self::Value { index, word } => {
                write!(to, "word {index}, {word:#x}, is no value of its type")
            }
        }
    }
}

/// Returns true if `word` is a value of `ty`, a scalar or an enum.
pub fn word_fits(module: &Module, ty: &Type, word: u64) -> bool {
    match ty {
        Type::Scalar(Scalar::Bool) => word <= 1,
        &Type::Scalar(Scalar::Int(int)) => {
            let value = int.from_word(word);
            int.min() <= value && value <= int.max()
        }
        Type::Scalar(Scalar::Float(Float::F32)) => word <= u64::from(u32::MAX),
        Type::Scalar(Scalar::Float(Float::F64)) => true,
        Type::Enum(id) => (module.enums.get(id.index()))
            .is_some_and(|definition| word < definition.variants.len() as u64),
        _ => false,
    }
}

/// Checks that `words` are a value of `ty`, a type that the validation accepts.
pub fn words_fit(module: &Module, ty: &Type, words: &[u64]) -> Result<(), WordsError> {
    let expected = words_in(module, ty);
    if words.len() != expected {
        return Err(WordsError::Count { expected, found: words.len() });
    }
    match check(module, ty, words, 0) {
        Ok(_) => Ok(()),
        Err(index) => Err(WordsError::Value { index, word: words[index] }),
    }
}

/// Returns the number of words of a value of `ty`.
pub fn words_in(module: &Module, ty: &Type) -> usize {
    match ty {
        Type::Unit | Type::Slice(_) => 0,
        Type::Scalar(_) | Type::Enum(_) => 1,
        Type::Array { element, len } => words_in(module, element) * *len as usize,
        Type::Matrix { rows, cols, .. } => *rows as usize * *cols as usize,
        Type::Struct(id) => {
            let fields = &module.structs[id.index()].fields;
            fields.iter().map(|field| words_in(module, &field.ty)).sum()
        }
    }
}

/// Checks a value that starts at index `at`; returns the index after it, or of the first invalid word.
fn check(module: &Module, ty: &Type, words: &[u64], mut at: usize) -> Result<usize, usize> {
    match ty {
        Type::Unit | Type::Slice(_) => {}
        Type::Scalar(_) | Type::Enum(_) => {
            if !word_fits(module, ty, words[at]) {
                return Err(at);
            }
            at += 1;
        }
        Type::Array { element, len } => {
            for _ in 0..*len {
                at = check(module, element, words, at)?;
            }
        }
        Type::Matrix { element, rows, cols } => {
            let element = Type::Scalar(*element);
            for _ in 0..*rows as usize * *cols as usize {
                at = check(module, &element, words, at)?;
            }
        }
        Type::Struct(id) => {
            for field in &module.structs[id.index()].fields {
                at = check(module, &field.ty, words, at)?;
            }
        }
    }
    Ok(at)
}
