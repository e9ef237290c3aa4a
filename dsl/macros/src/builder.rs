//! The builder of one function's tree, and the companion that its callers' witness copies call.
//!
//! A builder holds a slot for each value, a closure that is type-checked and never called (the
//! witness copy), and then hands on the tree with the types that the slots were given. It is emitted
//! in generation builds only; the refusals come in every build.

use bessemer_ir::tree::{FunctionTree, Param, Role};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::docs;
use crate::lower::{self, Lowering, Parameter, Refusals};

/// A function as the author wrote it.
pub struct Subject<'a> {
    /// Its attributes: doc comments.
    pub attributes: &'a [syn::Attribute],
    /// Who may call it.
    pub visibility: &'a syn::Visibility,
    /// Its signature.
    pub signature: &'a syn::Signature,
    /// Its body.
    pub body: &'a syn::Block,
    /// What it is to its callers.
    pub role: Role,
    /// Whether it stands in an `impl` block.
    pub method: bool,
}

/// Refuses what the DSL does not take; in a generation build gives the items that stand beside a
/// free function. For a method see [`method`].
pub fn build(subject: &Subject<'_>, refusals: &mut Refusals) -> TokenStream {
    let Some(parts) = lower(subject, refusals) else { return TokenStream::new() };
    let (name, visibility) = (&subject.signature.ident, subject.visibility);
    let Parts { generics, parameters, result, builder } = parts;
    let call = format_ident!("__call", span = name.span());
    let build = build_name(name);
    let lower::Site(line, column) = lower::site(name);
    quote! {
        const _: () = {
            impl #name {
                #[doc(hidden)]
                #[allow(clippy::too_many_arguments, unused_variables, non_snake_case)]
                #visibility fn #call #generics(#(#parameters),*) -> ::bessemer::generate::Called<#name, #result> {
                    ::core::unreachable!()
                }
                #builder
            }
            impl ::bessemer::generate::Callee for #name {
                fn callee(cx: &mut ::bessemer::generate::Builder) -> ::bessemer::generate::tree::Callee {
                    Self::#build(cx)
                }
            }
            ::bessemer::generate::register! {
                ::bessemer::generate::Registered::new(::core::module_path!(), (#line, #column), ::bessemer::generate::function::<#name>)
            }
        };
    }
}

/// The items that stand beside the `impl` block of `owner` for one of its methods.
pub fn method(owner: &syn::Type, subject: &Subject<'_>, refusals: &mut Refusals) -> TokenStream {
    let Some(parts) = lower(subject, refusals) else { return TokenStream::new() };
    let (name, visibility) = (&subject.signature.ident, subject.visibility);
    let Parts { generics, parameters, result, builder } = parts;
    let companion = lower::companion_name(name);
    let marker = format_ident!("__method_{}", lower::text(name));
    let build = build_name(name);
    let lower::Site(line, column) = lower::site(name);
    quote! {
        const _: () = {
            #[doc(hidden)]
            #[allow(non_camel_case_types)]
            pub struct #marker;
            impl #owner {
                #[doc(hidden)]
                #[allow(clippy::too_many_arguments, unused_variables, non_snake_case)]
                #visibility fn #companion #generics(#(#parameters),*) -> ::bessemer::generate::Called<#marker, #result> {
                    ::core::unreachable!()
                }
                #builder
            }
            impl ::bessemer::generate::Callee for #marker {
                fn callee(cx: &mut ::bessemer::generate::Builder) -> ::bessemer::generate::tree::Callee {
                    <#owner>::#build(cx)
                }
            }
            ::bessemer::generate::register! {
                ::bessemer::generate::Registered::new(::core::module_path!(), (#line, #column), ::bessemer::generate::function::<#marker>)
            }
        };
    }
}

/// What the two kinds of companion are made of.
struct Parts {
    generics: TokenStream,
    parameters: Vec<TokenStream>,
    result: TokenStream,
    builder: TokenStream,
}

