//! Patterns: the simple names that `let`, parameters and `for` bind, and the values of `match`.

use bessemer_ir::tree;
use quote::ToTokens;
use syn::spanned::Spanned;

use super::{Lowering, Refusals, refuse, site, text};

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

/// What an arm of a `match` takes, and what it calls it.
#[derive(Default)]
pub(super) struct Taken {
    /// The values; empty: every one.
    pub patterns: Vec<tree::Pattern>,
    /// The name, and whether it may be assigned.
    pub binding: Option<(String, bool)>,
}

impl Lowering<'_> {
    /// What the pattern of a `match` arm takes; the name it binds is a local from here on.
    pub(super) fn taken(&mut self, pattern: &mut syn::Pat) -> Taken {
        match pattern {
            syn::Pat::Paren(it) => self.taken(&mut it.pat),
            syn::Pat::Ident(it)
                if it.by_ref.is_none() && (it.subpat.is_some() || !is_constant_name(&it.ident)) =>
            {
                let name = text(&it.ident);
                let patterns = match &mut it.subpat {
                    Some((_, inner)) => self.values(inner),
                    None => Vec::new(),
                };
                self.bind(&name);
                Taken { patterns, binding: Some((name, it.mutability.is_some())) }
            }
            other => Taken { patterns: self.values(other), binding: None },
        }
    }

    /// The values that a pattern takes: none for `_`.
    fn values(&mut self, pattern: &mut syn::Pat) -> Vec<tree::Pattern> {
        match pattern {
            syn::Pat::Wild(_) => Vec::new(),
            syn::Pat::Paren(it) => self.values(&mut it.pat),
            syn::Pat::Or(it) => {
                let cases: Vec<_> = it.cases.iter_mut().map(|case| self.values(case)).collect();
                // `1 | _` is `_`.
                let any = cases.iter().any(Vec::is_empty);
                if any { Vec::new() } else { cases.concat() }
            }
            syn::Pat::Lit(it) => {
                let mut literal = syn::Expr::Lit(it.clone());
                vec![tree::Pattern::Value(self.value(&mut literal))]
            }
            syn::Pat::Path(it) => {
                let path = it.to_token_stream();
                vec![tree::Pattern::Value(self.constant(path, &it.path))]
            }
            syn::Pat::Ident(it) if is_constant_name(&it.ident) && it.subpat.is_none() => {
                let path = syn::Path::from(it.ident.clone());
                vec![tree::Pattern::Value(self.constant(it.ident.to_token_stream(), &path))]
            }
            syn::Pat::Range(it) => {
                let inclusive = matches!(it.limits, syn::RangeLimits::Closed(_));
                // The ends of a pattern stay as they are in the copy: they are no expressions.
                let mut end = |end: &Option<Box<syn::Expr>>| {
                    end.as_deref().cloned().map(|mut end| self.value(&mut end))
                };
                let (from, to) = (end(&it.start), end(&it.end));
                vec![tree::Pattern::Range { from, to, inclusive }]
            }
            _ => self.refuse_pattern(pattern),
        }
    }

    /// What the pattern of a `let` takes from its value; the statements that look at its names go to
    /// `looks`.
    pub(super) fn binding(
        &mut self,
        pattern: &syn::Pat,
        looks: &mut Vec<syn::Stmt>,
    ) -> tree::Binding {
        match pattern {
            syn::Pat::Wild(_) => tree::Binding::Ignored,
            syn::Pat::Paren(it) => self.binding(&it.pat, looks),
            syn::Pat::Type(it) => self.binding(&it.pat, looks),
            syn::Pat::Ident(it) if it.by_ref.is_none() && it.subpat.is_none() => {
                let (slot, name) = (self.slot(), text(&it.ident));
                self.bind(&name);
                looks.push(self.look(slot, &it.ident));
                tree::Binding::Name { name, slot }
            }
            syn::Pat::Tuple(it) => {
                tree::Binding::Tuple(it.elems.iter().map(|it| self.binding(it, looks)).collect())
            }
            syn::Pat::Slice(it) => {
                tree::Binding::Array(it.elems.iter().map(|it| self.binding(it, looks)).collect())
            }
            syn::Pat::Struct(it) => {
                let mut fields = Vec::new();
                for field in &it.fields {
                    match &field.member {
                        syn::Member::Named(name) => {
                            fields.push((text(name), self.binding(&field.pat, looks)));
                        }
                        syn::Member::Unnamed(index) => {
                            self.refusals.add(index.span, refuse::TUPLE_STRUCT);
                        }
                    }
                }
                tree::Binding::Struct(fields)
            }
            other => {
                self.refusals.add(other.span(), refuse::DESTRUCTURING);
                tree::Binding::Ignored
            }
        }
    }

    fn refuse_pattern(&mut self, pattern: &syn::Pat) -> Vec<tree::Pattern> {
        let reason = match pattern {
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
        let segments: Vec<_> =
            path.segments.iter().map(|segment| super::text(&segment.ident)).collect();
        let name = segments.join("::");
        tree::Expr { kind: tree::ExprKind::Path(index, name), site: site(path), slot: Some(slot) }
    }
}

fn is_constant_name(ident: &syn::Ident) -> bool {
    ident.to_string().starts_with(|first: char| first.is_uppercase())
}
