//! Attribute macros: `#[data]`, `#[component]`, `#[function]`, `#[interface]`, `#[entry]`.
//!
//! Each leaves the Rust item as written, except that scalar methods are redirected to the DSL ([`redirect`]). It
//! refuses unsupported code at its own token ([`lower`]). In a generation build it adds the builder of the item's
//! tree ([`builder`]); the DSL then exports other macros under these names, so that one build of this crate serves
//! both.
//!
//! Must not know: types. rustc supplies them through the witness slots of the builder.

mod attributes;
mod builder;
mod closures;
mod conditions;
mod configured;
mod data;
mod defaults;
mod docs;
mod expression;
mod function;
mod generics;
mod given;
mod implied;
mod imports;
mod instance;
mod interface;
mod kind;
mod library;
mod lower;
mod numeric;
mod operators;
mod own_numbers;
mod owned;
mod place;
mod redirect;
mod sizes;
mod state;
mod table;
mod witness;
mod words;

use proc_macro::TokenStream;

use kind::Kind;

/// Stack size of an expansion, in bytes, which takes memory only as used. Syntax nests as deep as the author's
/// expressions: a sum has a level for each term.
const STACK: usize = 1 << 28;

/// Expands an attribute, once rustc has acted on the conditions within its item.
fn expanded(
    attribute: &str,
    arguments: TokenStream,
    item: TokenStream,
    expand: impl FnOnce(proc_macro2::TokenStream, proc_macro2::TokenStream) -> proc_macro2::TokenStream,
) -> TokenStream {
    let (arguments, item) = (arguments.into(), item.into());
    deep(|| match configured::detour(attribute, &arguments, &item) {
        Some(detour) => detour,
        None => {
            let uses = imports::uses(&item);
            let item = expand(arguments, item);
            quote::quote! { #item #uses }
        }
    })
}

/// Returns the item of a detour with rustc's decisions on the conditions within.
#[doc(hidden)]
#[proc_macro_derive(__Configured)]
pub fn configured(holder: TokenStream) -> TokenStream {
    deep(|| configured::configured(holder.into()))
}

/// Removes the enum of a detour.
#[doc(hidden)]
#[proc_macro_attribute]
pub fn __removed(_arguments: TokenStream, _holder: TokenStream) -> TokenStream {
    TokenStream::new()
}

/// Indices, retraction and difference of the state of an estimator: a struct of numbers, vectors and rotations.
///
/// Each field is a block of errors: as many as it has elements, or three for a `UnitQuaternion`, a rotation vector about the
/// body's axes, rad. The struct gets
///
/// * a constant for the first index of each block, `VELOCITY` of `velocity`, and `ERRORS`, the number of all;
/// * `retracted(&errors)`, the state moved by errors, and `difference(&from)`, the errors that move `from` to it:
///   `from.retracted(&to.difference(&from))` is `to`, up to rounding;
/// * `vector()` and `of_vector(&vector)`, if no block is a rotation.
///
/// # Example
///
/// ```
/// use bessemer::prelude::*;
///
/// /// State of a vehicle.
/// #[data]
/// #[derive(Clone, Copy, Debug, Default, PartialEq, State)]
/// pub struct Motion {
///     /// From the body's frame to the world's.
///     pub attitude: UnitQuaternion<f64>,
///     /// Velocity, m/s.
///     pub velocity: Vector3<f64>,
///     /// Bias of the barometer, m.
///     pub bias: f64,
/// }
///
/// assert_eq!((Motion::ATTITUDE, Motion::VELOCITY, Motion::BIAS, Motion::ERRORS), (0, 3, 6, 7));
/// let mut errors = SVector::<f64, { Motion::ERRORS }>::zeros();
/// errors[Motion::VELOCITY + 2] = 0.5;
/// let moved = Motion::default().retracted(&errors);
/// assert_eq!(moved.velocity, Vector3::new(0.0, 0.0, 0.5));
/// assert_eq!(moved.difference(&Motion::default()), errors);
/// ```
///
/// In the C the methods are functions as any other, `motion_retracted(…)`. The indices are in the header of sizes, with the module's name before
/// them: `FLIGHT_MOTION_VELOCITY` for a module `flight`. A generic state has them for each instance: `FLIGHT_AXIS_F64_RATES`, or with the name of a marked
/// alias.
#[proc_macro_derive(State)]
pub fn state(item: TokenStream) -> TokenStream {
    deep(|| state::derived(item.into()))
}

/// Expands on a large stack.
fn deep(expand: impl FnOnce() -> proc_macro2::TokenStream) -> TokenStream {
    stacker::grow(STACK, expand).into()
}

/// Plain data: a struct, an enum, or an `impl` block of one; a `const` or a `static` with more information than its
/// value.
///
/// The struct or enum becomes a C `typedef`; its methods become C functions, `pid_torque(…)` for
/// `Pid::torque`. Derives are the author's: `Clone`, `Copy`, `Debug`, `Default`, `PartialEq`.
///
/// # Example
///
/// ```
/// use bessemer::prelude::*;
///
/// /// Gains of one axis.
/// #[data]
/// #[derive(Clone, Copy, Debug, Default, PartialEq)]
/// pub struct Gains {
///     /// Torque for each rad of error, N·m/rad.
///     pub proportional: f64,
///     /// Torque for each rad/s of its rate, N·m·s/rad.
///     pub derivative: f64,
/// }
///
/// #[data]
/// impl Gains {
///     /// The torque that answers an error of `error` rad and its rate of `rate` rad/s, N·m.
///     pub fn respond(&self, error: f64, rate: f64) -> f64 {
///         self.proportional * error + self.derivative * rate
///     }
/// }
///
/// /// A curve in flash, with a name in the C.
/// #[data]
/// pub static FLOW: [f32; 3] = [0.0, 0.4, 1.0];
///
/// let gains = Gains { proportional: 2.0, derivative: 0.5 };
/// assert_eq!(gains.respond(1.0, -2.0), 1.0);
/// assert_eq!(FLOW[1], 0.4);
/// ```
///
/// In the C: `typedef struct { … } gains_t;`, `gains_respond(const gains_t *self, …)`, and `FLOW`.
#[proc_macro_attribute]
pub fn data(arguments: TokenStream, item: TokenStream) -> TokenStream {
    expanded("data", arguments, item, |arguments, item| data::expand(Kind::Data, arguments, item))
}

/// A component: a struct with the state of a controller or estimator, or its `impl` block.
///
/// `Default` gives the initial state, which the C's `…_init` sets. In the `impl` block, methods marked
/// `#[entry]` are what the firmware calls; the others stay private to the component's C file.
///
/// # Example
///
/// ```
/// use bessemer::prelude::*;
///
/// /// Counts revolutions.
/// #[component]
/// #[derive(Clone, Debug, Default, PartialEq)]
/// pub struct Revolutions {
///     /// Whole revolutions since the start.
///     count: u32,
/// }
///
/// #[component]
/// impl Revolutions {
///     /// The index mark was seen: how often so far.
///     #[entry(infallible)]
///     pub fn mark(&mut self) -> u32 {
///         self.count = self.count.wrapping_add(1);
///         self.count
///     }
/// }
///
/// let mut revolutions = Revolutions::default();
/// assert_eq!(revolutions.mark(), 1);
/// assert_eq!(revolutions.mark(), 2);
/// ```
///
/// In the C: `revolutions_t`, `revolutions_init(revolutions_t *self)` and `revolutions_mark(revolutions_t *self)`.
#[proc_macro_attribute]
pub fn component(arguments: TokenStream, item: TokenStream) -> TokenStream {
    expanded("component", arguments, item, |arguments, item| {
        data::expand(Kind::Component, arguments, item)
    })
}

/// A free function.
///
/// # Example
///
/// ```
/// use bessemer::prelude::*;
///
/// /// The angle between -π and π that points where `angle` does, rad.
/// #[function]
/// pub fn wrapped(angle: f64) -> f64 {
///     angle - (angle / f64::TAU).round() * f64::TAU
/// }
///
/// /// The mean; 0 of nothing. Generic over the length, and over `f32` and `f64`.
/// #[function]
/// pub fn mean<T: Real, const N: usize>(values: &[T; N]) -> T {
///     let mut sum = T::ZERO;
///     for value in values {
///         sum += *value;
///     }
///     if N == 0 { sum } else { sum / real(N as f64) }
/// }
///
/// assert!((wrapped(4.0) - (4.0 - f64::TAU)).abs() < 1e-12);
/// assert_eq!(mean(&[1.0_f32, 2.0, 6.0]), 3.0);
/// ```
///
/// In the C a function of its module's file; a generic one for each way in which it is called.
///
/// `#[function(derivative(advanced, state))]` declares the value of `advanced` and its Jacobian by its parameter `state`; `gen`
/// writes the body in place of `todo!()`. `#[function(gradient(cost, inputs))]` declares a number and its gradient.
#[proc_macro_attribute]
pub fn function(arguments: TokenStream, item: TokenStream) -> TokenStream {
    expanded("function", arguments, item, function::expand)
}

/// Expands a block of the DSL's library: free functions that define the methods of one of std's or nalgebra's types.
#[doc(hidden)]
#[proc_macro_attribute]
pub fn library(arguments: TokenStream, item: TokenStream) -> TokenStream {
    deep(|| library::expand(arguments.into(), item.into()))
}

/// A function that the firmware brings in C; its body is in for it in the simulation and in the tests.
///
/// `#[external(header = "board.h")]` includes the header and calls the function by its name, or by that of
/// `name = "…"`. The body must not fault. What the C then computes is the firmware's own: that it gives the
/// same bits as the stand-in rests on whoever wrote it, and the report says so.
///
/// # Example
///
/// ```
/// use bessemer::prelude::*;
///
/// /// Linearises a sensor's counts; `sensor_linear` of the board's library in the firmware.
/// #[external(header = "sensor.h", name = "sensor_linear")]
/// pub fn linear(counts: u16) -> f32 {
///     f32::from(counts) * 0.25
/// }
///
/// assert_eq!(linear(8), 2.0);
/// ```
#[proc_macro_attribute]
pub fn external(arguments: TokenStream, item: TokenStream) -> TokenStream {
    deep(|| function::expand_external(arguments.into(), item.into()))
}

/// The name of an item in the C, and the section that it is placed in: `#[c(name = "pid_step", section = ".fast")]`.
///
/// It stands below `#[function]`, `#[data]` or `#[component]`: on a function, a type, a named instance, a
/// `const` or a `static`, and within these on methods, parameters, fields and variants. Functions and
/// constants have storage, and so sections; `result = "thrust"` names what a function gives through a
/// pointer. On its own it is an error.
///
/// # Example
///
/// ```
/// use bessemer::prelude::*;
///
/// /// A valve with a position.
/// #[data]
/// #[c(name = "Valve_t")]
/// #[derive(Clone, Copy, Debug, Default, PartialEq)]
/// pub struct Valve {
///     /// From 0 to 1.
///     #[c(name = "fOpening")]
///     pub opening: f32,
/// }
///
/// /// Opens a valve by half of what is left; placed in fast memory.
/// #[function]
/// #[c(name = "Valve_Open", section = ".ramfunc")]
/// pub fn open(valve: &mut Valve) {
///     valve.opening += 0.5 * (1.0 - valve.opening);
/// }
///
/// let mut valve = Valve::default();
/// open(&mut valve);
/// assert_eq!(valve.opening, 0.5);
/// ```
#[proc_macro_attribute]
pub fn c(_arguments: TokenStream, item: TokenStream) -> TokenStream {
    alone(item.into(), lower::refuse::C_ALONE)
}

/// An interface: a trait whose methods a model calls on whatever implements it, decided when the C is
/// written.
///
/// A component or a function that is generic over `C: Controller` becomes C for each controller that it is
/// used with. Implementations are marked as their type is: `#[component] impl Controller for Pid`.
///
/// # Example
///
/// ```
/// use bessemer::prelude::*;
///
/// /// Any law that answers an error.
/// #[interface]
/// pub trait Law {
///     /// The answer to an error.
///     fn respond(&mut self, error: f64) -> f64;
/// }
///
/// /// Answers in proportion.
/// #[component]
/// #[derive(Clone, Debug, PartialEq)]
/// pub struct Proportional {
///     gain: f64,
/// }
///
/// impl Default for Proportional {
///     fn default() -> Self {
///         Proportional { gain: 2.0 }
///     }
/// }
///
/// #[component]
/// impl Law for Proportional {
///     fn respond(&mut self, error: f64) -> f64 {
///         self.gain * error
///     }
/// }
///
/// /// A loop around any law.
/// #[component]
/// #[derive(Clone, Debug, Default, PartialEq)]
/// pub struct Around<L> {
///     law: L,
/// }
///
/// #[component]
/// impl<L: Law> Around<L> {
///     /// One control period.
///     #[entry(infallible)]
///     pub fn step(&mut self, target: f64, measured: f64) -> f64 {
///         self.law.respond(target - measured)
///     }
/// }
///
/// /// The loop that firmware calls: `proportional_loop_t` in the C.
/// #[component]
/// pub type ProportionalLoop = Around<Proportional>;
///
/// assert_eq!(ProportionalLoop::default().step(3.0, 1.0), 4.0);
/// ```
///
/// In the C the calls are direct: there is no table of functions and no pointer to one.
#[proc_macro_attribute]
pub fn interface(arguments: TokenStream, item: TokenStream) -> TokenStream {
    expanded("interface", arguments, item, interface::expand)
}

/// Marks a method of a `#[component]` as an entry point; `#[entry(infallible)]` claims that no fault
/// is left in it, which generation then proves.
///
/// Its meaning is the component's: on its own it is an error.
///
/// # Arguments
///
/// | written | the C | after a fault |
/// |---|---|---|
/// | `#[entry]` | returns a status, its result goes through a pointer | every entry point returns the fault until `…_init` |
/// | `#[entry(atomic)]` | the same | what was written is put back, and the next call goes on |
/// | `#[entry(infallible)]` | returns its result plainly | there is none: generation proves it, or says what stands against it |
/// | `#[entry(single)]`, also `#[entry(infallible, single)]` | the same, without an operation in double or of 64 bits, for a processor that has none: generation refuses each at its line | the same |
///
/// # Example
///
/// ```
/// use bessemer::prelude::*;
///
/// /// The last four samples.
/// #[component]
/// #[derive(Clone, Debug, Default, PartialEq)]
/// pub struct Window {
///     samples: [i16; 4],
///     next: usize,
/// }
///
/// #[component]
/// impl Window {
///     /// Takes a sample.
///     #[entry(infallible)]
///     pub fn push(&mut self, sample: i16) {
///         self.samples[self.next % 4] = sample;
///         self.next = self.next.wrapping_add(1);
///     }
///
///     /// One of the samples: `INDEX` for any beyond the fourth, where Rust panics.
///     #[entry]
///     pub fn sample(&self, index: usize) -> i16 {
///         self.samples[index]
///     }
///
///     /// Adds to all of them, or to none if one would overflow.
///     #[entry(atomic)]
///     pub fn shift(&mut self, by: i16) {
///         for sample in &mut self.samples {
///             *sample += by;
///         }
///     }
/// }
///
/// let mut window = Window::default();
/// window.push(7);
/// window.shift(1);
/// assert_eq!(window.sample(0), 8);
/// ```
#[proc_macro_attribute]
pub fn entry(_arguments: TokenStream, item: TokenStream) -> TokenStream {
    alone(item.into(), lower::refuse::ENTRY_ALONE)
}

/// Names the requirements that an item implements, or that a test verifies: `#[requirement("HLR-12")]`.
///
/// It changes neither the Rust nor the C. `cargo bessemer dossier` builds the matrix of requirements, items, functions of
/// the C, tests and their results from it. It may be on any item, on a method, on a module or `impl` block (for each item
/// in it) and on a test, and names one identifier or several.
///
/// # Example
///
/// ```
/// use bessemer::prelude::*;
///
/// /// Counts pulses.
/// #[requirement("HLR-1")]
/// #[component]
/// #[derive(Clone, Debug, Default, PartialEq)]
/// pub struct Counter {
///     count: u32,
/// }
///
/// #[component]
/// impl Counter {
///     /// Counts one pulse.
///     #[requirement("HLR-1", "HLR-2")]
///     #[entry(infallible)]
///     pub fn pulse(&mut self) -> u32 {
///         self.count = self.count.wrapping_add(1);
///         self.count
///     }
/// }
///
/// # fn main() {
/// let mut counter = Counter::default();
/// assert_eq!(counter.pulse(), 1);
/// # }
/// ```
#[proc_macro_attribute]
pub fn requirement(arguments: TokenStream, item: TokenStream) -> TokenStream {
    let parser = syn::punctuated::Punctuated::<syn::LitStr, syn::Token![,]>::parse_terminated;
    match syn::parse::Parser::parse(parser, arguments) {
        Ok(named) if !named.is_empty() => item,
        _ => alone(item.into(), lower::refuse::REQUIREMENT),
    }
}

/// Refuses an attribute that is valid only below another.
fn alone(item: proc_macro2::TokenStream, reason: lower::refuse::Reason) -> TokenStream {
    let mut refusals = lower::Refusals::default();
    refusals.add(lower::refuse::first_token(&item), reason);
    let error = refusals.into_tokens();
    quote::quote! { #error #item }.into()
}

/// `derive(State)` of a generation build.
#[doc(hidden)]
#[proc_macro_derive(StateInGeneration)]
pub fn state_in_generation(item: TokenStream) -> TokenStream {
    lower::in_generation(|| state(item))
}

/// Defines the attributes of a generation build.
macro_rules! in_generation {
    ($($name:ident: $attribute:ident;)*) => {$(
        #[doc(hidden)]
        #[proc_macro_attribute]
        pub fn $name(arguments: TokenStream, item: TokenStream) -> TokenStream {
            lower::in_generation(|| $attribute(arguments, item))
        }
    )*};
}

in_generation! {
    component_in_generation: component;
    data_in_generation: data;
    external_in_generation: external;
    function_in_generation: function;
    interface_in_generation: interface;
    library_in_generation: library;
}
