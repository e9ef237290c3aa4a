//! `#[data]` and `#[component]`: structs, enums and their `impl` blocks.
//!
//! Every build gets `Plain` (values as words). A generation build also gets the definition of the
//! type and the builders of its methods.

use bessemer_ir::tree::Role;
use proc_macro2::TokenStream;
use quote::{ToTokens, quote, quote_spanned};
use syn::spanned::Spanned;

use crate::builder::{self, Subject};
use crate::docs;
use crate::function::refuse_body;
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

fn refuse_generics(generics: &syn::Generics, refusals: &mut Refusals) -> bool {
    for parameter in &generics.params {
        let reason = match parameter {
            syn::GenericParam::Lifetime(_) => refuse::REFERENCE_FIELD,
            _ => refuse::GENERIC,
        };
        refusals.add(parameter.span(), reason);
    }
    !generics.params.is_empty()
}

fn data_struct(kind: Kind, it: &syn::ItemStruct, refusals: &mut Refusals) -> TokenStream {
    let generic = refuse_generics(&it.generics, refusals);
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
    if generic || !refusals.is_empty() {
        return TokenStream::new();
    }
    let name = &it.ident;
    let idents: Vec<_> = fields.named.iter().filter_map(|field| field.ident.as_ref()).collect();
    let types: Vec<_> = fields.named.iter().map(|field| &field.ty).collect();
    // Spanned at the field's type: a type that is not plain is told there.
    let store = idents.iter().zip(&types).map(|(ident, ty)| {
        quote_spanned! { ty.span() => <#ty as ::bessemer::Plain>::store(&self.#ident, out); }
    });
    let load = idents.iter().zip(&types).map(|(ident, ty)| {
        quote_spanned! { ty.span() => #ident: <#ty as ::bessemer::Plain>::load(next) }
    });
    let plain = quote! {
        #[diagnostic::do_not_recommend]
        impl ::bessemer::Plain for #name {
            fn store(&self, out: &mut dyn ::core::ops::FnMut(u64)) { #(#store)* }
            fn load(next: &mut dyn ::core::ops::FnMut() -> u64) -> Self {
                Self { #(#load),* }
            }
        }
    };
    let initial = (kind == Kind::Component).then(|| {
        quote_spanned! { name.span() =>
            const _: fn() -> #name = <#name as ::core::default::Default>::default;
        }
    });
    let definition = cfg!(feature = "generate").then(|| struct_definition(kind, it, fields));
    quote! { #plain #initial #definition }
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
            ::core::option::Option::Some(::bessemer::generate::words(&<#name as ::core::default::Default>::default()))
        },
    };
    let kind = quote! {
        ::bessemer::generate::tree::DefinitionKind::Struct {
            fields: ::bessemer::generate::list([#(#fields),*]),
            initial: #initial,
        }
    };
    definition(name, &it.attrs, kind)
}

/// The definition of a type, and its registration.
fn definition(name: &syn::Ident, attributes: &[syn::Attribute], kind: TokenStream) -> TokenStream {
    let docs = docs::lines(attributes);
    let lower::Site(line, column) = lower::site(name);
    let text = lower::text(name);
    quote! {
        const _: () = {
            impl ::bessemer::generate::Named for #name {
                fn path() -> ::bessemer::generate::String {
                    ::bessemer::generate::path(::core::module_path!(), #text)
                }
            }
            impl ::bessemer::generate::Seen for #name {
                type Slot = #name;
            }
            impl ::bessemer::generate::DslType for #name {
                fn ty(cx: &mut ::bessemer::generate::Builder) -> ::bessemer::generate::tree::Ty {
                    cx.definition(
                        <Self as ::bessemer::generate::Named>::path(),
                        &[#(#docs),*], ::core::file!(), (#line, #column),
                        |cx| #kind,
                    )
                }
            }
            ::bessemer::generate::register! {
                ::bessemer::generate::Registered::new(::core::module_path!(), (#line, #column), ::bessemer::generate::data::<#name>)
            }
        };
    }
}

fn data_enum(kind: Kind, it: &syn::ItemEnum, refusals: &mut Refusals) -> TokenStream {
    let generic = refuse_generics(&it.generics, refusals);
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
    if generic || !refusals.is_empty() {
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
        definition(name, &it.attrs, kind)
    });
    quote! { #plain #definition }
}

/// The `impl` block as Rust runs it, and what stands beside it.
fn methods(
    kind: Kind,
    mut it: syn::ItemImpl,
    refusals: &mut Refusals,
) -> (TokenStream, TokenStream) {
    refuse_generics(&it.generics, refusals);
    if let Some((path, _)) = &it.trait_ {
        refusals.add(path.span(), refuse::TRAIT_IMPL);
    }
    let mut beside = TokenStream::new();
    let mut owned = Vec::new();
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
            method: true,
        };
        beside.extend(builder::method(&it.self_ty, &subject, &mut refusals));
        owned.extend(alias(method));
        if refusals.is_empty() {
            redirect::block(&mut method.block);
        } else {
            refuse_body(&mut method.attrs, &mut method.block, refusals);
        }
    }
    it.items.extend(owned);
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
fn role(kind: Kind, attributes: &mut Vec<syn::Attribute>, refusals: &mut Refusals) -> Role {
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
