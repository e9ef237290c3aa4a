//! Generic parameters, as the expansions write them.
//!
//! The parameters of an `impl` block or a type come first, the function's own after them. In a
//! generation build each type among them is a value of the DSL besides what its author asks of it.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::GenericParam;

use crate::closures::bounds_of;
use crate::lower;

/// The parameters in the scope of a function, or of a type.
#[derive(Clone, Copy)]
pub struct Scope<'a> {
    /// The type that implements an interface, where that is open.
    this: Option<&'a GenericParam>,
    outer: Option<&'a syn::Generics>,
    own: Option<&'a syn::Generics>,
}

impl<'a> Scope<'a> {
    /// Returns the scope of a free function.
    pub fn of_function(own: &'a syn::Generics) -> Scope<'a> {
        Scope { this: None, outer: None, own: Some(own) }
    }

    /// Returns the scope of a type or an `impl` block.
    pub fn of_type(outer: &'a syn::Generics) -> Scope<'a> {
        Scope { this: None, outer: Some(outer), own: None }
    }

    /// Returns the scope of a method with parameters of its own.
    pub fn with_method(self, own: &'a syn::Generics) -> Scope<'a> {
        Scope { own: Some(own), ..self }
    }

    /// With what implements an interface.
    pub fn with_implementor(self, this: &'a GenericParam) -> Scope<'a> {
        Scope { this: Some(this), ..self }
    }

    /// The part of the `impl` block.
    pub fn outer(self) -> Scope<'a> {
        Scope { own: None, ..self }
    }

    /// The part of the function.
    pub fn own(self) -> Scope<'a> {
        Scope { this: None, outer: None, ..self }
    }

    /// Returns true if there is anything to be generic over.
    pub fn is_generic(self) -> bool {
        self.params().next().is_some()
    }

    /// Types and constants; lifetimes have no part in what is built.
    fn params(self) -> impl Iterator<Item = &'a GenericParam> {
        let both = self.outer.into_iter().chain(self.own);
        let params = self.this.into_iter().chain(both.flat_map(|generics| &generics.params));
        params.filter(|param| !matches!(param, GenericParam::Lifetime(_)))
    }

    /// The lifetimes of the type, or of the `impl` block.
    pub fn lifetimes(self) -> impl Iterator<Item = &'a syn::LifetimeParam> {
        self.outer.into_iter().flat_map(|generics| generics.lifetimes())
    }

