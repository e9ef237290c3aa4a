//! Generic parameters, as the expansions write them.
//!
//! The parameters of an `impl` block or a type precede the function's own. In a generation build each type parameter
//! is a value of the DSL, in addition to its author's bounds.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::GenericParam;

use crate::closures::bounds_of;
use crate::lower;
use crate::numeric::{self, mentions};

/// Generic parameters in the scope of a function or a type.
#[derive(Clone, Copy)]
pub struct Scope<'a> {
    /// Type that implements an interface, if it is a parameter.
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

    /// Returns the scope with the implementing type of an interface.
    pub fn with_implementor(self, this: &'a GenericParam) -> Scope<'a> {
        Scope { this: Some(this), ..self }
    }

    /// Returns only the `impl` block's or type's part.
    pub fn outer(self) -> Scope<'a> {
        Scope { own: None, ..self }
    }

    /// Returns only the function's part.
    pub fn own(self) -> Scope<'a> {
        Scope { this: None, outer: None, ..self }
    }

    /// Returns true if there is a parameter.
    pub fn is_generic(self) -> bool {
        self.params().next().is_some()
    }

    /// Returns the type and const parameters; builders do not need lifetimes.
    fn params(self) -> impl Iterator<Item = &'a GenericParam> {
        let both = self.outer.into_iter().chain(self.own);
        let params = self.this.into_iter().chain(both.flat_map(|generics| &generics.params));
        params.filter(|param| !matches!(param, GenericParam::Lifetime(_)))
    }

    /// Returns the lifetimes of the type, or of the `impl` block.
    pub fn lifetimes(self) -> impl Iterator<Item = &'a syn::LifetimeParam> {
        self.outer.into_iter().flat_map(|generics| generics.lifetimes())
    }

    /// Returns the declarations `<'a, T: Real, const N: usize>`, without defaults.
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

    /// Returns the arguments `<'a, T, N>`, as in the type itself.
    pub fn applied(self) -> TokenStream {
        let lifetimes = self.lifetimes().map(|it| it.lifetime.to_token_stream());
        angle(lifetimes.chain(self.params().map(name)))
    }

    /// Returns the arguments `<'static, T, N>`, for a type in a slot.
    pub fn lasting(self) -> TokenStream {
        let lifetimes = self.lifetimes().map(|_| quote! { 'static });
        angle(lifetimes.chain(self.params().map(name)))
    }

    /// Returns the declarations `<T, const N: usize>`, without bounds.
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

    /// Returns the arguments `<T, N>`.
    pub fn arguments(self) -> TokenStream {
        angle(self.params().map(name))
    }

    /// Returns the arguments `<Self, T, N>`, for the interface itself.
    pub fn arguments_of_self(self) -> TokenStream {
        let rest = Scope { this: None, ..self };
        angle(std::iter::once(quote! { Self }).chain(rest.params().map(name)))
    }

    /// Returns the arguments `::<T, N>`.
    pub fn turbofish(self) -> TokenStream {
        let arguments = self.arguments();
        if self.is_generic() {
            quote! { ::#arguments }
        } else {
            TokenStream::new()
        }
    }

    /// Returns the type parameters.
    pub fn types(self) -> impl Iterator<Item = &'a syn::Ident> {
        self.params().filter_map(|param| match param {
            GenericParam::Type(it) => Some(&it.ident),
            _ => None,
        })
    }

    /// Returns a `where` clause with the author's predicates and `more`.
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
        self.types().flat_map(move |name| self.values_of(name)).chain(self.conversions())
    }

    /// Returns the bounds of [`Scope::values`] that an implementation of `interface` must have as a whole.
    pub fn values_beside(self, interface: &syn::Path) -> impl Iterator<Item = TokenStream> {
        let beside = self.types().filter(move |name| !self.is_passed_on(name, interface));
        beside.flat_map(move |name| self.values_of(name)).chain(self.conversions())
    }

    /// Returns the other bounds of [`Scope::values`]. The hidden items of the interface require them of its parameters, so
    /// functions that call its methods do not need them.
    pub fn values_within(self, interface: &syn::Path) -> impl Iterator<Item = TokenStream> {
        let within = self.types().filter(move |name| self.is_passed_on(name, interface));
        within.flat_map(move |name| self.values_of(name))
    }

    /// Returns true if a type is an argument of an interface as it is, and its bounds imply only what all types have.
    fn is_passed_on(self, name: &syn::Ident, interface: &syn::Path) -> bool {
        let arguments = interface.segments.last().map(|last| &last.arguments);
        let Some(syn::PathArguments::AngleBracketed(list)) = arguments else { return false };
        let is_this = |it: &syn::GenericArgument| matches!(it, syn::GenericArgument::Type(syn::Type::Path(it)) if it.path.is_ident(name));
        let both = self.outer.into_iter().chain(self.own);
        let mut bounds = both.flat_map(|generics| bounds_of(generics, name));
        list.args.iter().any(is_this)
            && !self.is_real(name)
            && bounds.all(|bound| conversion(bound).is_none())
    }

    fn values_of(self, name: &syn::Ident) -> impl Iterator<Item = TokenStream> + use<> {
        let both = self.outer.into_iter().chain(self.own);
        let bounds: Vec<_> = both.flat_map(|generics| bounds_of(generics, name)).collect();
        let wanted = bounds.iter().filter_map(|bound| conversion(bound));
        let wanted = wanted.flat_map(|(of, other)| of.predicates(&quote! { #name }, other));
        let numeric = bounds.iter().flat_map(|bound| numeric::companions(bound));
        let numeric = numeric.map(|path| quote! { #name: #path });
        let more: Vec<_> = wanted.chain(numeric).collect();
        std::iter::once(self.value(name)).chain(more)
    }

    /// Returns the bounds for conversions to types that are no parameters, `Radians: From<T>`.
    fn conversions(self) -> impl Iterator<Item = TokenStream> {
        let both = self.outer.into_iter().chain(self.own);
        both.flat_map(conversions)
    }

    /// Returns names and arguments of the parameters, for a builder.
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

    /// Returns the arguments for an interface's parameters, as its implementation writes them.
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

    /// Returns true if a path that looks like a type is a const parameter.
    fn is_number(self, ty: &syn::Type) -> bool {
        let syn::Type::Path(path) = ty else { return false };
        self.params()
            .any(|param| matches!(param, GenericParam::Const(it) if path.path.is_ident(&it.ident)))
    }

    /// Returns the names of the DSL's traits that have the methods of those types by their bounds; none if there are no
    /// types. In the DSL `Methods` or `Builtins` follow each.
    pub fn numbers(self) -> Vec<&'static str> {
        if self.types().next().is_none() {
            return Vec::new();
        }
        let both = || self.outer.into_iter().chain(self.own);
        let bounds = self.types().flat_map(|name| both().flat_map(|it| bounds_of(it, name)));
        numeric::families(bounds)
    }

    /// Returns true if a type has nalgebra's bound `RealField`, so it is a float of the DSL.
    fn is_real(self, name: &syn::Ident) -> bool {
        let mut both = self.outer.into_iter().chain(self.own);
        both.any(|generics| bounds_of(generics, name).any(numeric::is_real))
    }

    fn value(self, name: &syn::Ident) -> TokenStream {
        match self.is_real(name) {
            true => quote! { #name: ::bessemer::generate::Value + ::bessemer::math::Real },
            false => quote! { #name: ::bessemer::generate::Value },
        }
    }

    /// Returns true if `ty` names one of the parameters.
    pub fn is_named_in(self, ty: &syn::Type) -> bool {
        let names: Vec<_> = self.params().map(|param| name(param).to_string()).collect();
        mentions(ty.to_token_stream(), &names)
    }
}

/// A conversion that a bound requires.
#[derive(Clone, Copy)]
pub enum Conversion {
    /// A `From` bound.
    From,
    /// An `Into` bound.
    Into,
    /// A `TryFrom` bound.
    TryFrom,
}

impl Conversion {
    /// Returns the predicates that a type has the DSL's bounds.
    pub fn predicates(self, of: &TokenStream, other: &syn::Type) -> Vec<TokenStream> {
        match self {
            Conversion::From => vec![quote! { #of: ::bessemer::generate::FromBuiltin<#other> }],
            // The second says which of all conversions `x.into()` is.
            Conversion::Into => vec![
                quote! { #other: ::bessemer::generate::FromBuiltin<#of> },
                quote! { #of: ::bessemer::generate::numbers::IntoBuiltin<#other> },
            ],
            Conversion::TryFrom => {
                vec![quote! { #of: ::bessemer::generate::TryFromBuiltin<#other> }]
            }
        }
    }
}

/// Returns the conversion that a bound requires, and the other type; none for another bound.
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

/// Returns the bounds that `where` clauses imply for conversions to types that are no parameters, `Radians: From<T>`.
pub fn conversions(generics: &syn::Generics) -> Vec<TokenStream> {
    let is_parameter = |ty: &syn::Type| match ty {
        syn::Type::Path(it) => generics.type_params().any(|param| it.path.is_ident(&param.ident)),
        _ => false,
    };
    let clause = generics.where_clause.iter().flat_map(|clause| &clause.predicates);
    let of_others = clause.filter_map(|predicate| match predicate {
        syn::WherePredicate::Type(it) if !is_parameter(&it.bounded_ty) => Some(it),
        _ => None,
    });
    of_others
        .flat_map(|it| {
            it.bounds.iter().filter_map(conversion).map(move |(of, other)| (it, of, other))
        })
        .flat_map(|(it, of, other)| of.predicates(&it.bounded_ty.to_token_stream(), other))
        .collect()
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
