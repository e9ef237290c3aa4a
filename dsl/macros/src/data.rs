//! `#[data]` and `#[component]`: structs, enums and their `impl` blocks.
//!
//! Every build gets `Plain` (values as words). A generation build also gets the definition of the
//! type and the builders of its methods.

use bessemer_ir::tree::Role;
use proc_macro2::TokenStream;
use quote::{ToTokens, quote, quote_spanned};
use syn::spanned::Spanned;

use crate::builder::{self, Home, Subject};
use crate::docs;
use crate::function::refuse_body;
use crate::generics::Scope;
use crate::instance;
use crate::interface;
use crate::lower::{self, Refusals, refuse};
use crate::redirect;

/// Which attribute stands on the item.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// `#[data]`.
    Data,
    /// `#[component]`.
    Component,
}

/// Expands the attribute on a struct, an enum or an `impl` block.
pub fn expand(kind: Kind, arguments: TokenStream, item: TokenStream) -> TokenStream {
    let mut refusals = Refusals::default();
    if !arguments.is_empty() {
        refusals.add(arguments.span(), refuse::ARGUMENTS);
    }
    let (native, beside) = match syn::parse2::<syn::Item>(item.clone()) {
        Ok(syn::Item::Struct(it)) => (it.to_token_stream(), data_struct(kind, &it, &mut refusals)),
        Ok(syn::Item::Enum(it)) => (it.to_token_stream(), data_enum(kind, &it, &mut refusals)),
        Ok(syn::Item::Type(it)) => (it.to_token_stream(), instance::named(&it, &mut refusals)),
        Ok(syn::Item::Impl(it)) => methods(kind, it, &mut refusals),
        Ok(syn::Item::Union(it)) => {
            refusals.add(it.union_token.span, refuse::UNION);
            (it.to_token_stream(), TokenStream::new())
        }
        Ok(other) => {
            refusals.add(refuse::first_token(&other), refuse::NOT_DATA);
            (item, TokenStream::new())
        }
        Err(error) => (item, error.into_compile_error()),
    };
    let errors = refusals.into_tokens();
    quote! { #errors #native #beside }
}

/// A type that is generic over a lifetime would hold a reference.
fn refuse_lifetimes(generics: &syn::Generics, refusals: &mut Refusals) {
    for parameter in &generics.params {
        if let syn::GenericParam::Lifetime(it) = parameter {
            refusals.add(it.span(), refuse::REFERENCE_FIELD);
        }
    }
}

fn data_struct(kind: Kind, it: &syn::ItemStruct, refusals: &mut Refusals) -> TokenStream {
    refuse_lifetimes(&it.generics, refusals);
    lower::check_attributes(&it.attrs, refusals);
    let fields = match &it.fields {
        syn::Fields::Named(fields) if !fields.named.is_empty() => fields,
        fields => {
            let unnamed = matches!(fields, syn::Fields::Unnamed(_));
            let reason = if unnamed { refuse::TUPLE_STRUCT } else { refuse::EMPTY_STRUCT };
            refusals.add(it.ident.span(), reason);
            return TokenStream::new();
        }
    };
    for field in &fields.named {
        lower::check_attributes(&field.attrs, refusals);
        lower::check_field(&field.ty, refusals);
    }
    if !refusals.is_empty() {
        return TokenStream::new();
    }
    let name = &it.ident;
    let scope = Scope::of_type(&it.generics);
    let idents: Vec<_> = fields.named.iter().filter_map(|field| field.ident.as_ref()).collect();
    let types: Vec<_> = fields.named.iter().map(|field| &field.ty).collect();
    // Spanned at the field's type: a type that is not plain is told there.
    let store = idents.iter().zip(&types).map(|(ident, ty)| {
        quote_spanned! { ty.span() => <#ty as ::bessemer::Plain>::store(&self.#ident, out); }
    });
    let load = idents.iter().zip(&types).map(|(ident, ty)| {
        quote_spanned! { ty.span() => #ident: <#ty as ::bessemer::Plain>::load(next) }
    });
    let (declared, arguments) = (scope.declared(), scope.arguments());
    let bounds = field_bounds(scope, fields, &quote! { ::bessemer::Plain });
    let plain = quote! {
        #[diagnostic::do_not_recommend]
        #[allow(private_bounds)]
        impl #declared ::bessemer::Plain for #name #arguments #bounds {
            fn store(&self, out: &mut dyn ::core::ops::FnMut(u64)) { #(#store)* }
            fn load(next: &mut dyn ::core::ops::FnMut() -> u64) -> Self {
                Self { #(#load),* }
            }
        }
    };
    let initial = (kind == Kind::Component && !scope.is_generic()).then(|| {
        quote_spanned! { name.span() =>
            const _: fn() -> #name = <#name as ::core::default::Default>::default;
        }
    });
    let definition = cfg!(feature = "generate").then(|| struct_definition(kind, it, fields));
    quote! { #plain #initial #definition }
}

/// What a generic type asks of the fields that depend on its parameters.
fn field_bounds(scope: Scope<'_>, fields: &syn::FieldsNamed, of: &TokenStream) -> TokenStream {
    let types = fields.named.iter().map(|field| &field.ty).filter(|ty| scope.is_named_in(ty));
    scope.bounds(types.map(|ty| quote! { #ty: #of }))
}

fn struct_definition(kind: Kind, it: &syn::ItemStruct, fields: &syn::FieldsNamed) -> TokenStream {
    let fields = fields.named.iter().map(|field| {
        let name = field.ident.as_ref().map(lower::text).unwrap_or_default();
        let (docs, ty) = (docs::lines(&field.attrs), &field.ty);
        quote! { ::bessemer::generate::field::<#ty>(cx, #name, &[#(#docs),*]) }
    });
    let name = &it.ident;
    let initial = match kind {
        Kind::Data => quote! { ::core::option::Option::None },
        Kind::Component => quote! {
            ::core::option::Option::Some(::bessemer::generate::words(&<Self as ::core::default::Default>::default()))
        },
    };
    let body = quote! {
        ::bessemer::generate::tree::DefinitionKind::Struct {
            fields: ::bessemer::generate::list([#(#fields),*]),
            initial: #initial,
        }
    };
    let scope = Scope::of_type(&it.generics);
    let mut bounds = Vec::new();
    if scope.is_generic() {
        let fields = it.fields.iter().map(|field| &field.ty).filter(|ty| scope.is_named_in(ty));
        bounds.extend(fields.map(|ty| quote! { #ty: ::bessemer::generate::DslType }));
        bounds.extend(scope.types().map(|name| quote! { #name: ::bessemer::generate::Value }));
        if kind == Kind::Component {
            let arguments = scope.arguments();
            bounds.push(quote! { #name #arguments: ::core::default::Default + ::bessemer::Plain });
        }
    }
    definition(name, scope, &scope.bounds(bounds), &it.attrs, body)
}

/// The definition of a type, and its registration; of a generic type, its instances are built where
/// they are used.
fn definition(
    name: &syn::Ident,
    scope: Scope<'_>,
    bounds: &TokenStream,
    attributes: &[syn::Attribute],
    kind: TokenStream,
) -> TokenStream {
    let docs = docs::lines(attributes);
    let lower::Site(line, column) = lower::site(name);
    let text = lower::text(name);
    let (declared, arguments, told) = (scope.declared(), scope.arguments(), scope.told());
    let outer = scope.bounds([]);
    let registered = (!scope.is_generic()).then(|| {
        quote! {
            ::bessemer::generate::register! {
                ::bessemer::generate::Registered::new(::core::module_path!(), (#line, #column), ::bessemer::generate::data::<#name>)
            }
        }
    });
    quote! {
        const _: () = {
            impl #declared ::bessemer::generate::Seen for #name #arguments #outer {
                type Slot = Self;
            }
            #[allow(private_bounds)]
            impl #declared ::bessemer::generate::DslType for #name #arguments #bounds {
                fn ty(cx: &mut ::bessemer::generate::Builder) -> ::bessemer::generate::tree::Ty {
                    let arguments = #told;
                    cx.definition(
                        ::bessemer::generate::Named { module: ::core::module_path!(), file: ::core::file!(), name: #text },
                        &[#(#docs),*], (#line, #column), arguments,
                        |cx| #kind,
                    )
                }
            }
            #registered
        };
    }
}

fn data_enum(kind: Kind, it: &syn::ItemEnum, refusals: &mut Refusals) -> TokenStream {
    for parameter in &it.generics.params {
        refusals.add(parameter.span(), refuse::GENERIC_ENUM);
    }
    lower::check_attributes(&it.attrs, refusals);
    if kind == Kind::Component {
        refusals.add(it.enum_token.span, refuse::COMPONENT_ENUM);
    }
    if it.variants.is_empty() {
        refusals.add(it.ident.span(), refuse::EMPTY_ENUM);
    }
    for variant in &it.variants {
        lower::check_attributes(&variant.attrs, refusals);
        if !matches!(variant.fields, syn::Fields::Unit) {
            refusals.add(variant.fields.span(), refuse::ENUM_PAYLOAD);
        }
        if let Some((_, value)) = &variant.discriminant {
            refusals.add(value.span(), refuse::DISCRIMINANT);
        }
    }
    if !refusals.is_empty() {
        return TokenStream::new();
    }
    let name = &it.ident;
    let variants: Vec<_> = it.variants.iter().map(|variant| &variant.ident).collect();
    let words = 0..variants.len() as u64;
    let first = variants[0];
    let words_again = words.clone();
    let plain = quote! {
        #[diagnostic::do_not_recommend]
        impl ::bessemer::Plain for #name {
            fn store(&self, out: &mut dyn ::core::ops::FnMut(u64)) {
                out(match self { #(#name::#variants => #words),* })
            }
            fn load(next: &mut dyn ::core::ops::FnMut() -> u64) -> Self {
                match next() { #(#words_again => #name::#variants,)* _ => #name::#first }
            }
        }
    };
    let definition = cfg!(feature = "generate").then(|| {
        let variants = it.variants.iter().map(|variant| {
            let (name, docs) = (lower::text(&variant.ident), docs::lines(&variant.attrs));
            quote! { ::bessemer::generate::variant(#name, &[#(#docs),*]) }
        });
        let kind = quote! {
            ::bessemer::generate::tree::DefinitionKind::Enum(::bessemer::generate::list([#(#variants),*]))
        };
        definition(name, Scope::of_type(&it.generics), &TokenStream::new(), &it.attrs, kind)
    });
    quote! { #plain #definition }
}

/// The `impl` block as Rust runs it, and what stands beside it.
fn methods(
    kind: Kind,
    mut it: syn::ItemImpl,
    refusals: &mut Refusals,
) -> (TokenStream, TokenStream) {
    refuse_lifetimes(&it.generics, refusals);
    if it.trait_.is_some() {
        return interface::implementation(kind, it, refusals);
    }
    let mut beside = TokenStream::new();
    let (mut owned, mut faces) = (Vec::new(), Vec::new());
    for item in &mut it.items {
        let method = match item {
            syn::ImplItem::Fn(method) => method,
            syn::ImplItem::Const(_) => continue,
            other => {
                refusals.add(refuse::first_token(other), refuse::IMPL_ITEM);
                continue;
            }
        };
        let mut refusals = Refusals::default();
        let role = role(kind, &mut method.attrs, &mut refusals);
        let subject = Subject {
            attributes: &method.attrs,
            visibility: &method.vis,
            signature: &method.sig,
            body: &method.block,
            role,
            home: Home::Block,
        };
        beside.extend(builder::method(&it.self_ty, &it.generics, &subject, &mut refusals));
        let generic = Scope::of_function(&method.sig.generics).is_generic();
        if !generic
            && (matches!(role, Role::Entry { .. })
                || instance::is_public(&method.vis) && kind == Kind::Data)
        {
            faces.push(builder::build_name(&method.sig.ident));
        }
        owned.extend(alias(method));
        if refusals.is_empty() {
            redirect::block(&mut method.block);
        } else {
            refuse_body(&mut method.attrs, &mut method.block, refusals);
        }
    }
    it.items.extend(owned);
    beside.extend(instance::one_block(&it, &faces));
    (it.into_token_stream(), beside)
}

/// A method of the author's whose name the DSL owns: calls of it were redirected, so it answers to
/// that name as well.
fn alias(method: &syn::ImplItemFn) -> Option<syn::ImplItem> {
    let mut alias = method.clone();
    let name = &method.sig.ident;
    alias.sig.ident = redirect::owned(name)?;
    alias.attrs = vec![syn::parse_quote!(#[doc(hidden)]), syn::parse_quote!(#[allow(dead_code)])];
    let arguments = alias.sig.inputs.iter_mut().enumerate().map(|(index, input)| match input {
        syn::FnArg::Receiver(receiver) => receiver.self_token.to_token_stream(),
        syn::FnArg::Typed(typed) => {
            let name = quote::format_ident!("__{index}");
            *typed.pat = syn::parse_quote!(#name);
            name.into_token_stream()
        }
    });
    let arguments: Vec<_> = arguments.collect();
    alias.block = syn::parse_quote!({ Self::#name(#(#arguments),*) });
    Some(syn::ImplItem::Fn(alias))
}

/// Takes `#[entry]` off a method and says what the method is to its callers.
pub fn role(kind: Kind, attributes: &mut Vec<syn::Attribute>, refusals: &mut Refusals) -> Role {
    let mut role = match kind {
        Kind::Data => Role::Public,
        Kind::Component => Role::Private,
    };
    attributes.retain(|attribute| {
        if !attribute.path().is_ident("entry") {
            return true;
        }
        let infallible = match &attribute.meta {
            syn::Meta::List(list) if list.tokens.to_string() == "infallible" => true,
            syn::Meta::Path(_) => false,
            other => {
                refusals.add(other.path().span(), refuse::ENTRY_ARGUMENT);
                false
            }
        };
        if kind == Kind::Data {
            refusals.add(attribute.path().span(), refuse::ENTRY_OF_DATA);
        }
        role = Role::Entry { infallible };
        false
    });
    role
}
