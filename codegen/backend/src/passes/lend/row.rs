//! Working memory as rows of elements.

use bessemer_ir::{Module, Scalar, Type};

/// Elements of one type, one after another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Row {
    pub element: Type,
    pub len: u32,
}

impl Row {
    /// Returns the elements of a value; `flat`: matrices are arrays of scalars.
    pub fn of(ty: &Type, flat: bool) -> Row {
        match ty {
            Type::Matrix { rows, cols, .. } if !flat && *rows > 1 && *cols > 1 => {
                Row { element: ty.clone(), len: 1 }
            }
            Type::Array { element, len } => Row { element: (**element).clone(), len: *len },
            Type::Matrix { element, rows, cols } => {
                Row { element: Type::Scalar(*element), len: rows * cols }
            }
            other => Row { element: other.clone(), len: 1 },
        }
    }

    /// Returns the type of the whole row.
    pub fn ty(&self) -> Type {
        match (&self.element, self.len) {
            // A struct is lent as itself.
            (Type::Struct(_), 1) => self.element.clone(),
            (element, len) => Type::Array { element: Box::new(element.clone()), len },
        }
    }
}

/// Rows that a function needs, in the order of its last parameters.
pub(super) type Need = Vec<Row>;

/// Returns a plural noun for a type's elements.
pub(super) fn noun(module: &Module, element: &Type) -> String {
    match element {
        Type::Scalar(Scalar::Bool) => "flags".into(),
        Type::Scalar(Scalar::Float(_)) => "numbers".into(),
        Type::Scalar(Scalar::Int(int)) if int.bits() == 8 => "bytes".into(),
        Type::Scalar(Scalar::Int(_)) => "words".into(),
        Type::Enum(id) => snake(&module.enums[id.index()].name),
        Type::Struct(id) => snake(&module.structs[id.index()].name),
        Type::Array { element, .. } | Type::Slice(element) => {
            format!("{}_rows", noun(module, element))
        }
        Type::Matrix { .. } => "matrices".into(),
        Type::Unit => "nothing".into(),
    }
}

/// Converts `RecordOfIt` to `record_of_it`.
fn snake(name: &str) -> String {
    let mut text = String::new();
    for letter in name.chars() {
        if letter.is_ascii_uppercase() && !text.is_empty() && !text.ends_with('_') {
            text.push('_');
        }
        text.extend(letter.to_lowercase());
    }
    text
}
