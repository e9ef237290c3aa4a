//! The attribute macros: `#[data]`, `#[component]`, `#[function]`, `#[interface]`, `#[entry]`.
//!
//! Each leaves the Rust item as written, save that scalar methods go to the DSL ([`redirect`]), and
//! refuses at its own token what the DSL does not take ([`lower`]). In a generation build (feature
//! `generate`) it adds the builder of the item's tree ([`builder`]).
//!
//! Must not know: types. rustc supplies them through the witness slots of the builder.

mod builder;
mod data;
mod docs;
mod function;
mod generics;
mod instance;
mod interface;
mod lower;
mod redirect;

use proc_macro::TokenStream;

/// Plain data: a struct with named fields, an enum without payload, or the `impl` block of one.
///
/// The struct or enum becomes a C `typedef`; its methods become C functions, `pid_torque(…)` for
/// `Pid::torque`. Derives are the author's: `Clone`, `Copy`, `Debug`, `Default`, `PartialEq`.
#[proc_macro_attribute]
pub fn data(arguments: TokenStream, item: TokenStream) -> TokenStream {
    data::expand(data::Kind::Data, arguments.into(), item.into()).into()
}

/// A component: a struct with the state of a controller or estimator, or its `impl` block.
///
/// `Default` gives the initial state, which the C's `…_init` sets. In the `impl` block, methods marked
/// `#[entry]` are what the firmware calls; the others stay private to the component's C file.
#[proc_macro_attribute]
pub fn component(arguments: TokenStream, item: TokenStream) -> TokenStream {
    data::expand(data::Kind::Component, arguments.into(), item.into()).into()
}

/// A free function.
#[proc_macro_attribute]
pub fn function(arguments: TokenStream, item: TokenStream) -> TokenStream {
    function::expand(arguments.into(), item.into()).into()
}

/// An interface: a trait whose methods a model calls on whatever implements it, decided when the C is
/// written.
///
/// A component or a function that is generic over `C: Controller` becomes C for each controller that it is
/// used with. Implementations are marked as their type is: `#[component] impl Controller for Pid`.
#[proc_macro_attribute]
pub fn interface(arguments: TokenStream, item: TokenStream) -> TokenStream {
    interface::expand(arguments.into(), item.into()).into()
}

/// Marks a method of a `#[component]` as an entry point; `#[entry(infallible)]` claims that no fault
/// is left in it, which generation then proves.
///
/// Its meaning is the component's: on its own it is an error.
#[proc_macro_attribute]
pub fn entry(_arguments: TokenStream, item: TokenStream) -> TokenStream {
    let item: proc_macro2::TokenStream = item.into();
    let mut refusals = lower::Refusals::default();
    refusals.add(lower::refuse::first_token(&item), lower::refuse::ENTRY_ALONE);
    let error = refusals.into_tokens();
    quote::quote! { #error #item }.into()
}
