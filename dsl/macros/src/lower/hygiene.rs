//! Names that a macro of the author's makes, and names that it is given: rustc tells one from the other, and the tree does not.
//!
//! So a function that has the same name of both is refused. Rust has no question for what a name belongs to; the text of a
//! span begins with it, `#4 bytes(10..11)`. Of a rustc that writes another text, a function that a macro makes is refused
//! as a whole: its tokens do not follow each other in the source.
//!
//! Must not know: what becomes of the names.

use proc_macro2::TokenTree;
use syn::visit::{self, Visit};

use super::names::{generating, text};
use super::refuse;
use super::refuse::Refusals;

/// Refuses a local whose name represents another as well, that of a macro and that of its caller.
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
    /// The names of locals, and what each belongs to.
    bound: Vec<(String, String)>,
    /// The names that may be those of locals.
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
