//! Detects names that an author's macro declares and that equal names of the macro's caller. rustc distinguishes
//! them, and the tree does not.
//!
//! A function with such a name is refused. Rust has no query for the origin of a name, but the text of a span begins
//! with it: `#4 bytes(10..11)`. If rustc's text has another form, every function that a macro makes is refused; its
//! tokens are not consecutive in the source.
//!
//! Must not know: the use of the names.

use proc_macro2::TokenTree;
use syn::visit::{self, Visit};

use super::names::{generating, text};
use super::refuse;
use super::refuse::Refusals;

/// Refuses a local whose name is declared both in a macro and by its caller.
pub fn check_hygiene(signature: &syn::Signature, body: &syn::Block, refusals: &mut Refusals) {
    if !generating() {
        return;
    }
    let mut names = Names::default();
    names.visit_signature(signature);
    names.visit_block(body);
    let start = |name: &syn::Ident| name.span().start();
    let in_order = names.all.is_sorted_by_key(|(name, _)| (start(name).line, start(name).column));
    if !in_order && names.all.iter().any(|(_, of)| of.is_empty()) {
        return refusals.add(&signature.ident, refuse::HYGIENE_UNKNOWN);
    }
    for (name, of) in &names.all {
        let is_other = |(known, other): &(String, String)| *known == text(name) && other != of;
        if names.bound.iter().any(is_other) {
            return refusals.add(name, refuse::HYGIENE);
        }
    }
}

#[derive(Default)]
struct Names {
    /// Names of locals with their origins.
    bound: Vec<(String, String)>,
    /// Names that may be locals, with their origins.
    all: Vec<(syn::Ident, String)>,
}

impl Names {
    fn note(&mut self, name: &syn::Ident) -> String {
        let span = format!("{:?}", name.span());
        let of = span.split(' ').next().filter(|it| it.starts_with('#')).unwrap_or_default();
        self.all.push((name.clone(), of.to_owned()));
        of.to_owned()
    }

    fn tokens(&mut self, tokens: proc_macro2::TokenStream) {
        for token in tokens {
            match token {
                TokenTree::Ident(name) => _ = self.note(&name),
                TokenTree::Group(group) => self.tokens(group.stream()),
                _ => {}
            }
        }
    }
}

impl<'ast> Visit<'ast> for Names {
    fn visit_pat_ident(&mut self, it: &'ast syn::PatIdent) {
        let of = self.note(&it.ident);
        self.bound.push((text(&it.ident), of));
        visit::visit_pat_ident(self, it);
    }

    fn visit_expr_path(&mut self, it: &'ast syn::ExprPath) {
        if let (None, Some(name)) = (&it.qself, it.path.get_ident()) {
            self.note(name);
        }
    }

    fn visit_macro(&mut self, it: &'ast syn::Macro) {
        self.tokens(it.tokens.clone());
    }
}
