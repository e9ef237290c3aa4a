//! The attribute macros: `#[data]`, `#[component]`, `#[function]`, `#[interface]`, `#[entry]`.
//!
//! Each leaves the Rust item as written, save that scalar methods go to the DSL ([`redirect`]), and
//! refuses at its own token what the DSL does not take ([`lower`]). In a generation build (feature
//! `generate`) it adds the builder of the item's tree ([`builder`]).
//!
//! Must not know: types. rustc supplies them through the witness slots of the builder.

mod attributes;
mod builder;
mod closures;
mod data;
mod docs;
mod function;
mod generics;
mod given;
mod instance;
mod interface;
mod kind;
mod lower;
mod operators;
mod owned;
mod redirect;
mod table;

use proc_macro::TokenStream;

use kind::Kind;

/// Bytes of a stack for an expansion, of which only those that are used take memory: syntax nests as deep as the author's
/// expressions, a sum by a level for each term.
const STACK: usize = 1 << 28;

/// Expands on a stack of its own.
fn deep(expand: impl FnOnce() -> proc_macro2::TokenStream) -> TokenStream {
    stacker::grow(STACK, expand).into()
}

/// Plain data: a struct, an enum, or the `impl` block of one; a `const` or a `static` of which more is to be
/// said than its value.
///
/// The struct or enum becomes a C `typedef`; its methods become C functions, `pid_torque(…)` for
/// `Pid::torque`. Derives are the author's: `Clone`, `Copy`, `Debug`, `Default`, `PartialEq`.
#[proc_macro_attribute]
pub fn data(arguments: TokenStream, item: TokenStream) -> TokenStream {
    deep(|| data::expand(Kind::Data, arguments.into(), item.into()))
}

/// A component: a struct with the state of a controller or estimator, or its `impl` block.
///
/// `Default` gives the initial state, which the C's `…_init` sets. In the `impl` block, methods marked
/// `#[entry]` are what the firmware calls; the others stay private to the component's C file.
#[proc_macro_attribute]
pub fn component(arguments: TokenStream, item: TokenStream) -> TokenStream {
    deep(|| data::expand(Kind::Component, arguments.into(), item.into()))
}

/// A free function.
#[proc_macro_attribute]
pub fn function(arguments: TokenStream, item: TokenStream) -> TokenStream {
    deep(|| function::expand(arguments.into(), item.into()))
}

/// A function that the firmware brings in C; its body stands in for it in the simulation and in the tests.
///
/// `#[external(header = "board.h")]` includes the header and calls the function by its name, or by that of
/// `name = "…"`. The body must not fault. What the C then computes is the firmware's own: that it gives the
/// same bits as the stand-in rests on whoever wrote it, and the report says so.
#[proc_macro_attribute]
pub fn external(arguments: TokenStream, item: TokenStream) -> TokenStream {
    deep(|| function::expand_external(arguments.into(), item.into()))
}

/// What an item is called in the C, and where it is placed: `#[c(name = "pid_step", section = ".fast")]`.
///
/// It stands below `#[function]`, `#[data]` or `#[component]`: on a function, a type, a named instance, a
/// `const` or a `static`, and within these on methods, parameters, fields and variants. Functions and
/// constants have storage, and so sections; `result = "thrust"` names what a function gives through a
/// pointer. On its own it is an error.
#[proc_macro_attribute]
pub fn c(_arguments: TokenStream, item: TokenStream) -> TokenStream {
    alone(item.into(), lower::refuse::C_ALONE)
}

/// An interface: a trait whose methods a model calls on whatever implements it, decided when the C is
/// written.
///
/// A component or a function that is generic over `C: Controller` becomes C for each controller that it is
/// used with. Implementations are marked as their type is: `#[component] impl Controller for Pid`.
#[proc_macro_attribute]
pub fn interface(arguments: TokenStream, item: TokenStream) -> TokenStream {
    deep(|| interface::expand(arguments.into(), item.into()))
}

/// Marks a method of a `#[component]` as an entry point; `#[entry(infallible)]` claims that no fault
/// is left in it, which generation then proves.
///
/// Its meaning is the component's: on its own it is an error.
#[proc_macro_attribute]
pub fn entry(_arguments: TokenStream, item: TokenStream) -> TokenStream {
    alone(item.into(), lower::refuse::ENTRY_ALONE)
}

/// An attribute that means something only below another.
fn alone(item: proc_macro2::TokenStream, reason: lower::refuse::Reason) -> TokenStream {
    let mut refusals = lower::Refusals::default();
    refusals.add(lower::refuse::first_token(&item), reason);
    let error = refusals.into_tokens();
    quote::quote! { #error #item }.into()
}
