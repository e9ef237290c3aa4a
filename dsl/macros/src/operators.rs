//! Operators and conversions of authors' types: `#[data] impl Add for Phasor`, `impl From<f64> for Phasor`, `impl
//! FromIterator<usize> for Inputs`, `impl Iterator for Countdown`.
//!
//! A standard trait has no room for a builder, so a trait of the DSL beside it has the builder, and callers' witness
//! copies require that trait. A conversion also has a companion, since it is called by name. `==`, the conversions of
//! `?` and the `next` of loops are found by type in a registry, after all builders ran.

use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, format_ident, quote};
use syn::visit_mut::{self, VisitMut};

use crate::attributes;
use crate::builder::{self, Home, Subject};
use crate::generics::Scope;
use crate::implied;
use crate::kind::Kind;
use crate::lower::{self, Refusals, refuse};
use crate::place;
use crate::redirect;

/// A standard trait whose implementations are called without its name.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Known {
    /// An operator: `a + b`, `a |= b`, `-a`, `a == b`.
    Operator,
    /// A conversion: `From`, `TryFrom`.
    Conversion,
    /// A collection: `FromIterator`, `Extend`.
    Gathering,
    /// An iterator: `Iterator`.
    Iteration,
}

/// Returns the known trait if a path is a trait of Rust that the DSL calls.
pub fn known(path: &syn::Path) -> Option<Known> {
    let name = last(path);
    match name.as_str() {
        // An order of one type is the derived one.
        "PartialOrd" => return argument(path).map(|_| Known::Operator),
        "Neg" | "Not" | "PartialEq" | "Index" | "IndexMut" => return Some(Known::Operator),
        "From" | "TryFrom" => return Some(Known::Conversion),
        "FromIterator" | "Extend" => return Some(Known::Gathering),
        "Iterator" => return Some(Known::Iteration),
        _ => {}
    }
    let infix = ["Add", "Sub", "Mul", "Div", "Rem", "BitAnd", "BitOr", "BitXor", "Shl", "Shr"];
    infix.contains(&name.strip_suffix("Assign").unwrap_or(&name)).then_some(Known::Operator)
}

fn last(path: &syn::Path) -> String {
    path.segments.last().map(|last| lower::text(&last.ident)).unwrap_or_default()
}

