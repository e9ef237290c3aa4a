//! Macro calls: assertions, `matches!`, matrices.
//!
//! These macros, the module `mem`, and `RealField` in the path of a method are recognised by name; rustc then
//! verifies that they are Rust's and nalgebra's.

use bessemer_tree as tree;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::names::{site, text};
use super::refuse;
use super::walk::Lowering;
use crate::owned::FIELDS;

/// Name of the macro `matches!`, which becomes a `match`.
pub(super) const MATCHES: &str = "matches";

/// Names of nalgebra's macros for a column and for rows.
const ROWS: [&str; 2] = ["vector", "matrix"];

impl Lowering {
    /// Returns true if a path may denote a macro of Rust; a single name is queried from rustc.
    pub(super) fn is_rusts(&mut self, path: &syn::Path) -> bool {
        let Some(ident) = path.get_ident() else {
            return path.segments.len() == 2 && refuse::library(path).is_some();
        };
        self.ask(ident);
        true
    }

    /// Records that rustc must verify a name to be Rust's own.
    pub(super) fn ask(&mut self, name: &syn::Ident) {
        if !self.macros.contains(name) {
            self.macros.push(name.clone());
        }
    }

    /// Queries rustc whether the module of [`in_module`] is Rust's, or the trait of a method's path nalgebra's, if it
    /// is named without its crate.
    pub(super) fn ask_home(&mut self, path: &syn::Path) {
        if let (2, Some(home)) = (path.segments.len(), path.segments.first()) {
            self.ask(&home.ident);
        }
    }