    /// `<'a, T: Real, const N: usize>`, without defaults.
    pub fn declared(self) -> TokenStream {
        let lifetimes = self.lifetimes().map(ToTokens::to_token_stream);
        angle(lifetimes.chain(self.params().map(|param| match param {
            GenericParam::Type(it) => {
                let (name, colon, bounds) = (&it.ident, &it.colon_token, &it.bounds);
                quote! { #name #colon #bounds }
            }
            GenericParam::Const(it) => {
                let (name, ty) = (&it.ident, &it.ty);
                quote! { const #name: #ty }
            }
            other => other.to_token_stream(),
        })))
    }

    /// `<'a, T, N>`: as the type itself is written.
    pub fn applied(self) -> TokenStream {
        let lifetimes = self.lifetimes().map(|it| it.lifetime.to_token_stream());
        angle(lifetimes.chain(self.params().map(name)))
    }

    /// `<'static, T, N>`: the type as a slot holds it.
    pub fn lasting(self) -> TokenStream {
        let lifetimes = self.lifetimes().map(|_| quote! { 'static });
        angle(lifetimes.chain(self.params().map(name)))
    }

    /// `<T, const N: usize>`: without bounds.
    pub fn unbounded(self) -> TokenStream {
        angle(self.params().map(|param| match param {
            GenericParam::Type(it) => it.ident.to_token_stream(),
            GenericParam::Const(it) => {
                let (name, ty) = (&it.ident, &it.ty);
                quote! { const #name: #ty }
            }
            other => other.to_token_stream(),
        }))
    }

    /// `<T, N>`.
    pub fn arguments(self) -> TokenStream {
        angle(self.params().map(name))
    }

    /// `<Self, T, N>`: as the interface itself calls them.
    pub fn arguments_of_self(self) -> TokenStream {
        let rest = Scope { this: None, ..self };
        angle(std::iter::once(quote! { Self }).chain(rest.params().map(name)))
    }

    /// `::<T, N>`.
    pub fn turbofish(self) -> TokenStream {
        let arguments = self.arguments();
        if self.is_generic() {
            quote! { ::#arguments }
        } else {
            TokenStream::new()
        }
    }

    /// The types among them.
    pub fn types(self) -> impl Iterator<Item = &'a syn::Ident> {
        self.params().filter_map(|param| match param {
            GenericParam::Type(it) => Some(&it.ident),
            _ => None,
        })
    }

    /// The author's `where`, and what `more` requests.
    pub fn bounds(self, more: impl IntoIterator<Item = TokenStream>) -> TokenStream {
        let both = self.outer.into_iter().chain(self.own);
        let clauses = both.filter_map(|generics| generics.where_clause.as_ref());
        let predicates = clauses.flat_map(|clause| &clause.predicates);
        let predicates = predicates.map(ToTokens::to_token_stream).chain(more);
        let predicates: Vec<_> = predicates.collect();
        if predicates.is_empty() {
            TokenStream::new()
        } else {
            quote! { where #(#predicates),* }
        }
    }

    /// Returns the bounds by which each type is a value of the DSL.
    pub fn value_bounds(self, more: impl IntoIterator<Item = TokenStream>) -> TokenStream {
        self.bounds(self.values().chain(more))
    }

    /// Returns the bounds that a generation build adds to the types' own.
    pub fn values(self) -> impl Iterator<Item = TokenStream> {
        self.types().flat_map(move |name| {
            let both = self.outer.into_iter().chain(self.own);
            let asked = both.flat_map(|generics| bounds_of(generics, name)).filter_map(conversion);
            let asked = asked.map(|(of, other)| of.predicate(&quote! { #name }, other));
            std::iter::once(self.value(name)).chain(asked.collect::<Vec<_>>())
        })
    }

    /// The arguments for the parameters, as a builder tells them: names and arguments.
    pub fn told(self) -> TokenStream {
        let told = self.params().map(|param| {
            let text = lower::text(ident(param));
            let name = name(param);
            match param {
                GenericParam::Const(_) => quote! { ::bessemer::generate::number(#text, #name) },
                _ => quote! { ::bessemer::generate::argument::<#name>(__cx, #text) },
            }
        });
        quote! { &[#(#told),*] }
    }

    /// The arguments for the parameters of an interface, as its implementation writes them.
    pub fn told_of(self, path: &syn::Path) -> TokenStream {
        let arguments = path.segments.last().map(|last| &last.arguments);
        let Some(syn::PathArguments::AngleBracketed(arguments)) = arguments else {
            return quote! { &[] };
        };
        let told = arguments.args.iter().filter_map(|argument| match argument {
            syn::GenericArgument::Type(ty) if self.is_number(ty) => {
                Some(quote! { ::bessemer::generate::number("", #ty) })
            }
            syn::GenericArgument::Type(ty) => {
                Some(quote! { ::bessemer::generate::argument::<#ty>(__cx, "") })
            }
            syn::GenericArgument::Const(value) => {
                Some(quote! { ::bessemer::generate::number("", #value) })
            }
            _ => None,
        });
        quote! { &[#(#told),*] }
    }

    /// Returns true if what looks like a type is a number among the parameters.
    fn is_number(self, ty: &syn::Type) -> bool {
        let syn::Type::Path(path) = ty else { return false };
        self.params()
            .any(|param| matches!(param, GenericParam::Const(it) if path.path.is_ident(&it.ident)))
    }

    /// Returns the bounds of those types that may be floats; none if there are no types.
    pub fn floats(self) -> Option<Floats> {
        self.types().next()?;
        let is_real = self.types().any(|name| self.is_real(name));
        Some(if is_real { Floats::Real } else { Floats::Number })
    }

    /// Returns true if nalgebra's `RealField` is asked of a type, which then is one of the DSL's floats.
    fn is_real(self, name: &syn::Ident) -> bool {
        let mut both = self.outer.into_iter().chain(self.own);
        both.any(|generics| bounds_of(generics, name).any(is_real))
    }

    fn value(self, name: &syn::Ident) -> TokenStream {
        match self.is_real(name) {
            true => quote! { #name: ::bessemer::generate::Value + ::bessemer::math::Real },
            false => quote! { #name: ::bessemer::generate::Value },
        }
    }

    /// Returns true if all arguments of `ty` are parameters: a block for it is one for every instance.
    pub fn is_for_all(self, ty: &syn::Type) -> bool {
        let syn::Type::Path(path) = ty else { return true };
        let arguments = path.path.segments.last().map(|last| &last.arguments);
        let Some(syn::PathArguments::AngleBracketed(arguments)) = arguments else { return true };
        let is_parameter = |argument: &syn::GenericArgument| {
            let text = argument.to_token_stream().to_string();
            self.params().any(|param| name(param).to_string() == text)
        };
        arguments
            .args
            .iter()
            .all(|it| matches!(it, syn::GenericArgument::Lifetime(_)) || is_parameter(it))
    }

    /// Returns true if `ty` names one of the parameters.
    pub fn is_named_in(self, ty: &syn::Type) -> bool {
        let names: Vec<_> = self.params().map(|param| name(param).to_string()).collect();
        mentions(ty.to_token_stream(), &names)
    }
}

/// Returns true if a bound is nalgebra's `RealField`.
pub fn is_real(bound: &syn::TypeParamBound) -> bool {
    mentions(bound.to_token_stream(), &["RealField", "ComplexField"].map(str::to_owned))
}

/// A conversion that a bound requires.
#[derive(Clone, Copy)]
pub enum Conversion {
    /// `From`.
    From,
    /// `Into`, from the other end.
    Into,
    /// `TryFrom`.
    TryFrom,
}

impl Conversion {
    /// Returns the predicate that a type has the DSL's bound.
    pub fn predicate(self, of: &TokenStream, other: &syn::Type) -> TokenStream {
        match self {
            Conversion::From => quote! { #of: ::bessemer::generate::FromBuiltin<#other> },
            Conversion::Into => quote! { #other: ::bessemer::generate::FromBuiltin<#of> },
            Conversion::TryFrom => quote! { #of: ::bessemer::generate::TryFromBuiltin<#other> },
        }
    }
}

/// The conversion that a bound requires, and the other type; none if it requires something else.
pub fn conversion(bound: &syn::TypeParamBound) -> Option<(Conversion, &syn::Type)> {
    let syn::TypeParamBound::Trait(bound) = bound else { return None };
    let last = bound.path.segments.last()?;
    let of = match lower::text(&last.ident).as_str() {
        "From" => Conversion::From,
        "Into" => Conversion::Into,
        "TryFrom" => Conversion::TryFrom,
        _ => return None,
    };
    let syn::PathArguments::AngleBracketed(list) = &last.arguments else { return None };
    match list.args.first()? {
        syn::GenericArgument::Type(other) => Some((of, other)),
        _ => None,
    }
}

/// Bounds of a type that represents a float: they decide which of the DSL's traits provides its methods.
#[derive(Clone, Copy)]
pub enum Floats {
    /// `num_traits::Float`, or a trait that implies it.
    Number,
    /// nalgebra's `RealField`.
    Real,
}

impl Floats {
    /// The trait of its methods.
    pub fn methods(self) -> TokenStream {
        match self {
            Floats::Number => quote! { AnyFloatMethods },
            Floats::Real => quote! { AnyRealMethods },
        }
    }

    /// Returns the trait of their companions.
    pub fn companions(self) -> TokenStream {
        match self {
            Floats::Number => quote! { AnyFloatBuiltins },
            Floats::Real => quote! { AnyRealBuiltins },
        }
    }
}

/// Returns the name of a parameter; a lifetime without its tick.
pub fn ident(param: &GenericParam) -> &syn::Ident {
    match param {
        GenericParam::Type(it) => &it.ident,
        GenericParam::Const(it) => &it.ident,
        GenericParam::Lifetime(it) => &it.lifetime.ident,
    }
}

fn name(param: &GenericParam) -> TokenStream {
    match param {
        GenericParam::Lifetime(it) => it.lifetime.to_token_stream(),
        param => ident(param).to_token_stream(),
    }
}

fn angle(items: impl Iterator<Item = TokenStream>) -> TokenStream {
    let items: Vec<_> = items.collect();
    if items.is_empty() {
        TokenStream::new()
    } else {
        quote! { <#(#items),*> }
    }
}

fn mentions(tokens: TokenStream, names: &[String]) -> bool {
    tokens.into_iter().any(|token| match token {
        proc_macro2::TokenTree::Ident(ident) => names.contains(&ident.to_string()),
        proc_macro2::TokenTree::Group(group) => mentions(group.stream(), names),
        _ => false,
    })
}
