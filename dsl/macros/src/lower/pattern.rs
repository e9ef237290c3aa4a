//! Patterns: simple names of parameters and `for`, and destructuring by `let`, `match` and assignments.

use bessemer_tree as tree;
use bessemer_tree::number;
use proc_macro2::Span;
use quote::{ToTokens, quote_spanned};
use syn::Expr::{Array, Call, Infer, Paren, Range, Struct, Tuple};
use syn::parse_quote;
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};

use super::names::{site, slot_name, text};
use super::refuse;
use super::refuse::Refusals;
use super::syntax::{bare, is_variant, last_segment, names};
use super::walk::{Constant, Evaluated, Lowering};
use crate::owned::associated;

/// Returns the name of a pattern that is only a name, possibly with a type.
pub(super) fn alone(pattern: &syn::Pat) -> Option<&syn::PatIdent> {
    match pattern {
        syn::Pat::Ident(it) => (it.by_ref.is_none() && it.subpat.is_none()).then_some(it),
        syn::Pat::Type(it) => alone(&it.pat),
        _ => None,
    }
}

/// Returns the name that a pattern binds, if it binds only one; `_` gets a name.
pub fn simple_name(pattern: &mut syn::Pat, refusals: &mut Refusals) -> Option<syn::Ident> {
    match pattern {
        syn::Pat::Ident(it) if it.by_ref.is_none() && it.subpat.is_none() => Some(it.ident.clone()),
        syn::Pat::Type(it) => simple_name(&mut it.pat, refusals),
        syn::Pat::Wild(it) => {
            let name = syn::Ident::new("_unused", it.underscore_token.span);
            *pattern = parse_quote!(_unused);
            Some(name)
        }
        other => {
            refusals.add(&*other, refuse::DESTRUCTURING);
            None
        }
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

/// Writes `Mode::Idle {}` for `Mode::Idle`, which is equivalent for a variant; rustc rejects it for a constant
/// (`Presets::Idle`). A single name, or one below a module as in `presets::Idle`, may be another name of the variant:
/// there rustc is queried for the value.
pub(super) fn brace_variants(pattern: &mut syn::Pat) {
    struct Braces;
    impl VisitMut for Braces {
        fn visit_pat_mut(&mut self, pattern: &mut syn::Pat) {
            visit_mut::visit_pat_mut(self, pattern);
            if let syn::Pat::Path(it) = pattern
                && is_variant(&it.path)
                && associated(it.qself.as_ref(), &it.path)
                && !is_of_option(&it.path)
            {
                *pattern = syn::Pat::Struct(syn::PatStruct {
                    attrs: std::mem::take(&mut it.attrs),
                    qself: it.qself.take(),
                    path: it.path.clone(),
                    brace_token: syn::token::Brace(it.path.span()),
                    fields: Default::default(),
                    rest: None,
                });
            }
        }
        fn visit_expr_mut(&mut self, _: &mut syn::Expr) {}
    }
    Braces.visit_pat_mut(pattern);
}

impl Lowering {
    /// Returns true if an expression names a place, as far as its syntax shows: no copy is matched in its stead.
    pub(super) fn is_place(&self, expr: &syn::Expr) -> bool {
        match expr {
            syn::Expr::Path(it) => {
                it.path.get_ident().is_some_and(|name| self.is_local(&text(name)))
            }
            syn::Expr::Field(it) => self.is_place(&it.base),
            syn::Expr::Index(it) => {
                self.is_place(&it.expr) && !matches!(&*it.index, syn::Expr::Range(_))
            }
            syn::Expr::Paren(it) => self.is_place(&it.expr),
            syn::Expr::Unary(it) => matches!(it.op, syn::UnOp::Deref(_)) && self.is_place(&it.expr),
            _ => false,
        }
    }

    /// Lowers a pattern; its value is a place if `lent` is true.
    pub(super) fn pattern_of(
        &mut self,
        lent: bool,
        pattern: &syn::Pat,
        looks: &mut Vec<syn::Stmt>,
    ) -> tree::Pattern {
        let outer = std::mem::replace(&mut self.lent, lent);
        let lowered = self.pattern(pattern, looks);
        self.lent = outer;
        lowered
    }

    /// Lowers a pattern. Its names become locals, and the statements that record their types go to `looks`.
    pub(super) fn pattern(
        &mut self,
        pattern: &syn::Pat,
        looks: &mut Vec<syn::Stmt>,
    ) -> tree::Pattern {
        match pattern {
            syn::Pat::Wild(_) => tree::Pattern::Any,
            syn::Pat::Rest(_) => tree::Pattern::Rest,
            syn::Pat::Paren(it) => self.pattern(&it.pat, looks),
            syn::Pat::Type(it) => self.pattern(&it.pat, looks),
            syn::Pat::Reference(it) => self.pattern(&it.pat, looks),
            syn::Pat::Ident(it) if it.by_ref.is_none() || self.lent => self.name_pattern(it, looks),
            syn::Pat::Or(it) => {
                let before = self.scopes.last().map_or(0, Vec::len);
                let outer = self.alternative.clone();
                let mut cases = Vec::new();
                for case in &it.cases {
                    cases.push(self.pattern(case, looks));
                    let bound = self.scopes.last().and_then(|scope| scope.get(before..));
                    self.alternative = bound.unwrap_or_default().to_vec();
                    self.alternative.extend_from_slice(&outer);
                }
                self.alternative = outer;
                tree::Pattern::Or(cases)
            }
            syn::Pat::Lit(syn::PatLit { lit: syn::Lit::ByteStr(it), .. }) => {
                let byte = |byte| {
                    let byte = syn::LitByte::new(byte, it.span());
                    tree::Pattern::Value(self.value(&mut parse_quote! { #byte }))
                };
                tree::Pattern::Array(it.value().into_iter().map(byte).collect())
            }
            syn::Pat::Lit(it) => {
                let mut literal = syn::Expr::Lit(it.clone());
                without_wide_suffix(&mut literal);
                tree::Pattern::Value(self.value(&mut literal))
            }
            syn::Pat::Path(it) if is_of_option(&it.path) => {
                tree::Pattern::Constructor("None".into(), Vec::new())
            }
            syn::Pat::Path(it) => {
                tree::Pattern::Value(self.constant(it.to_token_stream(), &it.path))
            }
            syn::Pat::Range(it) => {
                let inclusive = matches!(it.limits, syn::RangeLimits::Closed(_));
                // The ends of a pattern stay as they are in the copy: they are no expressions.
                let mut end = |end: &Option<Box<syn::Expr>>| {
                    end.as_deref().cloned().map(|mut end| {
                        without_wide_suffix(&mut end);
                        self.value(&mut end)
                    })
                };
                let (from, to) = (end(&it.start), end(&it.end));
                tree::Pattern::Range { from, to, inclusive }
            }
            syn::Pat::Tuple(it) => tree::Pattern::Tuple(self.patterns(&it.elems, looks)),
            syn::Pat::Slice(it) => tree::Pattern::Array(self.patterns(&it.elems, looks)),
            syn::Pat::TupleStruct(it) => {
                let parts = self.patterns(&it.elems, looks);
                tree::Pattern::Constructor(last_segment(&it.path), parts)
            }
            // Of which type is the value's to say.
            syn::Pat::Struct(it) if it.fields.is_empty() && it.rest.is_none() => {
                tree::Pattern::Constructor(last_segment(&it.path), Vec::new())
            }
            syn::Pat::Struct(it) => {
                let fields = it.fields.iter();
                let fields =
                    fields.map(|it| (member(&it.member), self.pattern(&it.pat, looks))).collect();
                tree::Pattern::Fields(last_segment(&it.path), fields)
            }
            other => {
                let reference = matches!(other, syn::Pat::Ident(_));
                let reason = if reference { refuse::BINDING_PATTERN } else { refuse::PATTERN };
                self.refusals.add(other, reason);
                tree::Pattern::Any
            }
        }
    }

    fn patterns(
        &mut self,
        patterns: &syn::punctuated::Punctuated<syn::Pat, syn::Token![,]>,
        looks: &mut Vec<syn::Stmt>,
    ) -> Vec<tree::Pattern> {
        patterns.iter().map(|pattern| self.pattern(pattern, looks)).collect()
    }

    fn name_pattern(&mut self, it: &syn::PatIdent, looks: &mut Vec<syn::Stmt>) -> tree::Pattern {
        if it.subpat.is_none() && is_constant_name(&it.ident) {
            if it.ident == "None" {
                return tree::Pattern::Constructor("None".into(), Vec::new());
            }
            if it.ident == "PhantomData" {
                return tree::Pattern::Any;
            }
            let path = syn::Path::from(it.ident.clone());
            return tree::Pattern::Value(self.constant(it.ident.to_token_stream(), &path));
        }
        let inner = it.subpat.as_ref().map(|(_, inner)| Box::new(self.pattern(inner, looks)));
        let slot = self.slot();
        let name = self.bind_here(&text(&it.ident));
        looks.push(self.look_at_bound(slot, &it.ident));
        tree::Pattern::Name { name, slot, mutable: it.mutability.is_some(), inner }
    }

    /// Returns the statement that records the type of a bound name. The pattern `name @ _` is invalid for a constant,
    /// so rustc reports a constant in small letters, which would be taken for a new name.
    fn look_at_bound(&self, slot: u32, name: &syn::Ident) -> syn::Stmt {
        let slot = slot_name(slot);
        let look = quote_spanned! { name.span() =>
            match &#name { #name @ _ => __look(&#slot, #name) }
        };
        syn::Stmt::Expr(syn::Expr::Verbatim(look), Some(Default::default()))
    }

    /// Lowers a path that rustc evaluates: a constant or a variant.
    pub(super) fn constant(
        &mut self,
        tokens: proc_macro2::TokenStream,
        path: &syn::Path,
    ) -> tree::Expr {
        self.evaluated(tokens, path, Constant::Value)
    }

    /// Lowers a path that rustc evaluates, with the kind of its slot.
    pub(super) fn evaluated(
        &mut self,
        tokens: proc_macro2::TokenStream,
        path: &syn::Path,
        constant: Constant,
    ) -> tree::Expr {
        let (slot, index) = self.held_as(tokens, constant);
        let segments: Vec<_> = path.segments.iter().map(|segment| text(&segment.ident)).collect();
        let name = segments.join("::");
        tree::Expr { kind: tree::ExprKind::Path(index, name), site: site(path), slot: Some(slot) }
    }

    /// Adds a value that rustc evaluates; returns its slot and its index.
    pub(super) fn held_as(
        &mut self,
        tokens: proc_macro2::TokenStream,
        constant: Constant,
    ) -> (u32, u32) {
        let (slot, index) = (self.slot(), self.constants.len() as u32);
        self.constants.push(Evaluated { slot, imports: self.imports.clone(), tokens, constant });
        (slot, index)
    }
}

/// Returns the name of a field.
pub fn member(member: &syn::Member) -> String {
    match member {
        syn::Member::Named(name) => text(name),
        syn::Member::Unnamed(index) => index.index.to_string(),
    }
}

/// Returns true for the path `Option::None`, whose type rustc cannot infer alone.
fn is_of_option(path: &syn::Path) -> bool {
    let before = path.segments.iter().rev().nth(1);
    last_segment(path) == "None" && before.is_some_and(|before| before.ident == "Option")
}

/// Returns true if a name in a pattern begins with a capital, as constants and variants do.
pub fn is_constant_name(ident: &syn::Ident) -> bool {
    ident.to_string().starts_with(|first: char| first.is_uppercase())
}

/// Rewrites a destructuring assignment, such as `(a, b) = (b, a);`, as a `let` with a name for each part and an
/// assignment of each. A literal beside its place is assigned directly. Returns none for an assignment to one place.
pub(super) fn by_let(it: &syn::ExprAssign) -> Option<syn::Expr> {
    if !matches!(&*it.left, Tuple(_) | Array(_) | Struct(_) | Call(_)) {
        return None;
    }
    let mut parts = Parts { beside: it, taken: Vec::new(), assigned: Vec::new() };
    let (mut pattern, mut value) = ((*it.left).clone(), (*it.right).clone());
    parts.part(&mut pattern, Some(&mut value));
    let assigned = parts.assigned;
    Some(parse_quote! { { let #pattern = #value; #(#assigned)* } })
}

/// Visitor that converts the left side of an assignment to a pattern with a name for each place.
struct Parts<'a> {
    /// The assignment, which contains none of these names.
    beside: &'a syn::ExprAssign,
    taken: Vec<String>,
    /// Assignments of the places.
    assigned: Vec<syn::Stmt>,
}

impl Parts<'_> {
    /// Converts a part and its value, if that is written beside it; returns false if both can be removed.
    fn part(&mut self, left: &mut syn::Expr, value: Option<&mut syn::Expr>) -> bool {
        match (left, value) {
            (Paren(it), value) => return self.part(&mut it.expr, value),
            (left, Some(Paren(it))) => return self.part(left, Some(&mut it.expr)),
            (Tuple(it), Some(Tuple(given)))
                if it.elems.len() == given.elems.len() && !it.elems.iter().any(is_rest) =>
            {
                let both = std::mem::take(&mut it.elems).into_iter();
                for (mut place, mut value) in both.zip(std::mem::take(&mut given.elems)) {
                    if self.part(&mut place, Some(&mut value)) {
                        it.elems.push(place);
                        given.elems.push(value);
                    }
                }
            }
            (Tuple(syn::ExprTuple { elems, .. }) | Array(syn::ExprArray { elems, .. }), _)
            | (Call(syn::ExprCall { args: elems, .. }), _) => {
                elems.iter_mut().for_each(|part| _ = self.part(part, None));
            }
            (Struct(it), _) => {
                for field in &mut it.fields {
                    field.colon_token.get_or_insert_default();
                    self.part(&mut field.expr, None);
                }
            }
            (Infer(_), _) => {}
            (rest, _) if is_rest(rest) => {}
            (place, Some(value)) if is_literal(value) => {
                self.assigned.push(parse_quote! { #place = #value; });
                return false;
            }
            (place, _) => {
                let part = || format!("part_{}", self.assigned.len() + 1);
                let name = name_of(place).map_or_else(part, |name| format!("{name}_next"));
                let name = self.fresh(&name);
                self.assigned.push(parse_quote! { #place = #name; });
                *place = parse_quote! { #name };
            }
        }
        true
    }

    /// Returns a name that the assignment does not contain.
    fn fresh(&mut self, wanted: &str) -> syn::Ident {
        let mut name = wanted.to_owned();
        let mut number = 1;
        while self.taken.contains(&name) || names(self.beside, &name) {
            number += 1;
            name = format!("{wanted}_{number}");
        }
        self.taken.push(name.clone());
        syn::Ident::new(&name, Span::mixed_site())
    }
}

/// Returns the name of a place: its last field, or its variable.
fn name_of(place: &syn::Expr) -> Option<String> {
    match place {
        syn::Expr::Path(it) => Some(last_segment(&it.path)),
        syn::Expr::Field(it) => match &it.member {
            syn::Member::Named(name) => Some(text(name)),
            syn::Member::Unnamed(_) => name_of(&it.base),
        },
        syn::Expr::Index(it) => name_of(&it.expr),
        syn::Expr::Unary(it) => name_of(&it.expr),
        syn::Expr::Paren(it) => name_of(&it.expr),
        _ => None,
    }
}

fn is_literal(value: &syn::Expr) -> bool {
    match bare(value) {
        syn::Expr::Lit(_) => true,
        syn::Expr::Unary(it) => matches!(it.op, syn::UnOp::Neg(_)) && is_literal(&it.expr),
        _ => false,
    }
}

/// Removes the suffix of a number of 128 bits, whose type is that of the matched value: a slot cannot see a pattern.
fn without_wide_suffix(literal: &mut syn::Expr) {
    match literal {
        syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Int(it), .. })
            if number::is_wide(it.suffix()) =>
        {
            *it = syn::LitInt::new(it.base10_digits(), it.span());
        }
        syn::Expr::Unary(it) => without_wide_suffix(&mut it.expr),
        _ => {}
    }
}

/// Returns true for `..`, which represents unused parts.
fn is_rest(left: &syn::Expr) -> bool {
    matches!(left, Range(it) if it.start.is_none() && it.end.is_none())
}
