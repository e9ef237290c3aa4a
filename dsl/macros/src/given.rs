//! Author's C names, units and sections for types, variants, fields, parameters and tables: `#[c(name = "…", section
//! = "…")]`, `#[c(fallback)]`, `#[unit("…")]`, `#[range(0.0..=5.0, clamp)]`,
//! `#[axes(speeds, loads)]`.
//!
//! They are removed from the native item, and reach the tree as [`Given`]. Conflicts of names are found only when the
//! C is written.

use bessemer_tree::attributes::{Attributes, Beyond, Given, Range};
use proc_macro2::TokenStream;
use quote::quote;

use crate::lower::{self, Refusals, refuse};
use crate::sizes;

/// Item below the attributes, which determines the allowed ones.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum On {
    /// A struct or an enum: a name is allowed.
    Type,
    /// A variant of an enum: a name is allowed, and `fallback`.
    Variant,
    /// A field: a name, a unit, a range and axes are allowed.
    Value,
    /// A parameter: a name, a unit and a range are allowed, and the range may be enforced.
    Parameter,
    /// A `const` or a `static`: a name, a unit and a section are allowed.
    Table,
}

/// Returns true if an attribute is one of the DSL's.
fn is_ours(attribute: &syn::Attribute) -> bool {
    ["c", "unit", "range", "axes"].iter().any(|name| attribute.path().is_ident(name))
}

/// Removes the DSL's attributes from the native item.
pub fn strip(attributes: &mut Vec<syn::Attribute>) {
    attributes.retain(|attribute| !is_ours(attribute));
}

/// Reads the DSL's attributes.
pub fn read(attributes: &[syn::Attribute], on: On, refusals: &mut Refusals) -> Given {
    let mut given = Given::default();
    for attribute in attributes.iter().filter(|attribute| is_ours(attribute)) {
        if attribute.path().is_ident("unit") {
            match on {
                On::Value | On::Parameter | On::Table => given.unit = unit(attribute, refusals),
                On::Type | On::Variant => {
                    refusals.add(attribute.path(), refuse::UNIT_PLACE);
                }
            }
            continue;
        }
        if attribute.path().is_ident("range") {
            match on {
                On::Value | On::Parameter => {
                    given.range = range(attribute, on, refusals);
                    if given.name.is_none() {
                        given.site = lower::site(attribute.path());
                    }
                }
                On::Table | On::Type | On::Variant => {
                    refusals.add(attribute.path(), refuse::RANGE_PLACE);
                }
            }
            continue;
        }
        if attribute.path().is_ident("axes") {
            match on {
                On::Value => given.axes = axes(attribute, refusals),
                _ => refusals.add(attribute.path(), refuse::AXES_PLACE),
            }
            if given.name.is_none() {
                given.site = lower::site(attribute.path());
            }
            continue;
        }
        let parsed = attribute.parse_nested_meta(|meta| {
            if meta.path.is_ident("fallback") {
                given.fallback = true;
                if on != On::Variant {
                    refusals.add(&meta.path, refuse::FALLBACK_PLACE);
                }
                return Ok(());
            }
            let text: syn::LitStr = meta.value()?.parse()?;
            if meta.path.is_ident("name") {
                check_name(&text, refusals);
                given.name = Some(text.value());
                given.site = lower::site(&text);
            } else if meta.path.is_ident("section") && on == On::Table {
                check_section(&text, refusals);
                given.section = Some(text.value());
            } else if meta.path.is_ident("section") {
                refusals.add(&meta.path, refuse::SECTION_PLACE);
            } else {
                refusals.add(&meta.path, refuse::C_ARGUMENT);
            }
            Ok(())
        });
        if parsed.is_err() {
            refusals.add(attribute.path(), refuse::C_ARGUMENT);
        }
    }
    given
}

