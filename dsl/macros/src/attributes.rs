//! Author's attributes for the C of a function: `#[c(name = "…", section = "…")]`, `#[inline(never)]`,
//! `#[entry(atomic)]`, `#[entry(single)]`, `#[external(header = "…")]`.
//!
//! They are removed from the native item, and reach the tree as [`Attributes`].

use bessemer_tree::attributes::{Attributes, Inlining};
use bessemer_tree::{Derivative, Role};
use proc_macro2::TokenStream;

use crate::given::{self, check_name, check_section};
use crate::kind::Kind;
use crate::lower::refuse::{self, Reason};
use crate::lower::{self, Refusals};

/// Role of a function, and its attributes for the C.
#[derive(Clone)]
pub struct Asked {
    /// Role for its callers.
    pub role: Role,
    /// Attributes for the C.
    pub attributes: Attributes,
    /// Derivative that the body computes.
    pub derivative: Option<Derivative>,
}

/// Reads the attributes of a free function; an external one has its body in the firmware.
pub fn of_function(function: &mut syn::ItemFn, external: bool, refusals: &mut Refusals) -> Asked {
    let attributes = &mut function.attrs;
    let inlining = inlining(attributes);
    let role = match is_inline(attributes) {
        true => Role::Inline { public: is_exported(&function.vis) },
        false => visible(&function.vis),
    };
    let mut asked = Asked::new(role, Attributes { inlining, ..Attributes::default() });
    asked.take(attributes, refusals);
    let body = Some(&mut *function.block).filter(|_| !external);
    given::parameters(&mut function.sig, body, &mut asked.attributes, refusals);
    asked
}

/// Reads the argument `derivative(path::of, parameter, …)` or `gradient(…)` of `#[function]`.
pub fn derivative(arguments: &TokenStream) -> Option<(Derivative, syn::Path)> {
    let list = syn::parse2::<syn::MetaList>(arguments.clone()).ok()?;
    let parser = syn::punctuated::Punctuated::<syn::Path, syn::Token![,]>::parse_terminated;
    let mut paths = list.parse_args_with(parser).ok()?.into_iter();
    let is_gradient = list.path.is_ident("gradient");
    let of = paths.next().filter(|_| is_gradient || list.path.is_ident("derivative"))?;
    let by = paths.map(|it| it.get_ident().map(lower::text)).collect::<Option<Vec<_>>>()?;
    let segments = of.segments.iter().map(|it| lower::text(&it.ident)).collect();
    let site = lower::site(&of.segments.first()?.ident);
    (!by.is_empty()).then_some((Derivative { of: segments, by, is_gradient, site }, of))
}

/// Internal argument that marks a function inside other functions; its value is the nesting depth.
const INSIDE: &str = "__inside";

/// Returns the nesting depth in a function's arguments.
pub fn depth(arguments: &TokenStream) -> u32 {
    let value = syn::parse2::<syn::MetaNameValue>(arguments.clone()).ok();
    match value.filter(|it| it.path.is_ident(INSIDE)).map(|it| it.value) {
        Some(syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Int(depth), .. })) => {
            depth.base10_parse().unwrap_or_default()
        }
        _ => 0,
    }
}

