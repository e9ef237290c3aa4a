//! `Point { x, y } = p;`, `(first, ..) = pair;`: a `let` with a name for each part, and an assignment of each, which is what
//! Rust makes of it.
//!
//! Must not know: what a tuple or an array whose parts are all assigned becomes.

use proc_macro2::Span;
use syn::parse_quote;

/// The block that an assignment stands for; none if its left side is made of tuples and arrays alone.
pub(super) fn by_let(it: &syn::ExprAssign) -> Option<syn::Expr> {
    let mut parts = Parts { named: Vec::new(), whole: true };
    let pattern = parts.pattern(&it.left);
    let (value, assigned) = (&it.right, parts.named);
    (!parts.whole).then(|| parse_quote! { { let #pattern = #value; #(#assigned)* } })
}

/// The assignments of the parts.
struct Parts {
    named: Vec<syn::Stmt>,
    /// Whether tuples and arrays are all, and each part of them.
    whole: bool,
}

impl Parts {
    fn pattern(&mut self, left: &syn::Expr) -> syn::Pat {
        match left {
            syn::Expr::Infer(_) => parse_quote! { _ },
            syn::Expr::Paren(it) => self.pattern(&it.expr),
            syn::Expr::Tuple(it) => {
                let parts = self.all(&it.elems);
                parse_quote! { (#(#parts,)*) }
            }
            syn::Expr::Array(it) => {
                let parts = self.all(&it.elems);
                parse_quote! { [#(#parts),*] }
            }
            syn::Expr::Range(it) if it.start.is_none() && it.end.is_none() => {
                self.whole = false;
                parse_quote! { .. }
            }
            syn::Expr::Call(it) => {
                self.whole = false;
                let (name, parts) = (&it.func, self.all(&it.args));
                parse_quote! { #name(#(#parts),*) }
            }
            syn::Expr::Struct(it) => {
                self.whole = false;
                let (name, rest) = (&it.path, &it.dot2_token);
                let members = it.fields.iter().map(|field| &field.member);
                let parts: Vec<_> = it.fields.iter().map(|it| self.pattern(&it.expr)).collect();
                parse_quote! { #name { #(#members: #parts,)* #rest } }
            }
            place => {
                let name = format!("part_{}", self.named.len() + 1);
                let name = syn::Ident::new(&name, Span::mixed_site());
                self.named.push(parse_quote! { #place = #name; });
                parse_quote! { #name }
            }
        }
    }

    fn all<'e>(&mut self, parts: impl IntoIterator<Item = &'e syn::Expr>) -> Vec<syn::Pat> {
        parts.into_iter().map(|part| self.pattern(part)).collect()
    }
}
