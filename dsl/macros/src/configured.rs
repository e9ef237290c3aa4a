//! Lets rustc act on the `#[cfg(feature = …)]` within an item before an attribute of the DSL reads the item.
//!
//! rustc acts on each `#[cfg]` in what a derive is on, at any depth, and on none in what an attribute is on. So an item with some
//! goes through a derive first, as a constant of an enum that is removed again.
//!
//! Invariant: only features count. They are the same in a generation build as in any other; `debug_assertions` or the target are not, and are refused
//! where they are read.

use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};
use quote::{format_ident, quote};

/// Returns the detour of an item that has a condition within and none but on features.
pub fn detour(attribute: &str, arguments: &TokenStream, item: &TokenStream) -> Option<TokenStream> {
    let mut conditions = Vec::new();
    gather(item.clone(), 0, &mut conditions);
    if conditions.is_empty() || !conditions.into_iter().all(of_features) {
        return None;
    }
    let attribute = Ident::new(attribute, Span::call_site());
    let start =
        item.clone().into_iter().next().map_or_else(Span::call_site, |it| it.span()).start();
    let holder = format_ident!("__Configured{}_{}", start.line, start.column);
    Some(quote! {
        #[derive(::bessemer::__Configured)]
        #[::bessemer::__removed]
        enum #holder { Item = { #[::bessemer::#attribute(#arguments)] #item 0 } }
    })
}

/// Returns the item within the enum, with rustc's decisions.
pub fn configured(holder: TokenStream) -> TokenStream {
    let braced = |tokens: TokenStream| {
        tokens.into_iter().filter_map(|it| match it {
            TokenTree::Group(it) if it.delimiter() == Delimiter::Brace => Some(it.stream()),
            _ => None,
        })
    };
    let variants = braced(holder).last().unwrap_or_default();
    let body = braced(variants).last().unwrap_or_default();
    let mut tokens: Vec<TokenTree> = body.into_iter().collect();
    tokens.pop();
    without_conditions(tokens.into_iter().collect())
}

/// Removes the conditions that are left: rustc keeps those that hold.
fn without_conditions(tokens: TokenStream) -> TokenStream {
    let mut kept: Vec<TokenTree> = Vec::new();
    for token in tokens {
        let after_hash = matches!(kept.last(), Some(TokenTree::Punct(it)) if it.as_char() == '#');
        match token {
            TokenTree::Group(it) if after_hash && condition(&it).is_some() => _ = kept.pop(),
            TokenTree::Group(it) => {
                let mut group = Group::new(it.delimiter(), without_conditions(it.stream()));
                group.set_span(it.span());
                kept.push(group.into());
            }
            other => kept.push(other),
        }
    }
    kept.into_iter().collect()
}

/// Gathers the conditions of `#[cfg(…)]` and `#[cfg_attr(…, …)]` within groups; those of the item itself are rustc's already.
fn gather(tokens: TokenStream, depth: usize, conditions: &mut Vec<TokenStream>) {
    let mut after_hash = false;
    for token in tokens {
        match &token {
            TokenTree::Group(it) if after_hash && it.delimiter() == Delimiter::Bracket => {
                conditions.extend(condition(it).filter(|_| depth > 0));
            }
            TokenTree::Group(it) => gather(it.stream(), depth + 1, conditions),
            _ => {}
        }
        after_hash = matches!(&token, TokenTree::Punct(it) if it.as_char() == '#');
    }
}

/// The condition of an attribute.
fn condition(attribute: &Group) -> Option<TokenStream> {
    let mut tokens = attribute.stream().into_iter();
    let (TokenTree::Ident(name), TokenTree::Group(arguments)) = (tokens.next()?, tokens.next()?)
    else {
        return None;
    };
    let of_attribute = |it: &TokenTree| !matches!(it, TokenTree::Punct(it) if it.as_char() == ',');
    match name.to_string().as_str() {
        "cfg" => Some(arguments.stream()),
        "cfg_attr" => Some(arguments.stream().into_iter().take_while(of_attribute).collect()),
        _ => None,
    }
}

/// Returns true if a condition names features alone.
fn of_features(condition: TokenStream) -> bool {
    condition.into_iter().all(|token| match token {
        TokenTree::Ident(it) => ["feature", "all", "any", "not"].iter().any(|name| it == name),
        TokenTree::Group(it) => of_features(it.stream()),
        TokenTree::Punct(_) | TokenTree::Literal(_) => true,
    })
}