fn lower(subject: &Subject<'_>, refusals: &mut Refusals) -> Option<Parts> {
    lower::check_attributes(subject.attributes, refusals);
    let mut copy = subject.body.clone();
    let mut signature = subject.signature.clone();
    lower::strip(&mut signature, &mut copy, refusals);
    let signature = &signature;
    let parameters = lower::parameters(signature, refusals);
    let mut walk = Lowering::new(&signature.ident, subject.method, refusals);
    let mut params = Vec::new();
    for parameter in &parameters {
        walk.bind(&parameter.name);
        params.push(Param {
            name: parameter.name.clone(),
            slot: walk.slot(),
            site: parameter.site,
        });
    }
    let result = walk.slot();
    let body = walk.block(&mut copy);
    if !walk.refusals.is_empty() || !lower::GENERATING {
        return None;
    }
    let tree = FunctionTree {
        name: lower::text(&signature.ident),
        site: lower::site(&signature.ident),
        docs: docs::lines(subject.attributes),
        role: subject.role,
        params,
        result,
        body,
    };
    let builder = builder(subject, &tree, &parameters, &walk, &copy);
    Some(Parts {
        generics: companion_generics(signature),
        parameters: companion_parameters(signature),
        result: result_type(signature),
        builder,
    })
}

/// The name of the function that builds `name`.
fn build_name(name: &syn::Ident) -> syn::Ident {
    syn::Ident::new(&format!("__build_{}", lower::text(name)), proc_macro2::Span::call_site())
}

/// The building function: slots, the witness copy, and the tree with the slots' types.
fn builder(
    subject: &Subject<'_>,
    tree: &FunctionTree,
    parameters: &[Parameter],
    walk: &Lowering<'_>,
    copy: &syn::Block,
) -> TokenStream {
    let (slots, callees) = walk.counts();
    let slots: Vec<_> = (0..slots).map(lower::slot_name).collect();
    let callees: Vec<_> = (0..callees).map(lower::callee_name).collect();
    let patterns = parameters.iter().map(|parameter| &parameter.pattern);
    let types = parameters.iter().map(|parameter| &parameter.ty);
    let looks = tree.params.iter().zip(parameters).map(|(param, parameter)| {
        let (slot, name) = (lower::slot_name(param.slot), &parameter.ident);
        quote! { __look(&#slot, &#name); }
    });
    let constants = walk.constants.iter().map(|(slot, path)| {
        let slot = lower::slot_name(*slot);
        quote! { ::bessemer::generate::constant(cx, &#slot, #path) }
    });
    let items = &walk.items;
    let result = result_type(subject.signature);
    let result_slot = lower::slot_name(tree.result);
    // The tree is plain data: writing it cannot fail.
    let text = serde_json::to_string(tree).unwrap_or_default();
    let build = build_name(&subject.signature.ident);
    let name = lower::text(&subject.signature.ident);
    let owner = if subject.method {
        quote! { ::core::option::Option::Some(<Self as ::bessemer::generate::Named>::path()) }
    } else {
        quote! { ::core::option::Option::None }
    };
    quote! {
        #[doc(hidden)]
        #[allow(warnings, clippy::all)]
        fn #build(cx: &mut ::bessemer::generate::Builder) -> ::bessemer::generate::tree::Callee {
            use ::bessemer::generate::prelude::*;
            #(#items)*
            #(let #slots = ::bessemer::generate::Slot::new();)*
            #(let #callees = ::bessemer::generate::Slot::new();)*
            let _ = |#(#patterns: #types),*| -> #result {
                #(#looks)*
                #copy
            };
            __result::<#result>(&#result_slot);
            cx.function(
                ::core::module_path!(), ::core::file!(), #name, #owner, #text,
                |cx| ::bessemer::generate::Witness {
                    slots: ::bessemer::generate::list([#(#slots.ty(cx)),*]),
                    callees: ::bessemer::generate::list([#(#callees.callee(cx)),*]),
                    constants: ::bessemer::generate::list([#(#constants),*]),
                },
            )
        }
    }
}

fn companion_generics(signature: &syn::Signature) -> TokenStream {
    let generics = &signature.generics;
    quote! { #generics }
}

fn companion_parameters(signature: &syn::Signature) -> Vec<TokenStream> {
    signature
        .inputs
        .iter()
        .enumerate()
        .map(|(index, input)| match input {
            syn::FnArg::Receiver(it) => quote! { #it },
            syn::FnArg::Typed(it) => {
                let (name, ty) = (format_ident!("__{index}"), &it.ty);
                quote! { #name: #ty }
            }
        })
        .collect()
}

fn result_type(signature: &syn::Signature) -> TokenStream {
    match &signature.output {
        syn::ReturnType::Default => quote! { () },
        syn::ReturnType::Type(_, ty) => quote! { #ty },
    }
}
