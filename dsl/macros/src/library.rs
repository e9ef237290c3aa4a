//! Blocks of the library: functions of the DSL that define the methods of one of std's or nalgebra's types.
//!
//! Each becomes a free function with its block's generic parameters. In a generation build the block also yields a
//! trait with companions of these methods, by which rustc finds the function where it finds the method.

use proc_macro2::{Group, Ident, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::GenericParam;
use syn::parse::Parser;
use syn::punctuated::Punctuated;
use syn::visit_mut::{self, VisitMut};

use crate::generics::{Scope, ident};
use crate::witness::result_type;
use crate::{builder, closures, function, lower};

/// Expands `#[library(Norms)] impl<T: Real, const N: usize> SVector<T, N> { … }`, where `Norms` names the trait. With
/// `#[library(Norms, expand)]` its functions are `#[function(expand)]`, unless they have other arguments.
pub fn expand(arguments: TokenStream, item: TokenStream) -> TokenStream {
    block(arguments, item).unwrap_or_else(syn::Error::into_compile_error)
}

fn block(arguments: TokenStream, item: TokenStream) -> syn::Result<TokenStream> {
    let asked =
        Punctuated::<syn::Ident, syn::Token![,]>::parse_separated_nonempty.parse2(arguments)?;
    let (name, role) = (&asked[0], asked.get(1).to_token_stream());
    let syn::ItemImpl { generics, self_ty, items, .. } = syn::parse2(item)?;
    let (mut functions, mut companions) = (TokenStream::new(), TokenStream::new());
    let mut rewritten = true;
    for item in items {
        let syn::ImplItem::Fn(mut method) = item else {
            return Err(syn::Error::new_spanned(item, "the library has functions alone"));
        };
        let asked = Asked::take(&mut method, role.clone())?;
        let own = own_generics(&mut method.sig.generics, &generics);
        companions.extend(asked.companions(&method.sig, &own));
        rewritten &= asked.is_rewritten();
        Owner(&self_ty).visit_signature_mut(&mut method.sig);
        functions.extend(function::expand(asked.function, method.into_token_stream()));
    }
    if !lower::generating() {
        return Ok(functions);
    }
    if let Some(parameter) = generics.type_params().find(|it| is_named(&self_ty, &it.ident)) {
        // What has the methods is said where the numbers are.
        let companions = in_place_of(&parameter.ident, companions);
        return Ok(quote! {
            #functions
            #[doc(hidden)]
            #[allow(clippy::all)]
            pub trait #name: Sized { #companions }
        });
    }
    let scope = Scope::of_type(&generics);
    let (unbounded, declared, applied) = (scope.unbounded(), scope.declared(), scope.applied());
    let bounds = if rewritten { scope.bounds([]) } else { scope.value_bounds([]) };
    let sized = (!matches!(*self_ty, syn::Type::Slice(_))).then(|| quote! { : Sized });
    Ok(quote! {
        #functions
        #[doc(hidden)]
        #[allow(clippy::all)]
        pub trait #name #unbounded #sized { #companions }
        impl #declared #name #applied for #self_ty #bounds {}
    })
}

/// Attributes of a function in a block, besides its documentation.
struct Asked {
    /// Arguments of `#[function(expand)]`, or else the block's.
    function: TokenStream,
    /// Names in `#[method(norm, magnitude)]`: methods that the function defines, if not only its own name.
    methods: Vec<syn::Ident>,
    /// Names in `#[by_value(z)]`: parameters that the methods take by value, though the function borrows them.
    by_value: Vec<syn::Ident>,
}

impl Asked {
    /// Removes the attributes from the function and returns them; `function` has the block's arguments.
    fn take(method: &mut syn::ImplItemFn, function: TokenStream) -> syn::Result<Asked> {
        let mut asked = Asked { function, methods: Vec::new(), by_value: Vec::new() };
        for attribute in std::mem::take(&mut method.attrs) {
            let names = || {
                let names =
                    attribute.parse_args_with(Punctuated::<_, syn::Token![,]>::parse_terminated)?;
                syn::Result::Ok(names.into_iter().collect())
            };
            match attribute.path() {
                path if path.is_ident("function") => asked.function = attribute.parse_args()?,
                path if path.is_ident("method") => asked.methods = names()?,
                path if path.is_ident("by_value") => asked.by_value = names()?,
                _ => method.attrs.push(attribute),
            }
        }
        if asked.methods.is_empty() {
            asked.methods.push(method.sig.ident.clone());
        }
        Ok(asked)
    }

    /// Returns true if calls of it are rewritten, for any types.
    fn is_rewritten(&self) -> bool {
        self.function.to_string() == "rewrite"
    }

    /// Returns the companions of the methods that a function defines.
    fn companions(&self, signature: &syn::Signature, own: &syn::Generics) -> TokenStream {
        let (all, values) = (closures::without(&signature.generics), closures::without(own));
        let (all, values) = (Scope::of_function(&all), Scope::of_function(&values));
        let (marker, arguments, bounds) = match self.is_rewritten() {
            true => (signature.ident.clone(), TokenStream::new(), TokenStream::new()),
            false => {
                let bounds = Scope::of_function(own).bounds(values.values());
                (builder::function_marker(&signature.ident, all), all.arguments(), bounds)
            }
        };
        let parameters = signature.inputs.iter().enumerate();
        let parameters: Vec<_> = parameters.map(|(at, it)| self.parameter(at, it)).collect();
        let result = result_type(signature);
        let names = self.methods.iter().map(lower::companion_name);
        let head = quote! { #own(#(#parameters),*) -> ::bessemer::generate::Called<#marker #arguments, #result> #bounds };
        quote! { #(fn #names #head { ::core::unreachable!() })* }
    }

    /// Returns a parameter of such a companion; the first, if it has the block's type, is the receiver.
    fn parameter(&self, at: usize, input: &syn::FnArg) -> TokenStream {
        let syn::FnArg::Typed(it) = input else { return input.to_token_stream() };
        let ty = match &*it.ty {
            syn::Type::Reference(ty) if self.takes(&it.pat) => &ty.elem,
            _ => &it.ty,
        };
        match &**ty {
            syn::Type::Path(it) if at == 0 && is_owner(it) => quote! { self },
            syn::Type::Reference(it) if at == 0 => match &*it.elem {
                syn::Type::Path(ty) if is_owner(ty) => {
                    let mutability = &it.mutability;
                    quote! { &#mutability self }
                }
                _ => quote! { _: #it },
            },
            ty => quote! { _: #ty },
        }
    }

    /// Returns true if the methods take a parameter by value.
    fn takes(&self, pattern: &syn::Pat) -> bool {
        matches!(pattern, syn::Pat::Ident(it) if self.by_value.contains(&it.ident))
    }
}

/// Returns the generics of a function with those of its block: types before numbers, as functions order them. A
/// function that names the block's own decides the order of all.
fn own_generics(generics: &mut syn::Generics, block: &syn::Generics) -> syn::Generics {
    let outer: Vec<_> = block.params.iter().map(ident).collect();
    let mut own = generics.clone();
    own.params = own.params.into_iter().filter(|it| !outer.contains(&ident(it))).collect();
    if own.params.len() == generics.params.len() {
        let mut all: Vec<_> = block.params.iter().chain(&own.params).cloned().collect();
        all.sort_by_key(|it| matches!(it, GenericParam::Const(_)));
        generics.params = all.into_iter().collect();
    }
    own
}

/// Replaces a type parameter by `Self`.
fn in_place_of(parameter: &syn::Ident, tokens: TokenStream) -> TokenStream {
    let of = |token| match token {
        TokenTree::Ident(it) if it == *parameter => TokenTree::Ident(Ident::new("Self", it.span())),
        TokenTree::Group(it) => {
            let inner = in_place_of(parameter, it.stream());
            TokenTree::Group(Group::new(it.delimiter(), inner))
        }
        token => token,
    };
    tokens.into_iter().map(of).collect()
}

fn is_named(ty: &syn::Type, name: &syn::Ident) -> bool {
    matches!(ty, syn::Type::Path(it) if it.path.is_ident(name))
}

fn is_owner(ty: &syn::TypePath) -> bool {
    ty.path.is_ident("Self")
}

/// Visitor that replaces `Self` by the type of a block.
struct Owner<'a>(&'a syn::Type);

impl VisitMut for Owner<'_> {
    fn visit_type_mut(&mut self, ty: &mut syn::Type) {
        match ty {
            syn::Type::Path(it) if is_owner(it) => *ty = self.0.clone(),
            _ => visit_mut::visit_type_mut(self, ty),
        }
    }
}