/// Reads a unit.
pub fn unit(attribute: &syn::Attribute, refusals: &mut Refusals) -> Option<String> {
    let unit = attribute.parse_args::<syn::LitStr>().map(|unit| unit.value()).unwrap_or_default();
    if unit.trim().is_empty() || unit.contains("*/") || unit.contains(char::is_control) {
        refusals.add(attribute.path(), refuse::UNIT);
        return None;
    }
    Some(unit)
}

/// Reads the names of one axis, or of two.
fn axes(attribute: &syn::Attribute, refusals: &mut Refusals) -> Vec<String> {
    use syn::punctuated::Punctuated;
    let parser = Punctuated::<syn::Ident, syn::Token![,]>::parse_terminated;
    let axes = attribute.parse_args_with(parser).unwrap_or_default();
    if !(1..=2).contains(&axes.len()) {
        refusals.add(attribute.path(), refuse::AXES);
    }
    axes.iter().map(lower::text).collect()
}

/// Arguments of `#[range(0.0..=5.0, clamp)]`.
struct Ends {
    range: syn::ExprRange,
    beyond: Option<syn::Ident>,
}

impl syn::parse::Parse for Ends {
    fn parse(input: syn::parse::ParseStream<'_>) -> syn::Result<Self> {
        let range = input.parse()?;
        let more = input.parse::<Option<syn::Token![,]>>()?.is_some();
        Ok(Ends { range, beyond: more.then(|| input.parse()).transpose()? })
    }
}

/// Reads a range.
fn range(attribute: &syn::Attribute, on: On, refusals: &mut Refusals) -> Option<Range> {
    let ends = attribute.parse_args::<Ends>().ok();
    let ends = ends.filter(|it| matches!(it.range.limits, syn::RangeLimits::Closed(_)));
    let end = |end: &Option<Box<syn::Expr>>| end.as_deref().and_then(literal);
    let range = ends.as_ref().and_then(|it| Range::new(end(&it.range.start)?, end(&it.range.end)?));
    let Some((range, ends)) = range.zip(ends) else {
        refusals.add(attribute.path(), refuse::RANGE);
        return None;
    };
    let Some(name) = ends.beyond else { return Some(range) };
    let beyond = match lower::text(&name).as_str() {
        "clamp" => Beyond::Clamped,
        "report" => Beyond::Reported,
        _ => {
            refusals.add(&name, refuse::RANGE);
            return None;
        }
    };
    if on != On::Parameter {
        refusals.add(&name, refuse::RANGE_OF_FIELD);
    }
    Some(range.with(beyond))
}

