//! Types that an author defines: structs, which of their fields hold a value, and enums.

use alloc::string::String;
use alloc::vec::Vec;

use crate::attributes::Given;
use crate::ir::{Span, Type};

/// Plain data, or the state of a component.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Struct {
    /// The author's name, `Pid`.
    pub name: String,
    /// The Rust module, `models::attitude`.
    pub module: String,
    /// The author's doc comment, a line each.
    pub docs: Vec<String>,
    /// Fields, in the author's order.
    pub fields: Vec<Field>,
    /// Fields that hold a value, by condition.
    pub form: Form,
    /// For a component: its initial state as words, in the order of [`Module::leaves`].
    pub initial: Option<Vec<u64>>,
    /// For plain data whose author writes its `Default` out: that as words, in the same order.
    pub defaults: Option<Vec<u64>>,
    /// The author's wishes for its C.
    pub given: Given,
    /// Span of the name.
    pub span: Span,
}

/// Rule for the fields of a [`Struct`] that hold a value.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Form {
    /// Each of them.
    #[default]
    Record,
    /// The first field, a `bool` or an enum, says by its word which of the others holds one. Only that one
    /// is read; a literal of the struct gives the first field as a literal.
    Choice(Vec<Option<u32>>),
    /// The first field, a `usize`, says how many elements of the second, an array, hold one.
    Sequence,
    /// Memory that is lent to a call: what its fields hold before it means nothing.
    Lent,
    /// Fields as above of which at most one is in use at a time; no word says which.
    Shared,
}

/// A field of a [`Struct`].
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// The author's name.
    pub name: String,
    /// The author's doc comment, a line each.
    pub docs: Vec<String>,
    /// Its type.
    pub ty: Type,
    /// The author's wishes for its C.
    pub given: Given,
}

/// An enum without payload.
#[derive(Clone, Debug, PartialEq)]
pub struct Enum {
    /// The author's name.
    pub name: String,
    /// The Rust module.
    pub module: String,
    /// The author's doc comment, a line each.
    pub docs: Vec<String>,
    /// Variants, in the author's order.
    pub variants: Vec<Variant>,
    /// The author's wishes for its C.
    pub given: Given,
    /// Span of the name.
    pub span: Span,
}

/// A variant of an [`Enum`]; its word is its index.
#[derive(Clone, Debug, PartialEq)]
pub struct Variant {
    /// The author's name.
    pub name: String,
    /// The author's doc comment, a line each.
    pub docs: Vec<String>,
    /// Its number (`mode as u8`), and its value in the C: its index, unless the author says otherwise.
    pub value: i32,
    /// The author's wishes for its C.
    pub given: Given,
}

impl Struct {
    /// The fields of which one at most holds a value, if they can share their memory: those of an enum
    /// with at least two payloads.
    pub fn overlaid(&self) -> bool {
        let tagged = matches!(self.fields.first(), Some(Field { ty: Type::Enum(_), .. }));
        matches!(self.form, Form::Choice(_)) && tagged && self.fields.len() > 2
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