/// Marks the functions inside a body as functions of the DSL, with their nesting depth.
pub fn mark_inner(body: &mut syn::Block, depth: u32) {
    for stmt in &mut body.stmts {
        if let syn::Stmt::Item(syn::Item::Fn(inner)) = stmt {
            let inside = quote::format_ident!("{INSIDE}");
            let mark =
                |path: &syn::Path| path.segments.last().is_some_and(|it| it.ident == "function");
            inner.attrs.retain(|attribute| !mark(attribute.path()));
            inner.attrs.insert(0, syn::parse_quote!(#[::bessemer::function(#inside = #depth)]));
        }
    }
}

/// Returns true if other modules can see it.
pub fn is_public(visibility: &syn::Visibility) -> bool {
    !matches!(visibility, syn::Visibility::Inherited)
}

/// Returns true if an item is `pub` without a restriction.
pub fn is_exported(visibility: &syn::Visibility) -> bool {
    matches!(visibility, syn::Visibility::Public(_))
}

/// Returns the role of an item that other modules call only if it is `pub`.
fn visible(visibility: &syn::Visibility) -> Role {
    if is_public(visibility) { Role::Public } else { Role::Private }
}

/// Reads the attributes of an inherent method.
pub fn of_own_method(kind: Kind, method: &mut syn::ImplItemFn, refusals: &mut Refusals) -> Asked {
    let mut asked = of_method(kind, method, refusals);
    match &mut asked.role {
        Role::Public => asked.role = visible(&method.vis),
        Role::Inline { public } => *public = is_exported(&method.vis),
        _ => {}
    }
    asked
}

/// Reads the attributes of a trait's method, which is as visible as the trait.
pub fn of_method(kind: Kind, method: &mut syn::ImplItemFn, refusals: &mut Refusals) -> Asked {
    let attributes = &mut method.attrs;
    let inlining = inlining(attributes);
    let role = match kind {
        Kind::Data if is_inline(attributes) => Role::Inline { public: true },
        Kind::Data => Role::Public,
        Kind::Component if inlining == Inlining::Always => Role::Inline { public: true },
        Kind::Component => Role::Private,
    };
    let mut asked = Asked::new(role, Attributes { inlining, ..Attributes::default() });
    attributes.retain(|attribute| {
        let is_entry = attribute.path().is_ident("entry");
        if is_entry {
            asked.entry(kind, attribute, refusals);
        }
        !is_entry
    });
    asked.take(attributes, refusals);
    given::parameters(&mut method.sig, Some(&mut method.block), &mut asked.attributes, refusals);
    mark_inner(&mut method.block, 1);
    asked
}

/// Reads the attributes of an interface's method; each implementation has its own.
pub fn of_interface(method: &mut syn::TraitItemFn, refusals: &mut Refusals) -> Asked {
    let mut asked = Asked::new(Role::Public, Attributes::default());
    asked.take(&mut method.attrs, refusals);
    given::parameters(&mut method.sig, method.default.as_mut(), &mut asked.attributes, refusals);
    method.default.iter_mut().for_each(|body| mark_inner(body, 1));
    asked
}

impl Asked {
    /// Creates the attributes of a function whose author writes its body.
    pub fn new(role: Role, attributes: Attributes) -> Self {
        Self { role, attributes, derivative: None }
    }

    /// Reads `#[entry]`, `#[entry(infallible)]` and `#[entry(atomic)]`, each possibly with `single`.
    fn entry(&mut self, kind: Kind, attribute: &syn::Attribute, refusals: &mut Refusals) {
        let words = match &attribute.meta {
            syn::Meta::Path(_) => String::new(),
            syn::Meta::List(list) => list.tokens.to_string(),
            syn::Meta::NameValue(_) => "=".into(),
        };
        let mut words: Vec<&str> = words.split(',').map(str::trim).collect();
        words.retain(|word| !word.is_empty());
        let mut takes = |wanted| {
            let at = words.iter().position(|word| *word == wanted);
            at.map(|at| words.remove(at)).is_some()
        };
        let infallible = takes("infallible");
        (self.attributes.atomic, self.attributes.single) = (takes("atomic"), takes("single"));
        if !words.is_empty() {
            refusals.add(&attribute.meta, refuse::ENTRY_ARGUMENT);
        } else if infallible && self.attributes.atomic {
            refusals.add(&attribute.meta, refuse::ENTRY_BOTH);
        }
        if kind == Kind::Data {
            refusals.add(attribute.path(), refuse::ENTRY_OF_DATA);
        }
        if self.attributes.inlining == Inlining::Always {
            refusals.add(attribute.path(), refuse::ENTRY_INLINE);
        }
        self.role = Role::Entry { infallible };
    }

    /// Reads `#[c(name = "…", section = "…", result = "…")]`, and the result's `#[unit("…")]`.
    fn take(&mut self, attributes: &mut Vec<syn::Attribute>, refusals: &mut Refusals) {
        let role = self.role;
        attributes.retain(|attribute| {
            if attribute.path().is_ident("unit") {
                self.attributes.result.unit = given::unit(attribute, refusals);
                return false;
            }
            if !attribute.path().is_ident("c") {
                return true;
            }
            let parsed = attribute.parse_nested_meta(|meta| {
                let text: syn::LitStr = meta.value()?.parse()?;
                if meta.path.is_ident("name") {
                    check_name(&text, refusals);
                    self.attributes.name = Some(text.value());
                } else if meta.path.is_ident("section") {
                    check_section(&text, refusals);
                    if matches!(role, Role::Inline { .. }) {
                        refusals.add(&text, refuse::INLINE_SECTION);
                    }
                    self.attributes.section = Some(text.value());
                } else if meta.path.is_ident("result") {
                    check_name(&text, refusals);
                    self.attributes.result.name = Some(text.value());
                    self.attributes.result.site = lower::site(&text);
                } else {
                    refusals.add(&meta.path, refuse::C_ARGUMENT);
                }
                Ok(())
            });
            if parsed.is_err() {
                refusals.add(attribute.path(), refuse::C_ARGUMENT);
            }
            false
        });
    }
}

/// Reads the arguments of `#[external(header = "board.h", name = "board_sine")]`.
pub fn external(
    arguments: &TokenStream,
    function: &syn::ItemFn,
    refusals: &mut Refusals,
) -> Attributes {
    let mut attributes =
        Attributes { name: Some(lower::text(&function.sig.ident)), ..Attributes::default() };
    let parser = syn::meta::parser(|meta| {
        let text: syn::LitStr = meta.value()?.parse()?;
        if meta.path.is_ident("name") {
            check_name(&text, refusals);
            attributes.name = Some(text.value());
        } else if meta.path.is_ident("header") && is_header(&text.value()) {
            attributes.external = Some(text.value());
        } else {
            refusals.add(&meta.path, refuse::EXTERNAL_ARGUMENT);
        }
        Ok(())
    });
    let parsed = syn::parse::Parser::parse2(parser, arguments.clone());
    if parsed.is_err() || attributes.external.is_none() && refusals.is_empty() {
        refusals.add(function.sig.fn_token.span, refuse::EXTERNAL_ARGUMENT);
    }
    attributes
}

/// Returns true for a valid name in an `#include` directive, such as `board/adc.h`.
fn is_header(text: &str) -> bool {
    let allowed = |c: char| c.is_ascii_alphanumeric() || "_-./".contains(c);
    text.len() > 2 && text.ends_with(".h") && text.chars().all(allowed)
}

/// Returns true if the author requests inlining: `#[inline]`.
fn is_inline(attributes: &[syn::Attribute]) -> bool {
    let is_inline = attributes.iter().any(|attribute| attribute.path().is_ident("inline"));
    is_inline && inlining(attributes) != Inlining::Never
}

fn inlining(attributes: &[syn::Attribute]) -> Inlining {
    let mut lists = attributes.iter().filter_map(|attribute| match &attribute.meta {
        syn::Meta::List(list) if list.path.is_ident("inline") => Some(list.tokens.to_string()),
        _ => None,
    });
    match lists.next_back().as_deref() {
        Some("never") => Inlining::Never,
        Some("always") => Inlining::Always,
        _ => Inlining::Free,
    }
}

/// Returns the refusal of an attribute that a generic item cannot have, since each instance would have it.
pub fn of_one_instance(attributes: &Attributes) -> Option<Reason> {
    match attributes {
        Attributes { external: Some(_), .. } => Some(refuse::EXTERNAL_GENERIC),
        Attributes { name: Some(_), .. } => Some(refuse::GENERIC_NAME),
        _ => None,
    }
}