/// Returns the native `impl` block, and the items beside it.
pub fn implementation(
    kind: Kind,
    known: Known,
    mut it: syn::ItemImpl,
    refusals: &mut Refusals,
) -> (TokenStream, TokenStream) {
    let Some((path, _)) = it.trait_.clone() else { return Default::default() };
    let other = argument(&path).unwrap_or_else(|| (*it.self_ty).clone());
    if matches!(last(&path).as_str(), "PartialEq" | "PartialOrd") {
        if Scope::of_type(&it.generics).types().next().is_some() {
            refusals.add(&it.generics, refuse::GENERIC_EQUALITY);
        }
        check_comparison(&it, (&path, &other), refusals);
    }
    let operand = Some(&other).filter(|_| known != Known::Gathering);
    for ty in [Some(&*it.self_ty), operand].into_iter().flatten() {
        if matches!(ty, syn::Type::Reference(it) if it.mutability.is_some()) {
            refusals.add(ty, refuse::EXCLUSIVE_OPERAND);
        }
    }
    let owner = match &*it.self_ty {
        syn::Type::Reference(of) if known == Known::Operator => &of.elem,
        owner => owner,
    };
    if is_composed(owner) {
        refusals.add(&it.self_ty, refuse::FOREIGN_OPERAND);
    }
    let mut named = associated(&it);
    if last(&path) == "IndexMut" {
        // It is in the other block.
        let output = syn::parse_quote!(<Self as ::core::ops::Index<#other>>::Output);
        named.push((format_ident!("Output"), output));
    }
    let mut beside = TokenStream::new();
    let generic = Scope::of_type(&it.generics).is_generic();
    if known == Known::Iteration && !generic && lower::generating() && refusals.is_empty() {
        beside.extend(gone_through(&it.self_ty));
    }
    for item in &mut it.items {
        let syn::ImplItem::Fn(method) = item else { continue };
        if known == Known::Iteration && method.sig.ident != "next" {
            // A hint alone says nothing of the items.
            if method.sig.ident != "size_hint" {
                refusals.add(&method.sig.ident, refuse::OWN_ADAPTER);
            }
            continue;
        }
        let mut own = Refusals::default();
        let asked = attributes::of_method(kind, method, &mut own);
        let mut named = Named(&named);
        let mut copy = method.clone();
        named.visit_impl_item_fn_mut(&mut copy);
        let subject = Subject::of(&copy, asked, Home::OfRust(&path));
        let parts = builder::lower(&subject, Scope::of_type(&it.generics), &mut own);
        if let Some(parts) = parts.filter(|_| refusals.is_empty()) {
            let generics = &it.generics;
            let beside_it =
                Beside { owner: &it.self_ty, path: &path, other: &other, method, generics };
            beside.extend(beside_it.items(known, parts.builder, &named));
        }
        let scope = Scope::of_type(&it.generics);
        redirect::native((&mut method.attrs, &mut method.block), scope, own);
    }
    (it.into_token_stream(), beside)
}

/// Expands `#[data] impl Zero for Phasor`: its functions are found by name and type, since generic code calls them for numbers,
/// too.
pub fn of_number(
    kind: Kind,
    mut it: syn::ItemImpl,
    refusals: &mut Refusals,
) -> (TokenStream, TokenStream) {
    let Some((path, _)) = it.trait_.clone() else { return Default::default() };
    if Scope::of_type(&it.generics).is_generic() {
        refusals.add(&it.generics, refuse::GENERIC_EQUALITY);
    }
    if is_composed(&it.self_ty) {
        refusals.add(&it.self_ty, refuse::FOREIGN_OPERAND);
    }
    let mut beside = TokenStream::new();
    for item in &mut it.items {
        let syn::ImplItem::Fn(method) = item else { continue };
        let mut own = Refusals::default();
        let found = attributes::of_method(kind, method, &mut own);
        let (subject, scope) =
            (Subject::of(method, found, Home::OfRust(&path)), Scope::of_type(&it.generics));
        let parts = builder::lower(&subject, scope, &mut own).filter(|_| refusals.is_empty());
        let builder = parts.and_then(|it| syn::parse2::<syn::ImplItemFn>(it.builder).ok());
        if let Some(mut builder) = builder {
            let (owner, name) = (&it.self_ty, lower::text(&method.sig.ident));
            let build = format_ident!("__build_{name}_of_number");
            builder.sig.ident = build.clone();
            let function = quote! { Function(<#owner>::#build) };
            let registered = place::registered(&method.sig.ident, &function);
            beside.extend(quote! {
                const _: () = {
                    impl #owner { #builder }
                    #registered
                    ::bessemer::generate::register! {
                        ::bessemer::generate::OwnOperator {
                            name: #name,
                            left: <#owner as ::bessemer::generate::DslType>::ty,
                            right: <#owner as ::bessemer::generate::DslType>::ty,
                            build: <#owner>::#build,
                        }
                    }
                };
            });
        }
        redirect::native((&mut method.attrs, &mut method.block), scope, own);
    }
    (it.into_token_stream(), beside)
}

/// Returns a check that an author's own iterator is not `Copy`: a loop would iterate over a copy, and leave the
/// original unchanged.
fn gone_through(owner: &syn::Type) -> Option<TokenStream> {
    let syn::Type::Path(path) = owner else { return None };
    let (name, held) = (&path.path.segments.last()?.ident, lower::lasting_type(owner));
    let (named, site) = (place::named(name), place::site(name));
    let build = quote! {
        Other(|__cx| {
            #[allow(unused_imports)]
            use ::bessemer::generate::NotImplemented as _;
            if ::bessemer::generate::Asked::<#held>::of().copies() {
                __cx.copied_iterator(#named, #site);
            }
        })
    };
    let registered = place::registered(name, &build);
    Some(quote! { const _: () = { #registered }; })
}

/// Refuses an own order of one type, and an own `!=`, `<` and the like, which `eq` and `partial_cmp` determine.
fn check_comparison(
    it: &syn::ItemImpl,
    (path, other): (&syn::Path, &syn::Type),
    refusals: &mut Refusals,
) {
    let text = |ty: &syn::Type| ty.to_token_stream().to_string();
    let orders = last(path) == "PartialOrd";
    if orders && text(other) == text(&it.self_ty) {
        refusals.add(path, refuse::OWN_ORDER);
    }
    for item in &it.items {
        let syn::ImplItem::Fn(method) = item else { continue };
        match lower::text(&method.sig.ident).as_str() {
            "ne" => refusals.add(&method.sig.ident, refuse::OWN_UNEQUAL),
            "lt" | "le" | "gt" | "ge" => refusals.add(&method.sig.ident, refuse::OWN_LESS),
            _ => {}
        }
    }
}

/// Returns the other operand, or the source of a conversion: the trait's argument, unless it is the type itself.
fn argument(path: &syn::Path) -> Option<syn::Type> {
    let syn::PathArguments::AngleBracketed(list) = &path.segments.last()?.arguments else {
        return None;
    };
    list.args.iter().find_map(|argument| match argument {
        syn::GenericArgument::Type(syn::Type::Path(ty)) if ty.path.is_ident("Self") => None,
        syn::GenericArgument::Type(ty) => Some(ty.clone()),
        _ => None,
    })
}

/// Returns the associated types of the block: `Output`, `Error`.
fn associated(it: &syn::ItemImpl) -> Vec<(syn::Ident, syn::Type)> {
    let types = it.items.iter().filter_map(|item| match item {
        syn::ImplItem::Type(it) => Some((it.ident.clone(), it.ty.clone())),
        _ => None,
    });
    types.collect()
}

/// Visitor that replaces `Self::Output` by its type, since it has no meaning beside the block.
struct Named<'a>(&'a [(syn::Ident, syn::Type)]);

impl VisitMut for Named<'_> {
    fn visit_type_mut(&mut self, ty: &mut syn::Type) {
        visit_mut::visit_type_mut(self, ty);
        let syn::Type::Path(it) = &*ty else { return };
        let names: Vec<String> =
            it.path.segments.iter().map(|segment| lower::text(&segment.ident)).collect();
        if let [own, name] = names.as_slice()
            && own == "Self"
            && let Some((_, found)) = self.0.iter().find(|(known, _)| known == name)
        {
            *ty = found.clone();
        }
    }
}

/// A method with its context.
struct Beside<'a> {
    owner: &'a syn::Type,
    path: &'a syn::Path,
    other: &'a syn::Type,
    method: &'a syn::ImplItemFn,
    generics: &'a syn::Generics,
}

impl Beside<'_> {
    /// Returns the builder, and the items by which callers find it.
    fn items(&self, known: Known, builder: TokenStream, named: &Named<'_>) -> Option<TokenStream> {
        let Beside { owner, path, other, generics, .. } = self;
        let mut builder: syn::ImplItemFn = syn::parse2(builder).ok()?;
        builder.sig.ident = format_ident!("build", span = Span::call_site());
        let name = last(path);
        let of = format_ident!("{name}", span = Span::call_site());
        let sign = quote! { ::bessemer::generate::sign::#of };
        let implements = quote! { ::bessemer::generate::Implements<#sign, #other> };
        let scope = Scope::of_type(generics);
        let (declared, bounds) = (scope.declared(), scope.value_bounds([]));
        let by_type = ["PartialEq", "Index", "IndexMut", "Iterator"].contains(&name.as_str());
        let registered = match scope.is_generic() {
            false => Some(self.registered(&name, &sign)),
            true => by_type.then(|| {
                let build =
                    quote! { <Self as ::bessemer::generate::Implements<#sign, #other>>::build };
                implied::noted(&of, (owner, other), (scope, None), &build)
            }),
        };
        // Of what is converted, the copy also requests the type of the error.
        let error = named.0.iter().find(|(it, _)| name == "TryFrom" && it == "Error");
        let error = error.map(|(_, ty)| quote! { type Error = #ty; });
        let found = match known {
            Known::Operator => Some(("Operates".to_owned(), quote! { #sign, #other })),
            Known::Conversion if error.is_none() => {
                Some(("FromBuiltin".to_owned(), quote! { #other }))
            }
            // A loop calls it, by no name.
            Known::Iteration => None,
            _ => Some((format!("{name}Builtin"), quote! { #other })),
        };
        let found = found.map(|(found, arguments)| {
            let found = format_ident!("{found}", span = Span::call_site());
            quote! {
                impl #declared ::bessemer::generate::#found<#arguments> for #owner #bounds {
                    type Marker = ::bessemer::generate::Operation<#sign, #owner, #other>;
                    #error
                }
            }
        });
        Some(quote! {
            const _: () = {
                #[allow(private_bounds)]
                impl #declared #implements for #owner #bounds {
                    #builder
                }
                #found
                #registered
            };
        })
    }

    /// Returns the item that registers it with its package, and with code that learns the types only at the end.
    /// Instances of generic items are built where they are called.
    fn registered(&self, name: &str, sign: &TokenStream) -> TokenStream {
        let [owner, other] = [self.owner, self.other].map(lower::lasting_type);
        let build = quote! { <#owner as ::bessemer::generate::Implements<#sign, #other>>::build };
        let registered = place::registered(&self.method.sig.ident, &quote! { Function(#build) });
        quote! {
            #registered
            ::bessemer::generate::register! {
                ::bessemer::generate::OwnOperator {
                    name: #name,
                    left: <#owner as ::bessemer::generate::DslType>::ty,
                    right: <#other as ::bessemer::generate::DslType>::ty,
                    build: #build,
                }
            }
        }
    }
}

/// Returns true if the syntax of a type shows an array, a tuple or a reference, which cannot have an attribute.
pub fn is_composed(ty: &syn::Type) -> bool {
    matches!(ty, syn::Type::Array(_) | syn::Type::Tuple(_) | syn::Type::Reference(_))
}
