//! Where a node stands, what it is called, and the names that builder and witness copy agree on.

pub use bessemer_ir::tree::Site;
use quote::format_ident;
use syn::ext::IdentExt;
use syn::spanned::Spanned;

/// Whether this is a generation build. Elsewhere the walk only refuses: places cost a call into
/// rustc each, and nobody reads the witness copy.
pub const GENERATING: bool = cfg!(feature = "generate");

/// Line and column of a node, both from 1; unknown outside a generation build.
pub fn site(node: &impl Spanned) -> Site {
    if !GENERATING {
        return Site::default();
    }
    let start = node.span().start();
    Site(start.line as u32, start.column as u32 + 1)
}

/// A name as it travels: without the `r#` of a raw one.
pub fn text(ident: &syn::Ident) -> String {
    ident.unraw().to_string()
}

/// The name of a slot in the builder.
pub fn slot_name(slot: u32) -> syn::Ident {
    format_ident!("__s{slot}")
}

/// The name of a callee's slot in the builder.
pub fn callee_name(callee: u32) -> syn::Ident {
    format_ident!("__c{callee}")
}

/// The name of the slot of the author's own function behind an operator.
pub fn own_name(operator: usize) -> syn::Ident {
    format_ident!("__o{operator}")
}
