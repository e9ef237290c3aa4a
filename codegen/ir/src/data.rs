//! Structs and enums that authors define, and the rule for the fields of a struct that hold a value.

use alloc::string::String;
use alloc::vec::Vec;

use crate::attributes::Given;
use crate::ir::{Span, Type};

/// Plain data, or the state of a component.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Struct {
    /// Author's name, such as `Pid`.
    pub name: String,
    /// Rust module, such as `models::attitude`.
    pub module: String,
    /// Author's doc comment, one entry per line.
    pub docs: Vec<String>,
    /// Fields, in the author's order.
    pub fields: Vec<Field>,
    /// Rule for the fields that hold a value.
    pub form: Form,
    /// For a component: words of its initial state, in the order of [`Module::leaves`].
    pub initial: Option<Vec<u64>>,
    /// For plain data with an author's `Default`: its words, in the same order.
    pub defaults: Option<Vec<u64>>,
    /// Author's attributes for the C.
    pub given: Given,
    /// Span of the name.
    pub span: Span,
}

/// Rule for the fields of a [`Struct`] that hold a value.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Form {
    /// All fields hold a value.
    #[default]
    Record,
    /// The first field, a `bool` or an enum, selects by its word which of the others holds a value. Only that one is
    /// read; a literal of the struct has a literal first field.
    Choice(Vec<Option<u32>>),
    /// The first field, a `usize`, is the number of elements of the second, an array, that hold a value.
    Sequence,
    /// Memory for a call; before it, the fields have no meaning.
    Lent,
    /// Fields of memory for calls, of which at most one is in use at a time; no word records which.
    Shared,
}

/// A field of a [`Struct`].
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Author's name.
    pub name: String,
    /// Author's doc comment, one entry per line.
    pub docs: Vec<String>,
    /// Type of the field.
    pub ty: Type,
    /// Author's attributes for the C.
    pub given: Given,
}

/// An enum without payload.
#[derive(Clone, Debug, PartialEq)]
pub struct Enum {
    /// Author's name.
    pub name: String,
    /// Rust module.
    pub module: String,
    /// Author's doc comment, one entry per line.
    pub docs: Vec<String>,
    /// Variants, in the author's order.
    pub variants: Vec<Variant>,
    /// Author's attributes for the C.
    pub given: Given,
    /// Span of the name.
    pub span: Span,
}

/// A variant of an [`Enum`]; its word is its index.
#[derive(Clone, Debug, PartialEq)]
pub struct Variant {
    /// Author's name.
    pub name: String,
    /// Author's doc comment, one entry per line.
    pub docs: Vec<String>,
    /// Number of the variant (`mode as u8`), also in the C: the author's, or else its index.
    pub value: i32,
    /// Author's attributes for the C.
    pub given: Given,
}

impl Struct {
    /// Returns true if fields can share memory: two or more payloads of an enum or a `Result`. At most one of them
    /// holds a value.
    pub fn overlaid(&self) -> bool {
        matches!(self.form, Form::Choice(_)) && self.fields.len() > 2
    }

    /// Returns true if a field holds a value when the first word is `word`.
    pub fn holds(&self, field: usize, word: u64) -> bool {
        match &self.form {
            Form::Choice(chosen) if field > 0 => {
                chosen.get(word as usize).copied().flatten() == Some(field as u32)
            }
            _ => true,
        }
    }
}