    /// Lowers `assert!(condition)` and the like, `panic!()` and the like; every other macro is refused.
    pub(super) fn macro_call(&mut self, mac: &mut syn::Macro) -> Option<tree::Expr> {
        use syn::punctuated::Punctuated;
        in_every_build(mac);
        let name =
            mac.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default();
        let Some(says) = says(&name) else {
            self.refusals.add(&mac.path, refuse::macro_call(&name));
            return None;
        };
        if !name.starts_with("__") && !self.is_rusts(&mac.path) {
            self.refusals.add(&mac.path, refuse::MACRO);
            return None;
        }
        let parser = Punctuated::<syn::Expr, syn::Token![,]>::parse_terminated;
        let site = site(&mac.path);
        if matches!(says, Says::Never) {
            // What the message would show is not computed.
            mac.tokens = TokenStream::new();
        }
        let Ok(mut arguments) = mac.parse_body_with(parser) else {
            self.refusals.add(&mac.path, refuse::SYNTAX);
            return None;
        };
        let plain = |kind| tree::Expr { kind, site, slot: None };
        let (condition, claim) = match says {
            Says::Never => (plain(tree::ExprKind::Bool(false)), tree::Claim::Assertion),
            Says::Holds(claim) => {
                let condition = self.value(arguments.first_mut()?);
                let witness = &arguments[0];
                mac.tokens = quote! { #witness };
                (condition, claim)
            }
            Says::Compares(op) => {
                let first = Box::new(self.value(arguments.first_mut()?));
                let second = Box::new(self.value(arguments.get_mut(1)?));
                let (left, right) = (&arguments[0], &arguments[1]);
                mac.tokens = quote! { #left, #right };
                (plain(tree::ExprKind::Binary(op, first, second)), tree::Claim::Assertion)
            }
        };
        Some(plain(tree::ExprKind::Assert(Box::new(condition), claim)))
    }
}

/// Returns module and name of a function that may be core's: `core::mem::swap`, `mem::swap`.
pub(super) fn in_module(path: &syn::Path) -> Option<(&syn::Ident, &syn::Ident)> {
    let parts: Vec<_> = path.segments.iter().map(|part| &part.ident).collect();
    match parts.as_slice() {
        [_, home, name] if refuse::library(path).is_some() => Some((home, name)),
        [home, name] => Some((home, name)),
        _ => None,
    }
}

/// Meaning of a macro.
enum Says {
    Holds(tree::Claim),
    Compares(tree::BinaryOp),
    /// Panics.
    Never,
}

fn says(name: &str) -> Option<Says> {
    Some(match name {
        "assert" => Says::Holds(tree::Claim::Assertion),
        "__inside" => Says::Holds(tree::Claim::Index),
        "__room" => Says::Holds(tree::Claim::Capacity),
        "__between" => Says::Holds(tree::Claim::Clamp),
        "__fits" => Says::Holds(tree::Claim::Overflow),
        "__divides" => Says::Holds(tree::Claim::DivisionByZero),
        "__shifts" => Says::Holds(tree::Claim::Shift),
        "assert_eq" => Says::Compares(tree::BinaryOp::Eq),
        "assert_ne" => Says::Compares(tree::BinaryOp::Ne),
        "panic" | "unreachable" | "todo" | "unimplemented" => Says::Never,
        _ => return None,
    })
}

/// Replaces a debug assertion by an ordinary one, since the C has no debug builds.
pub fn in_every_build(mac: &mut syn::Macro) {
    if let Some(last) = mac.path.segments.last_mut()
        && let Some(name) = text(&last.ident).strip_prefix("debug_")
        && matches!(says(name), Some(Says::Holds(_) | Says::Compares(_)))
    {
        last.ident = syn::Ident::new(name, last.ident.span());
    }
}

/// Returns the equivalent expression of a macro whose tokens contain a pattern or an expression; none for other
/// macros.
pub fn expanded(mac: &syn::Macro) -> Option<syn::Expr> {
    match mac.path.is_ident(MATCHES) {
        true => matching(mac).map(syn::Expr::Match),
        false => by_rows(mac),
    }
}

/// Returns `matches!(value, pattern if guard)` as a `match`.
fn matching(mac: &syn::Macro) -> Option<syn::ExprMatch> {
    use syn::parse::ParseStream;
    let parser = |input: ParseStream<'_>| {
        let value: syn::Expr = input.parse()?;
        input.parse::<syn::Token![,]>()?;
        Ok((value, input.parse::<TokenStream>()?))
    };
    let (value, rest) = mac.parse_body_with(parser).ok()?;
    let mut arm: Vec<_> = rest.into_iter().collect();
    arm.pop_if(|token| matches!(token, proc_macro2::TokenTree::Punct(it) if it.as_char() == ','));
    syn::parse2(quote! { match #value { #(#arm)* => true, _ => false } }).ok()
}

/// Returns `vector![a, b]` or `matrix![a, b; c, d]` as a call.
fn by_rows(mac: &syn::Macro) -> Option<syn::Expr> {
    use syn::punctuated::Punctuated;
    type Elements = Punctuated<syn::Expr, syn::Token![,]>;
    let name = &mac.path.segments.last()?.ident;
    let in_rows = ROWS.iter().position(|it| name == it)? > 0;
    let rows: Vec<Vec<syn::Expr>> = if !in_rows {
        let column = mac.parse_body_with(Elements::parse_terminated).ok()?;
        column.into_iter().map(|element| vec![element]).collect()
    } else {
        let parser = Punctuated::<_, syn::Token![;]>::parse_terminated_with;
        let row = |input: syn::parse::ParseStream<'_>| Elements::parse_separated_nonempty(input);
        let rows =
            mac.parse_body_with(|input: syn::parse::ParseStream<'_>| parser(input, row)).ok()?;
        rows.into_iter().map(|row| row.into_iter().collect()).collect()
    };
    Some(syn::parse_quote! { ::bessemer::linear::by_rows([#([#(#rows),*]),*]) })
}

/// Returns calls that rustc finds ambiguous if a name is an author's own macro. It is then defined above beside the
/// import of Rust's, or the module has or imports it.
pub fn asked(name: &syn::Ident) -> TokenStream {
    let module = format_ident!("__own_{}", text(name));
    let arguments = match says(&text(name)) {
        Some(Says::Holds(_)) => quote! { true },
        Some(Says::Compares(tree::BinaryOp::Ne)) => quote! { 0, 1 },
        Some(Says::Compares(_)) => quote! { 0, 0 },
        Some(Says::Never) => quote! {},
        None if name == MATCHES => quote! { 0, 0 },
        // One that is imported may be so in the body alone.
        None if ROWS.contains(&&*text(name)) => {
            return quote! { {
                use ::bessemer::prelude::#name;
                let _ = || #name!(0.0, 0.0);
            } };
        }
        None if FIELDS.iter().any(|it| name == it) => {
            return own_item(name, &module, &quote! { ::bessemer::nalgebra });
        }
        None => return own_item(name, &module, &quote! { ::core }),
    };
    quote! {
        {
            use ::core::#name;
            let _ = || { #name!(#arguments); loop {} };
        }
        mod #module {
            use super::*;
            fn call() { let _ = || { #name!(#arguments); loop {} }; }
        }
    }
}

/// Returns the same query for a module of Rust's or a trait of nalgebra's. A name from two globs is ambiguous unless
/// both mean one item.
fn own_item(name: &syn::Ident, module: &syn::Ident, home: &TokenStream) -> TokenStream {
    quote! {
        mod #module {
            mod rusts {
                pub use #home::#name;
            }
            #[allow(unused_imports)]
            use super::*;
            use rusts::*;
            use self::#name as asked;
        }
    }
}
