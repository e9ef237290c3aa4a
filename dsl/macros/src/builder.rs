//! Emits the builder of one function's tree, and the companion for its callers' witness copies.
//!
//! A builder contains the witness copy of the body ([`crate::witness`]), and returns the tree with the types in its
//! slots. It is emitted only in generation builds; refusals occur in every build.

use bessemer_tree::{FunctionTree, Role};
use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote};

use crate::attributes::{self, Asked};
use crate::closures;
use crate::docs;
use crate::generics::Scope;
use crate::implied;
use crate::imports;
use crate::lower::{self, Lowering, Parameter, Refusals, refuse};
use crate::numeric;
use crate::owned;
use crate::place::{self, named, registered};
use crate::witness::{Copy, result_type};

/// A function as the author wrote it.
pub struct Subject<'a> {
    /// Attributes, including doc comments.
    pub attributes: &'a [syn::Attribute],
    /// Visibility of the function.
    pub visibility: &'a syn::Visibility,
    /// Signature of the function.
    pub signature: &'a syn::Signature,
    /// Body of the function.
    pub body: &'a syn::Block,
    /// Role, and attributes for the C.
    pub asked: Asked,
    /// Context of its declaration.
    pub home: Home<'a>,
}

impl<'a> Subject<'a> {
    /// Returns the subject for a method.
    pub fn of(method: &'a syn::ImplItemFn, asked: Asked, home: Home<'a>) -> Subject<'a> {
        let syn::ImplItemFn {
            attrs: attributes, vis: visibility, sig: signature, block: body, ..
        } = method;
        Subject { attributes, visibility, signature, body, asked, home }
    }

    /// Returns the subject with another signature.
    fn with<'s>(&self, signature: &'s syn::Signature) -> Subject<'s>
    where
        'a: 's,
    {
        Subject { signature, asked: self.asked.clone(), ..*self }
    }
}

