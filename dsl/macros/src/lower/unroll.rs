//! `#[unroll(4)]` and `#[keep]` above a `for`: what its author asks of C compilers. The native loop goes without.

use syn::spanned::Spanned;

use super::refuse;
use super::refuse::Refusals;

/// Takes the attribute off a loop; gives how many passes are to be written out at once.
pub fn take(attributes: &mut Vec<syn::Attribute>, refusals: &mut Refusals) -> Option<u32> {
    let attribute = strip(attributes)?;
    let span = attribute.path().span();
    let count = match (&attribute.meta, attribute.path().is_ident("keep")) {
        (syn::Meta::Path(_), true) => Some(1),
        (syn::Meta::List(list), false) => {
            list.parse_args::<syn::LitInt>().ok().and_then(|count| count.base10_parse().ok())
        }
        _ => None,
    };
    if !count.is_some_and(|count| (1..=64).contains(&count)) {
        refusals.add(span, refuse::UNROLL);
    }
    count
}

/// The attribute, taken off a loop.
pub fn strip(attributes: &mut Vec<syn::Attribute>) -> Option<syn::Attribute> {
    let is_ours = |it: &syn::Attribute| it.path().is_ident("unroll") || it.path().is_ident("keep");
    let index = attributes.iter().position(is_ours)?;
    Some(attributes.remove(index))
}
