//! Patterns: the simple names that `let`, parameters and `for` bind, and the values of `match`.

use bessemer_ir::tree;
use quote::ToTokens;
use syn::spanned::Spanned;

use super::{Lowering, Refusals, refuse, site};

/// The name that a pattern binds, if that is all it does.
pub fn simple_name(pattern: &syn::Pat, refusals: &mut Refusals) -> Option<syn::Ident> {
    match pattern {
        syn::Pat::Ident(it) if it.by_ref.is_none() && it.subpat.is_none() => Some(it.ident.clone()),
        syn::Pat::Type(it) => simple_name(&it.pat, refusals),
        syn::Pat::Wild(it) => Some(syn::Ident::new("_unused", it.underscore_token.span)),
        other => {
            refusals.add(other.span(), refuse::DESTRUCTURING);
            None
        }
    }
}

/// Gives `_` the name that [`simple_name`] has for it.
pub fn name_wild(pattern: &mut syn::Pat) {
    match pattern {
        syn::Pat::Wild(_) => *pattern = syn::parse_quote!(_unused),
        syn::Pat::Type(it) => name_wild(&mut it.pat),
        _ => {}
    }
}

/// Adds `mut` to a simple name.
pub fn make_mutable(pattern: &mut syn::Pat) {
    match pattern {
        syn::Pat::Ident(it) => it.mutability = Some(Default::default()),
        syn::Pat::Type(it) => make_mutable(&mut it.pat),
        _ => {}
    }
}

impl Lowering<'_> {
    /// The values that a `match` arm names: none for `_`.
    pub(super) fn arm_values(&mut self, pattern: &mut syn::Pat) -> Vec<tree::Expr> {
        match pattern {
            syn::Pat::Wild(_) => Vec::new(),
            syn::Pat::Paren(it) => self.arm_values(&mut it.pat),
            syn::Pat::Or(it) => {
                let cases: Vec<_> = it.cases.iter_mut().map(|case| self.arm_values(case)).collect();
                // `1 | _` is `_`.
                let any = cases.iter().any(Vec::is_empty);
                if any { Vec::new() } else { cases.concat() }
            }
            syn::Pat::Lit(it) => {
                let mut literal = syn::Expr::Lit(it.clone());
                vec![self.value(&mut literal)]
            }
            syn::Pat::Path(it) => {
                let path = it.to_token_stream();
                vec![self.constant(path, &it.path)]
            }
            syn::Pat::Ident(it) if is_constant_name(&it.ident) && it.subpat.is_none() => {
                let path = syn::Path::from(it.ident.clone());
                vec![self.constant(it.ident.to_token_stream(), &path)]
            }
            _ => self.refuse_pattern(pattern),
        }
    }

    fn refuse_pattern(&mut self, pattern: &syn::Pat) -> Vec<tree::Expr> {
        let reason = match pattern {
            syn::Pat::Guard(it) => {
                self.refusals.add(it.if_token.span, refuse::GUARD);
                return Vec::new();
            }
            syn::Pat::Range(_) => refuse::RANGE_PATTERN,
            syn::Pat::Ident(_) => refuse::BINDING_PATTERN,
            syn::Pat::TupleStruct(_) | syn::Pat::Struct(_) => refuse::PAYLOAD_PATTERN,
            _ => refuse::PATTERN,
        };
        self.refusals.add(pattern.span(), reason);
        Vec::new()
    }

    /// A path that rustc evaluates: a constant or a variant.
    pub(super) fn constant(
        &mut self,
        tokens: proc_macro2::TokenStream,
        path: &syn::Path,
    ) -> tree::Expr {
        let slot = self.slot();
        let index = self.constants.len() as u32;
        self.constants.push((slot, tokens));
        let name =
            path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default();
        tree::Expr { kind: tree::ExprKind::Path(index, name), site: site(path), slot: Some(slot) }
    }
}

fn is_constant_name(ident: &syn::Ident) -> bool {
    ident.to_string().starts_with(|first: char| first.is_uppercase())
}
