//! Functions that the DSL does not have, as far as the crate or the type in their paths shows it.

use syn::spanned::Spanned;

use super::names::text;
use super::refuse;
use super::refuse::Reason;
use super::syntax::{Library, is_constructor_name, library};

/// The reason for a function that its path shows to be out of reach.
pub fn function(function: &syn::ExprPath) -> Option<Reason> {
    let names: Vec<_> = function.path.segments.iter().map(|segment| text(&segment.ident)).collect();
    let [.., owner, last] = names.as_slice() else { return None };
    // What is made of its parts has a type, of which rustc knows whether the DSL has it.
    if is_constructor_name(last) {
        return None;
    }
    if let Some(reason) = refuse::named_type(&syn::Ident::new(owner, function.span()).into()) {
        return Some(reason);
    }
    // A companion of the type's answers.
    if bessemer_ir::Scalar::from_name(owner).is_some() {
        return None;
    }
    Some(match library(&function.path)? {
        Library::Std => refuse::STD,
        Library::Core => refuse::CORE,
    })
}