/// Context of a function's declaration.
#[derive(Clone, Copy)]
pub enum Home<'a> {
    /// In a module.
    Module,
    /// In the body of a function; nesting depth.
    Function(u32),
    /// In an `impl` block of a type.
    Block,
    /// In the definition of an interface.
    Interface(&'a syn::Ident),
    /// In an implementation of an interface.
    Implementation(&'a syn::Path),
    /// In an implementation of a standard trait, whose methods are identified by type.
    OfRust(&'a syn::Path),
}

/// Refuses code that the DSL does not support; in a generation build, returns the items beside a free function. For a
/// method see [`method`].
pub fn build(subject: &Subject<'_>, refusals: &mut Refusals) -> TokenStream {
    let signature = closures::with_names(subject.signature);
    let subject = &subject.with(&signature);
    let rewritten = subject.asked.role == Role::Rewritten;
    // A rule by which calls are rewritten is one whatever the types are.
    let generics = match rewritten {
        true => syn::Generics::default(),
        false => closures::without(&subject.signature.generics),
    };
    let scope = Scope::of_function(&generics);
    let Some(parts) = lower(subject, scope, refusals) else { return TokenStream::new() };
    let name = &subject.signature.ident;
    let call = format_ident!("__call", span = name.span());
    let marker = &function_marker(name, scope);
    let declared = scope.is_generic().then(|| declare_marker(marker, scope));
    let arguments = scope.arguments();
    let bounds = subject.signature.generics.where_clause.to_token_stream();
    let companion = companion(subject, &call, (&quote! { #marker #arguments }, &bounds), &parts);
    let callee = callee_by(marker, scope, None, &parts.builder);
    // A function inside another is built when the other calls it.
    let announced = !rewritten && matches!(subject.home, Home::Module);
    let register = announced.then(|| match scope.is_generic() {
        true => place::template(name, &quote! { Function }),
        false => register(name, marker, scope),
    });
    // `mod cossin` around `fn cossin`: behind an import the module hides the carrier of the same name.
    let within = announced && imports::in_module_of_its_name(name);
    let in_module = within.then_some(&companion);
    quote! {
        #declared
        #in_module
        const _: () = {
            impl #name { #companion }
            #callee
            #register
        };
    }
}

/// Returns the items beside the `impl` block of `owner` for one of its methods.
pub fn method(
    owner: &syn::Type,
    generics: &syn::Generics,
    subject: &Subject<'_>,
    refusals: &mut Refusals,
) -> TokenStream {
    let signature = closures::with_names(subject.signature);
    let subject = &subject.with(&signature);
    let own = closures::without(&subject.signature.generics);
    let scope = Scope::of_type(generics).with_method(&own);
    let Some(parts) = lower(subject, scope, refusals) else { return TokenStream::new() };
    let name = &subject.signature.ident;
    let marker = format_ident!("__method_{}", lower::text(name));
    let declared = declare_marker(&marker, scope);
    // A function of which calls are redirected by its type's name has a companion of the other name as well.
    let turns = lower::last_ident(owner).and_then(|owner| owned::of_turns(owner, name));
    let arguments = scope.arguments();
    let called = quote! { #marker #arguments };
    let bounds = subject.signature.generics.where_clause.to_token_stream();
    let companions = [Some(name.clone()), turns]
        .into_iter()
        .flatten()
        .map(|name| companion(subject, &lower::companion_name(&name), (&called, &bounds), &parts));
    let bound = owner_bound(scope, &quote! { #owner });
    let callee = callee(&quote! { <#owner> }, &marker, scope, bound, name);
    let register = match (scope.outer().is_generic(), lower::last_ident(owner)) {
        (true, Some(owner)) => place::generic_method(name, owner),
        _ if scope.own().is_generic() => place::template(name, &quote! { Method }),
        _ => register(name, &marker, scope),
    };
    let of_each =
        scope.outer().is_generic() && !scope.own().is_generic() && own.where_clause.is_none();
    let noted = implied::sign_of(&lower::text(name)).filter(|_| of_each).map(|of| {
        let build = build_name(name);
        let bound = (scope.outer(), owner_bound(scope, &quote! { #owner }));
        implied::noted(&of, (owner, owner), bound, &quote! { Self::#build })
    });
    let (of_block, bounds) = (scope.outer().declared(), scope.outer().bounds([]));
    let builder = &parts.builder;
    quote! {
        const _: () = {
            #declared
            impl #of_block #owner #bounds {
                #(#companions)*
                #builder
            }
            #callee
            #register
            #noted
        };
    }
}

/// Returns the marker of a free function in slots: a function that is not generic is its own marker.
pub fn function_marker(name: &syn::Ident, scope: Scope<'_>) -> syn::Ident {
    match scope.is_generic() {
        true => format_ident!("__function_{}", lower::text(name)),
        false => name.clone(),
    }
}

/// Declares the marker type that represents the function in slots.
pub fn declare_marker(marker: &syn::Ident, scope: Scope<'_>) -> TokenStream {
    let (parameters, types) = (scope.unbounded(), scope.types());
    quote! {
        #[doc(hidden)]
        #[allow(non_camel_case_types)]
        pub struct #marker #parameters(::core::marker::PhantomData<fn() -> (#(#types,)*)>);
    }
}

/// Returns the companion of the function that `marker` represents.
pub fn companion(
    subject: &Subject<'_>,
    name: &syn::Ident,
    (marker, bounds): (&TokenStream, &TokenStream),
    parts: &Parts,
) -> TokenStream {
    let Parts { parameters, result, .. } = parts;
    let (generics, visibility) = (&subject.signature.generics, subject.visibility);
    quote! {
        #[doc(hidden)]
        #[inline]
        #[allow(clippy::too_many_arguments, unused_variables, unused_mut, non_snake_case)]
        #visibility fn #name #generics(#(#parameters),*) -> ::bessemer::generate::Called<#marker, #result>
        #bounds
        {
            ::core::unreachable!()
        }
    }
}

/// Implements the trait by which a marker builds its function.
pub fn callee(
    owner: &TokenStream,
    marker: &syn::Ident,
    scope: Scope<'_>,
    bound: Option<TokenStream>,
    name: &syn::Ident,
) -> TokenStream {
    let (build, own) = (build_name(name), scope.own().turbofish());
    let build = quote! {
        fn callee(__cx: &mut ::bessemer::generate::Builder) -> ::bessemer::generate::tree::Callee {
            #owner::#build #own(__cx)
        }
    };
    callee_by(marker, scope, bound, &build)
}

/// Implements that trait with the function `build`.
fn callee_by(
    marker: &syn::Ident,
    scope: Scope<'_>,
    bound: Option<TokenStream>,
    build: &TokenStream,
) -> TokenStream {
    let (declared, arguments) = (scope.declared(), scope.arguments());
    let bounds = scope.value_bounds(bound);
    quote! {
        #[allow(private_bounds)]
        impl #declared ::bessemer::generate::Callee for #marker #arguments #bounds { #build }
    }
}

/// Returns the item that registers a function with its package. Instances of a generic function are built where they
/// are called.
fn register(name: &syn::Ident, marker: &syn::Ident, scope: Scope<'_>) -> TokenStream {
    if scope.is_generic() {
        return TokenStream::new();
    }
    registered(name, &quote! { Function(<#marker as ::bessemer::generate::Callee>::callee) })
}

/// Parts of a companion.
pub struct Parts {
    /// Parameters, each with a unique name.
    pub parameters: Vec<TokenStream>,
    /// Result type.
    pub result: TokenStream,
    /// Building function.
    pub builder: TokenStream,
}

pub fn lower(subject: &Subject<'_>, scope: Scope<'_>, refusals: &mut Refusals) -> Option<Parts> {
    lower::check_attributes(subject.attributes, refusals);
    lower::check_hygiene(subject.signature, subject.body, refusals);
    if let (true, Some(reason)) =
        (scope.is_generic(), attributes::of_one_instance(&subject.asked.attributes))
    {
        refusals.add(&subject.signature.ident, reason);
    }
    let mut copy = subject.body.clone();
    let mut signature = subject.signature.clone();
    lower::strip(&mut signature, &mut copy, refusals);
    lower::name_parts(&mut signature, &mut copy);
    let is_entry = matches!(subject.asked.role, Role::Entry { .. });
    let open = matches!(subject.home, Home::Interface(_) | Home::Implementation(_));
    let outside = is_entry || open || subject.asked.attributes.external.is_some();
    let items = lower::items(subject.signature);
    if let (Some(_), true) = (items, outside) {
        refusals.add(&subject.signature.output, refuse::ITERATOR_OUTSIDE);
        return None;
    }
    let generates = lower::hand_on(&mut signature, &mut copy, refusals);
    let signature = &signature;
    let before = refusals.len();
    if is_entry && scope.own().is_generic() {
        refusals.add(&subject.signature.generics, refuse::ENTRY_GENERIC);
    }
    let mut parameters = lower::parameters(signature, refusals);
    let implements = matches!(subject.home, Home::Implementation(_) | Home::OfRust(_));
    let name = Some(&signature.ident).filter(|_| !implements);
    let mut walk = Lowering::new(name, subject.is_method(), std::mem::take(refusals));
    walk.mutable = lower::mutable_names(signature, &copy);
    walk.aliases = lower::Aliases::of(&copy);
    for Parameter { param, ident, place, .. } in &mut parameters {
        if param.items && outside {
            walk.refusals.add(*place, refuse::ITERATOR_OUTSIDE);
        } else if open && param.closure {
            walk.refusals.add(&*ident, refuse::INTERFACE_CLOSURE);
        } else if is_entry && param.closure {
            walk.refusals.add(*place, refuse::ENTRY_CLOSURE);
        }
        walk.bind(&param.name);
        walk.called.extend(param.closure.then(|| param.name.clone()));
        param.slot = walk.slot();
    }
    if lower::gives_reference(signature) {
        check_lending(subject, &parameters, &mut walk.refusals);
    }
    let result = walk.slot();
    let signature_refused = walk.refusals.len();
    let expands = generates || parameters.iter().any(|it| it.param.items);
    let body = match expands && !generates {
        true => walk.expanded_body(&mut copy, (signature, result)),
        false => walk.block(&mut copy),
    };
    let end = walk.here(copy.stmts.len());
    walk.begins.push(end);
    if subject.asked.role == Role::Rewritten && end.callees > 0 {
        // What it calls is known by numbers of its own, which mean others at its place.
        walk.refusals.add(&subject.signature.ident, refuse::REWRITTEN_CALL);
    }
    if signature_refused > before {
        // What the signature does not take, the body goes on with.
        walk.refusals.forget_since(signature_refused);
    }
    *refusals = std::mem::take(&mut walk.refusals);
    if !refusals.is_empty() || !lower::generating() {
        return None;
    }
    let tree = FunctionTree {
        name: lower::text(&signature.ident),
        site: lower::site(&signature.ident),
        docs: docs::lines(subject.attributes),
        role: if expands { Role::Expanded } else { subject.asked.role },
        attributes: subject.asked.attributes.clone(),
        params: parameters.iter().map(|it| it.param.clone()).collect(),
        result,
        body,
        operators: std::mem::take(&mut walk.operators),
        derivative: subject.asked.derivative.clone(),
    };
    let builder = builder(subject, scope, &tree, &parameters, &walk, (signature, &copy));
    // A reference has the lifetime that its author wrote, and so has an iterator.
    let named = items.is_some() || expands || lower::borrows(signature);
    let told = if named { subject.signature } else { signature };
    let result = match items {
        Some(item) => quote! { ::bessemer::generate::Items<#item> },
        None => result_type(told),
    };
    Some(Parts { parameters: companion_parameters(told), result, builder })
}

/// Refuses references in the results of entry points, external functions, and functions with closures.
fn check_lending(subject: &Subject<'_>, parameters: &[Parameter], refusals: &mut Refusals) {
    let syn::ReturnType::Type(_, ty) = &subject.signature.output else { return };
    let outside = matches!(subject.asked.role, Role::Entry { .. });
    if outside || subject.asked.attributes.external.is_some() {
        refusals.add(ty, refuse::RETURNED_REFERENCE);
    }
    if !lower::lends(subject.signature) {
        return;
    }
    if parameters.iter().any(|it| it.param.closure) {
        refusals.add(ty, refuse::LENT_CLOSURE);
    }
}

/// Returns the name of the function that builds `name`.
pub fn build_name(name: &syn::Ident) -> syn::Ident {
    syn::Ident::new(&format!("__build_{}", lower::text(name)), proc_macro2::Span::call_site())
}

/// Returns the building function: the witness copy, and the tree with the types of its slots.
fn builder(
    subject: &Subject<'_>,
    scope: Scope<'_>,
    tree: &FunctionTree,
    parameters: &[Parameter],
    walk: &Lowering,
    (signature, copy): (&syn::Signature, &syn::Block),
) -> TokenStream {
    let witness = Copy { parameters, result: tree.result, signature, body: copy };
    let rewritten = subject.asked.role == Role::Rewritten;
    let parts = (!rewritten).then(|| witness.parts(walk));
    let items = &walk.items;
    let macros = walk.macros.iter().map(lower::asked);
    // The tree is plain data: writing it cannot fail.
    let text = serde_json::to_string(tree).unwrap_or_default();
    // What is no method is built where its marker says how: one function less for rustc.
    let (build, declared, bounds) = match subject.home {
        Home::Module | Home::Function(_) => {
            (format_ident!("callee"), TokenStream::new(), TokenStream::new())
        }
        _ => {
            let build = build_name(&subject.signature.ident);
            (build, scope.own().declared(), build_bounds(subject, scope))
        }
    };
    let named = named(&subject.signature.ident);
    let owner = if subject.is_method() {
        quote! { ::core::option::Option::Some(<Self as ::bessemer::generate::DslType>::ty(__cx)) }
    } else {
        quote! { ::core::option::Option::None }
    };
    // Where the methods of a generic type are built, what its implementations request is known.
    let of_instance = subject.is_method() && !matches!(subject.home, Home::Interface(_));
    let implied =
        (of_instance && scope.outer().is_generic()).then(|| implied::ask(&quote! { Self }));
    let (told, own) = (scope.told(), scope.own().told());
    let interface = interface(subject.home, scope);
    let depth = match subject.home {
        Home::Function(depth) => depth,
        _ => 0,
    };
    // Those of other traits are bounds of the types.
    let floats = scope.numbers().into_iter().next().map(|name| {
        let [companions, methods] =
            ["Builtins", "Methods"].map(|kind| format_ident!("{name}{kind}"));
        quote! {
            use ::bessemer::generate::generic::#companions as _;
            use ::bessemer::math::#methods as _;
        }
    });
    // A type parameter has the traits of its bounds, of which several may have a function of the name.
    let known = scope.types().next().is_none();
    let numeric = known.then(|| numeric::of_known(subject.body, subject.signature.ident.span()));
    let numeric = numeric.into_iter().flatten();
    quote! {
        #[doc(hidden)]
        #[allow(warnings, clippy::all)]
        fn #build #declared(__cx: &mut ::bessemer::generate::Builder) -> ::bessemer::generate::tree::Callee
        #bounds
        {
            use ::bessemer::generate::prelude::*;
            #floats
            #(use ::bessemer::generate::numeric::#numeric as _;)*
            #(#items)*
            #(#macros)*
            let __owner = #owner;
            #implied
            let __generics = ::bessemer::generate::Generics { scope: #told, own: #own, interface: #interface, depth: #depth };
            __cx.function(
                #named, __owner, __generics, #text,
                &|__cx: &mut ::bessemer::generate::Builder, __told: &mut ::bessemer::generate::Witness| { #parts },
            )
        }
    }
}

/// Returns the bounds of a builder on the types in its scope, except those that an `impl` block has.
pub fn build_bounds(subject: &Subject<'_>, scope: Scope<'_>) -> TokenStream {
    let this = || quote! { Self: ::bessemer::generate::Value };
    let types = || scope.values();
    match subject.home {
        Home::Module | Home::Function(_) | Home::Block => {
            scope.own().bounds(types().chain(owner_bound(scope, &quote! { Self })))
        }
        Home::Interface(_) => scope.own().bounds(types().chain([this()])),
        Home::Implementation(_) | Home::OfRust(_) => {
            let within = match subject.home {
                Home::Implementation(path) => Some(scope.outer().values_within(path)),
                _ => None,
            };
            let types = scope.own().values().chain(within.into_iter().flatten());
            // What borrows is one for its longest lifetime alone, which only those who call know to be meant.
            let owns = scope.lifetimes().next().is_none();
            scope.own().bounds(types.chain(owns.then(this)))
        }
    }
}

/// Returns the bound that a generic type is a type of the DSL. It may require more of its parameters than its methods
/// do; a component, for example, its initial state.
pub fn owner_bound(scope: Scope<'_>, owner: &TokenStream) -> Option<TokenStream> {
    scope.outer().is_generic().then(|| quote! { #owner: ::bessemer::generate::DslType })
}

/// Returns the interface of a function, with arguments for its parameters.
fn interface(home: Home<'_>, scope: Scope<'_>) -> TokenStream {
    let (name, told, module) = match home {
        Home::Module | Home::Function(_) | Home::Block => {
            return quote! { ::core::option::Option::None };
        }
        Home::Interface(name) => {
            (lower::text(name), scope.outer().told(), quote! { ::core::module_path!() })
        }
        Home::Implementation(path) | Home::OfRust(path) => {
            let name = path.segments.last().map(|last| lower::text(&last.ident));
            let module = match home {
                Home::OfRust(_) => quote! { "core" },
                _ => quote! { <Self as #path>::__marked_interface() },
            };
            (name.unwrap_or_default(), scope.told_of(path), module)
        }
    };
    quote! { ::core::option::Option::Some((#name, #told, #module)) }
}

impl Subject<'_> {
    fn is_method(&self) -> bool {
        !matches!(self.home, Home::Module | Home::Function(_))
    }
}

/// Returns the parameters of a companion.
pub fn companion_parameters(signature: &syn::Signature) -> Vec<TokenStream> {
    signature
        .inputs
        .iter()
        .enumerate()
        .map(|(index, input)| match input {
            syn::FnArg::Receiver(it) => {
                let bare = syn::Receiver { attrs: Vec::new(), ..it.clone() };
                quote! { #bare }
            }
            syn::FnArg::Typed(it) => {
                let (name, ty) = (format_ident!("__{index}"), &it.ty);
                quote! { #name: #ty }
            }
        })
        .collect()
}