/// Returns the statement at the begin of a body that enforces the range of a parameter; none if it is only documented.
fn enforced(
    (parameter, ty): (&syn::PatIdent, &syn::Type),
    range: Range,
    refusals: &mut Refusals,
) -> Option<syn::Stmt> {
    let (name, mutable) = (&parameter.ident, &parameter.mutability);
    let float = match ty {
        syn::Type::Path(it) => it.path.is_ident("f32") || it.path.is_ident("f64"),
        _ if range.beyond() == Beyond::Taken => return None,
        _ => {
            refusals.add(ty, refuse::RANGE_OF_REFERENCE);
            return None;
        }
    };
    let number = |value: f64| -> syn::Expr {
        let text = match float || value.fract() != 0.0 {
            true => format!("{:?}", value.abs()),
            false => format!("{:.0}", value.abs()),
        };
        let number: syn::Lit = match syn::parse_str(&text) {
            Ok(number) => number,
            Err(_) => return syn::parse_quote!(0),
        };
        if value.is_sign_negative() {
            syn::parse_quote!(-#number)
        } else {
            syn::parse_quote!(#number)
        }
    };
    let (low, high) = (number(range.low()), number(range.high()));
    match range.beyond() {
        Beyond::Taken => None,
        Beyond::Clamped => {
            Some(syn::parse_quote! { let #mutable #name = #name.clamp(#low, #high); })
        }
        Beyond::Reported => Some(syn::parse_quote! { assert!(#name >= #low && #name <= #high); }),
    }
}

/// Returns the value of a literal, such as `5` or `-0.5`.
fn literal(expr: &syn::Expr) -> Option<f64> {
    match expr {
        syn::Expr::Unary(syn::ExprUnary { op: syn::UnOp::Neg(_), expr, .. }) => {
            literal(expr).map(|it| -it)
        }
        syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Float(it), .. }) => it.base10_parse().ok(),
        syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Int(it), .. }) => it.base10_parse().ok(),
        _ => None,
    }
}

/// Removes the DSL's attributes of parameters from a signature, and records them with the names of lengths in its
/// types. The ranges that are enforced become statements at the begin of the body.
pub fn parameters(
    signature: &mut syn::Signature,
    body: Option<&mut syn::Block>,
    attributes: &mut Attributes,
    refusals: &mut Refusals,
) {
    if let syn::ReturnType::Type(_, ty) = &signature.output {
        attributes.result.sizes = sizes::of(ty);
    }
    // A declaration, and a function of the firmware, have no body of their own in the C.
    let on = if body.is_some() { On::Parameter } else { On::Value };
    let mut first = Vec::new();
    for input in &mut signature.inputs {
        let (name, own, sizes) = match input {
            syn::FnArg::Receiver(it) => ("self".to_owned(), &mut it.attrs, Vec::new()),
            syn::FnArg::Typed(it) => match &*it.pat {
                syn::Pat::Ident(pat) => (lower::text(&pat.ident), &mut it.attrs, sizes::of(&it.ty)),
                _ => continue,
            },
        };
        let given = Given { sizes, ..read(own, on, refusals) };
        strip(own);
        if let (Some(range), syn::FnArg::Typed(it)) = (given.range, input)
            && let syn::Pat::Ident(pat) = &mut *it.pat
        {
            first.extend(enforced((pat, &it.ty), range, refusals));
            // The name of the clamped number is `mut` in its place.
            pat.mutability = pat.mutability.filter(|_| !range.clamps());
        }
        if given != Given::default() {
            attributes.parameters.push((name, given));
        }
    }
    if let Some(body) = body {
        body.stmts.splice(0..0, first);
    }
}

/// Returns the attributes as an expression for the builder.
pub fn tokens(item: &Given) -> TokenStream {
    let none = quote! { ::core::option::Option::None };
    if *item == Given::default() {
        return none;
    }
    let text = |text: &Option<String>| match text {
        Some(text) => quote! { ::core::option::Option::Some(#text) },
        None => none.clone(),
    };
    let (name, unit, section) = (text(&item.name), text(&item.unit), text(&item.section));
    let expression = text(&item.expression);
    let range = match item.range {
        Some(range) => {
            let (low, high, beyond) = (range.low(), range.high(), range.beyond() as u8);
            quote! { ::core::option::Option::Some((#low, #high, #beyond)) }
        }
        None => none,
    };
    let (lower::Site(line, column), radix, sizes) = (item.site, item.hexadecimal, &item.sizes);
    let (fallback, axes) = (item.fallback, &item.axes);
    quote! {
        ::core::option::Option::Some(::bessemer::generate::Said {
            name: #name, unit: #unit, range: #range, axes: &[#(#axes),*], section: #section, hexadecimal: #radix, expression: #expression,
            sizes: &[#(#sizes),*], fallback: #fallback, site: (#line, #column),
        })
    }
}

pub fn check_name(text: &syn::LitStr, refusals: &mut Refusals) {
    let name = text.value();
    let mut letters = name.chars();
    let starts = letters.next().is_some_and(|first| first.is_ascii_alphabetic());
    if !starts || !letters.all(|letter| letter.is_ascii_alphanumeric() || letter == '_') {
        refusals.add(text, refuse::C_NAME);
    }
}

pub fn check_section(text: &syn::LitStr, refusals: &mut Refusals) {
    let allowed = |c: char| c.is_ascii_alphanumeric() || "_.$-,".contains(c);
    if text.value().is_empty() || !text.value().chars().all(allowed) {
        refusals.add(text, refuse::C_SECTION);
    }
}
