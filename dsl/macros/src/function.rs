//! Expands attributes of free functions: the native item, its marker, and in a generation build the builder.

use bessemer_tree::Role;
use bessemer_tree::attributes::Attributes;
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use crate::attributes::{self, Asked};
use crate::builder::{self, Home, Subject};
use crate::generics::Scope;
use crate::imports;
use crate::lower::{self, Refusals, refuse};
use crate::redirect;

/// `#[function]`; with `expand` the body replaces each call. With `rewrite` it does so as if its caller had written the
/// body: its types are those of the call, which the DSL need not know.
pub fn expand(arguments: TokenStream, item: TokenStream) -> TokenStream {
    let mut refusals = Refusals::default();
    let word = syn::parse2::<syn::Ident>(arguments.clone()).map(|it| it.to_string());
    let role = match word.as_deref() {
        Ok("expand") => Role::Expanded,
        Ok("rewrite") => Role::Rewritten,
        _ => Role::Public,
    };
    let depth = attributes::depth(&arguments);
    let derivative = attributes::derivative(&arguments);
    let is_derivative = syn::parse2::<syn::Meta>(arguments.clone())
        .is_ok_and(|it| ["derivative", "gradient"].iter().any(|name| it.path().is_ident(name)));
    if is_derivative && derivative.is_none() {
        refusals.add(&arguments, refuse::DERIVATIVE);
    } else if !arguments.is_empty() && role == Role::Public && depth == 0 && !is_derivative {
        refusals.add(&arguments, refuse::ARGUMENTS);
    }
    // rustc reports a function that does not exist at the author's path, and takes one that does for used.
    let named = derivative.as_ref().map(|(_, of)| quote! { const _: () = { let _ = #of; }; });
    let item = marked(item, refusals, depth, |function, refusals| {
        if role != Role::Public {
            lower::without_returns(&function.block, refusals);
        }
        Asked { derivative: derivative.map(|it| it.0), ..Asked::new(role, Attributes::default()) }
    });
    quote! { #item #named }
}

/// Expands `#[external]`.
pub fn expand_external(arguments: TokenStream, item: TokenStream) -> TokenStream {
    marked(item, Refusals::default(), 0, |function, refusals| {
        Asked::new(Role::Public, attributes::external(&arguments, function, refusals))
    })
}

/// Returns a free function with its attributes; `depth` is its nesting depth in other functions.
fn marked(
    item: TokenStream,
    mut refusals: Refusals,
    depth: u32,
    more: impl FnOnce(&syn::ItemFn, &mut Refusals) -> Asked,
) -> TokenStream {
    let mut function = match syn::parse2::<syn::Item>(item.clone()) {
        Ok(syn::Item::Fn(function)) => function,
        Ok(other) => {
            let reason = match &other {
                syn::Item::Const(_) | syn::Item::Static(_) => refuse::NO_FUNCTION_BUT_A_CONSTANT,
                _ => refuse::NOT_A_FUNCTION,
            };
            refusals.add(refuse::first_token(&other), reason);
            return with_errors(refusals, item);
        }
        Err(error) => return with_errors(Refusals::from(error), item),
    };
    if let Some(receiver) = function.sig.receiver() {
        refusals.add(receiver.self_token.span, refuse::METHOD_ALONE);
        return with_errors(refusals, item);
    }
    if bessemer_tree::number::is_number(&function.sig.ident.to_string()) {
        refusals.add(&function.sig.ident, refuse::RUST_TYPE);
        return with_errors(refusals, item);
    }
    imports::write_out(&function.sig, &mut function.block);
    let more = more(&function, &mut refusals);
    let mut found =
        attributes::of_function(&mut function, more.attributes.external.is_some(), &mut refusals);
    if more.attributes.external.is_some() {
        let Attributes { parameters, result, .. } = found.attributes;
        let attributes = Attributes { parameters, result, ..more.attributes };
        found = Asked::new(Role::Public, attributes);
    } else if more.role != Role::Public {
        found.role = more.role;
    }
    found.derivative = more.derivative;
    attributes::mark_inner(&mut function.block, depth + 1);
    let subject = Subject {
        attributes: &function.attrs,
        visibility: &function.vis,
        signature: &function.sig,
        body: &function.block,
        asked: found,
        home: if depth > 0 { Home::Function(depth) } else { Home::Module },
    };
    let builder = builder::build(&subject, &mut refusals);
    let (visibility, name) = (&function.vis, &function.sig.ident);
    // Carries the companion; here in every build, so that a clash of names shows in `cargo check`.
    let carrier = quote! {
        #[doc(hidden)]
        #[allow(non_camel_case_types, dead_code)]
        #visibility struct #name {}
    };
    let scope = Scope::of_function(&function.sig.generics);
    redirect::native((&mut function.attrs, &mut function.block), scope, refusals);
    let function = function.into_token_stream();
    quote! { #function #carrier #builder }
}

fn with_errors(refusals: Refusals, item: TokenStream) -> TokenStream {
    let errors = refusals.into_tokens();
    quote! { #errors #item }
}
