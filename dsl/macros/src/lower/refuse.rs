//! Refusals: unsupported Rust, each with a remedy.
//!
//! Every reason states the error in the author's terms, then the remedy. A construct that neither this module nor the
//! lowering knows is refused as [`SYNTAX`]: the tool never panics, and never emits wrong C.

use std::fmt::{self, Display, Formatter};

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::ToTokens;

/// Reason of a refusal.
#[derive(Clone, Copy)]
pub struct Reason {
    what: &'static str,
    remedy: &'static str,
}

impl Reason {
    /// Returns true if the reason is that core's function is unsupported.
    pub fn is_of_core(self) -> bool {
        self.what == CORE.what
    }
}

impl Display for Reason {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{}\nhelp: {}", self.what, self.remedy)
    }
}

/// Place of a refusal: a token, or syntax from its first token to its last.
pub trait Place {
    /// Returns the error at this place.
    fn error(self, reason: Reason) -> syn::Error;
}

impl Place for Span {
    fn error(self, reason: Reason) -> syn::Error {
        syn::Error::new(self, reason)
    }
}

impl<T: ToTokens> Place for &T {
    fn error(self, reason: Reason) -> syn::Error {
        syn::Error::new_spanned(self, reason)
    }
}

/// All refusals in an item, in the order of the source.
#[derive(Default)]
pub struct Refusals {
    errors: Vec<syn::Error>,
    /// Paths that rustc must know, since a refusal takes each for a function.
    paths: Vec<syn::ExprPath>,
}

impl Refusals {
    /// Adds a refusal at `place`.
    pub fn add(&mut self, place: impl Place, reason: Reason) {
        self.errors.push(place.error(reason));
    }

    /// Adds a path, which a refusal takes for a function.
    pub fn requires(&mut self, path: syn::ExprPath) {
        self.paths.push(path);
    }

    /// Returns statements in which rustc looks up the paths.
    pub fn lookups(&self) -> TokenStream {
        let paths = &self.paths;
        quote::quote! { #(let _ = #paths;)* }
    }

    /// Returns the number of refusals.
    pub fn len(&self) -> usize {
        self.errors.len()
    }

    /// Removes all refusals after the first `len`.
    pub fn forget_since(&mut self, len: usize) {
        self.errors.truncate(len);
    }

    /// Returns true if nothing was refused.
    pub fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// Returns the errors as tokens, each at its place.
    pub fn into_tokens(mut self) -> TokenStream {
        self.errors.sort_by_key(|error| {
            let start = error.span().start();
            (start.line, start.column)
        });
        self.errors.into_iter().map(|error| error.into_compile_error()).collect()
    }
}

impl From<syn::Error> for Refusals {
    fn from(error: syn::Error) -> Refusals {
        Refusals { errors: vec![error], ..Refusals::default() }
    }
}

/// Returns the span of the first token of `syntax`, after its attributes.
pub fn first_token(syntax: &impl ToTokens) -> Span {
    let mut tokens = syntax.to_token_stream().into_iter();
    loop {
        match tokens.next() {
            Some(TokenTree::Punct(it)) if it.as_char() == '#' => drop(tokens.next()),
            Some(token) => return token.span(),
            None => return Span::call_site(),
        }
    }
}

macro_rules! reasons {
    ($($name:ident: $what:literal, $remedy:literal;)*) => {$(
        pub const $name: Reason = Reason { what: $what, remedy: $remedy };
    )*};
}

reasons! {
    SYNTAX: "this syntax is not part of the DSL", "write it with `let`, `if`, `match`, `for`, calls and arithmetic";
    ARGUMENTS: "this attribute takes no arguments", "remove them";
    DERIVATIVE: "`derivative` and `gradient` name a function and some of its parameters", "write `#[function(derivative(advance, state))]`";
    NOT_A_FUNCTION: "`#[function]` belongs on a free function", "mark a struct, an enum or an `impl` block `#[data]` or `#[component]`";
    NO_FUNCTION_BUT_A_CONSTANT: "`#[function]` belongs on a free function", "remove it: a constant of numbers needs no attribute, and one of structs `#[data]`";
    REWRITTEN_CALL: "a `#[function(rewrite)]` can only call its own closures", "use `#[function(expand)]`, which can call other functions";
    METHOD_ALONE: "a method is marked through its `impl` block", "mark the `impl` block `#[data]` or `#[component]`, and remove `#[function]`";
    NOT_DATA: "this attribute belongs on a struct, an enum, an `impl` block or a constant", "mark a free function `#[function]`";
    EMPTY_COMPONENT: "a component without fields has no state", "mark it and its `impl` blocks `#[data]`, or add a field";
    EMPTY_NAME: "a struct without fields has no type in C that `#[c(name)]` could name", "remove the name, or name its methods";
    EMPTY_ENUM: "C has no enum without variants", "add a variant; a type without values can be a `struct Name;`";
    COMPONENT_ENUM: "a component must be a struct", "mark the enum `#[data]`, and keep it in a field of a component";
    IMPL_ITEM: "this item cannot be part of a marked `impl` block", "write methods and constants";
    CFG: "`#[cfg]` on a part of an item would remove it from the Rust, but not from the C", "put `#[cfg]` on the whole item, above the attribute of the DSL";
    ATTRIBUTE: "this attribute has no meaning in C", "remove it; lint levels and doc comments may stay";
    NESTED_CONST: "a block inside a function cannot declare items", "move them to the top of the function";
    IGNORED: "`_` is not a place", "write `let _ = …;`";
    CORE: "this function of the standard library is not supported", "write it out, or use the method of the same name";
    ROTATION: "this transformation of nalgebra is not supported", "use `UnitQuaternion`, `Rotation2`, `Rotation3`, `Translation3` or `Isometry3`";
    LATER: "a `let` of a struct cannot declare variables that are assigned later", "write a `let` for each";
    DESTRUCTURING: "this pattern is not supported here", "destructure with `let`: `let [x, y] = pair;`, `let Gains { p, i } = gains;`";
    BINDING_PATTERN: "`ref` cannot bind to a temporary", "remove `ref`; or bind the value to a name first";
    PATTERN: "this pattern is not supported", "match on values, ranges, variants, structs, tuples, arrays, names and `_`";
    DISCRIMINANT: "an enum with payloads cannot number its variants", "remove the numbers; where a protocol fixes them, `match` on the value";
    UNION: "C cannot check the type of a union's bytes", "use a struct, and `to_bits`/`from_bits` for the bits of a float";
    STRING: "this kind of text is not supported", "write `&'static str` and `\"abc\"` for a name that is only compared; write `*b\"abc\"` for bytes, or `Text::of(b\"abc\")` for a `Text<8>`";
    SUFFIX: "this literal has an unknown suffix", "write a product with `*`, `2.0 * x`; the types of numbers are `f64`, `u8` and the like: `2_u8`";
    NO_FUNCTION: "this variable is not known to be a function", "declare a parameter that is a function by its calls: `law: impl Fn(f64) -> f64`, or with a type parameter `F: Fn(f64) -> f64`; an element of an array is `v[0]`";
    FUNCTION_VALUE: "a function cannot be stored as a value", "call the function by its name; exchange an implementation through an `#[interface]`, or an `enum` with a `match`";
    FUNCTION_POINTER: "a function pointer hides the callee from the stack analysis", "choose with an `enum` and a `match`";
    RECURSION: "a recursive function has no bound on its stack", "write a loop over a range";
    OPEN_RANGE: "a loop over an open range has no bound", "write both ends, `for i in 0..n`; or leave it: `if … { break; }`";
    SHOWN_BOUND: "`#[bound]` has no effect here, because the loop's bound is already known", "remove `#[bound]`";
    BOUND: "`#[bound]` requires a number or a constant", "write `#[bound(64)]`, or `#[bound(LIMIT)]`";
    VARIANT_VALUE: "`core::mem::discriminant` is not supported", "compare with `matches!(mode, Mode::Idle | …)`, or write a method with a `match` that returns a number for each variant";
    LENT_PARAMETER: "a closure parameter must be taken by value", "remove the `&`, here and at the calls: `f: impl Fn(f64) -> f64`";
    HYGIENE_UNKNOWN: "a macro makes this function, and this version of rustc does not report which names belong to the macro", "write the function out, or build with the rustc of `rust-version`";
    CLOSURE: "a closure cannot be stored as a value here", "bind it with `let` and call it, pass it to a function, or write it in `.map(…)`, `.fold(…)` and the like";
    CLOSURE_VALUE: "a closure can be called or passed to a function, but not stored", "call it, or write a function marked `#[function]`";
    CLOSURE_MOVE: "a `move` closure cannot copy a variable that changes", "remove `move`, or copy the variable before: `let k = k;`";
    EXPANDED_RETURN: "`return` in an expanded function would leave its caller", "write the result as the last expression: `if … { a } else { b }`";
    HYGIENE: "this macro declares a name that it also receives as an argument", "rename the variable in the macro";
    ASYNC: "firmware has no executor for `async` and `await`", "write a component whose `step` is called once per period";
    UNSAFE: "`unsafe` has no equivalent in the emitted C", "keep state in a field of the component; declare functions of the firmware `#[external(header = \"board.h\")]`; use indices for elements and `to_bits` for the bits of floats";
    RAW_BORROW: "raw pointers are not supported", "pass `&` or `&mut`";
    POINTER: "raw pointers are not supported", "pass `&T` or `&mut T`";
    EXTERN: "an external function needs a Rust body that the simulation can run", "write `#[external(header = \"board.h\")]` above a Rust function that simulates it";
    SLICE: "an unsized slice cannot be stored or passed by value", "pass `&[T]`; store an array, `[T; N]`, or a `List<T, N>`";
    TRAIT_OBJECT: "a trait object needs a table of function pointers", "name the type, or choose with an `enum` and a `match`";
    IMPL_TRAIT: "`impl Trait` hides the type that C has to name", "name the type, or a parameter of the type around it, `struct Held<L> { law: L }`; take a closure as `impl Fn(f64) -> f64`, in functions and in methods of a type";
    ITERATOR_TAIL: "a function that returns `impl Iterator` must end in the iterator", "make it the last expression: `self.values.iter().copied()`";
    ITERATOR_OUTSIDE: "an entry point, an interface or an external function cannot take or return an iterator", "iterate inside a function or a method of your own, and return the result";
    GENERIC_ALIAS: "the alias of an instance cannot have parameters", "name each instance: `pub type PidF32 = Pid<f32>;`";
    RETURNED_REFERENCE: "neither an entry point nor an external function can return a reference", "return a copy, or the index of the element";
    LENT_CLOSURE: "a function that takes a closure cannot return a reference", "return a copy, or the index of the element";
    REFERENCE_FIELD: "a reference in this type would let two owners share memory in C", "store the value, or pass the reference to the method";
    NEVER: "a function that never returns would hang the firmware", "return a value";
    RECEIVER: "this receiver is not supported", "write `self`, `&self` or `&mut self`";
    STATIC: "a `static mut` is a global that any code can change", "keep state in a field of the component, which methods change through `&mut self`; make a constant table a `const`";
    NESTED_ITEM: "a function can contain functions and constants, but no other items", "move the item out, next to the function";
    YIELD: "generators are not supported", "keep the state in a component, and call its `step`";
    RANGE_VALUE: "a range expression cannot be a value here", "write it in a `for`; store a `RangeInclusive::new(a, b)`, or a constant: `const LIMITS: Range<u8> = 2..5;`";
    OPERATOR_TRAIT: "`Deref` hides the access that C has to name", "write a method that returns the reference: `fn inner(&self) -> &Inner`";
    OWN_ADAPTER: "an `impl Iterator` can only define `next`", "remove this method: Rust provides it";
    EXCLUSIVE_OPERAND: "an operator cannot take an operand by `&mut`", "take it by `&` or by value, or write a method";
    GENERIC_EQUALITY: "an own `==`, `<`, `Zero` or `One` of a type with type parameters is not supported", "derive `PartialEq`, implement it for each instance, or write a method: `fn is_same(&self, other: &Self) -> bool`";
    OWN_UNEQUAL: "`!=` is always the opposite of `==`", "remove `ne`: Rust derives it from `eq`";
    OWN_LESS: "`partial_cmp` determines `<`, `<=`, `>` and `>=`", "remove this method: Rust derives it from `partial_cmp`";
    OWN_ORDER: "an own order of one type, `PartialOrd` or `Ord`, is not supported", "write a method, `fn is_before(&self, other: &Self) -> bool`; or derive `PartialOrd`, or compare parts";
    FOREIGN_OPERAND: "operators and conversions require numbers or a type of your own", "write a method: `fn as_array(self) -> [f64; 2]`";
    RUST_TRAIT: "this name belongs to a trait of Rust", "rename it";
    STD_TRAIT: "a model never calls this trait of Rust, so the C has no such `impl`", "remove the attribute of the DSL above it; the `impl` may stay for the simulation";
    DROP: "the C would never call this `drop`", "remove the block; write a method, and call it where the value is used last";
    NOT_A_TRAIT: "`#[interface]` belongs on a trait", "mark a struct, an enum or an `impl` block `#[data]` or `#[component]`, and a function `#[function]`";
    INTERFACE_ITEM: "this item cannot be part of an `#[interface]`", "write methods, constants and types";
    LIST: "a model has no heap for a `Vec`", "use `List<T, N>`, a list of at most `N` elements, or an array `[T; N]`";
    TEXT: "a model has no heap for a `String`", "use `Text<N>`, a text of at most `N` bytes; use an enum for a choice";
    QUEUE: "a model has no heap for a queue", "use an array `[T; N]` and the index of the oldest element, or `List<T, N>`";
    MAP: "a model has no heap for a map", "search a `List<(K, V), N>`, or use an array with the key as index";
    HEAP: "a model has no heap", "store the value itself; use an `enum` for values of several types";
    DYNAMIC_MATRIX: "a dynamic matrix has no size at compile time", "use `SMatrix<f64, R, C>` or `SVector<f64, N>`";
    STD: "firmware has no `std`", "write the path with `core` if it is there; pass what only a platform has, such as the time, to the entry point as an argument";
    SHARED_CELL: "shared mutable state is not supported", "keep state in a field of the component, which methods change through `&mut self`";
    FORMAT: "text cannot be formatted on the target", "return the numbers, and format them where they are displayed";
    ENTRY_ARGUMENT: "`#[entry]` accepts only `infallible`, `atomic` or `single`", "write `#[entry]`, `#[entry(infallible)]`, `#[entry(atomic)]` or `#[entry(single)]`";
    ENTRY_BOTH: "an infallible entry point has nothing to roll back", "remove `atomic` or `infallible`";
    ENTRY_INLINE: "an entry point cannot be inlined, because the firmware calls it", "remove `#[inline(always)]`";
    ENTRY_GENERIC: "an entry point cannot be generic, because the firmware calls functions of fixed types", "name the types; for several, make the component generic, and name its instances";
    ENTRY_CLOSURE: "an entry point cannot take a closure, because the firmware has none to pass", "choose with an `enum` and a `match`, or make the component generic over an `#[interface]`";
    UNROLL: "`#[unroll]` requires the number of passes to write out", "write `#[unroll(4)]`, at most 64, or `#[keep]`";
    UNIT: "`#[unit]` requires a unit", "write `#[unit(\"m/s\")]`";
    FOREIGN_IMPLEMENTATION: "an interface can be implemented for numbers, arrays, tuples and types of your own", "wrap the value: `#[data] struct Gain(f64);`, and implement the interface for that";
    INTERFACE_CLOSURE: "a method of an interface cannot take a closure", "write a function or a method of a type that takes it";
    RANGE: "`#[range]` requires a range of numbers", "write the least and the greatest number: `#[range(0.0..=5.0)]`; on a parameter also what becomes of others: `#[range(0.0..=5.0, clamp)]` or `#[range(0.0..=5.0, report)]`";
    RANGE_OF_FIELD: "a range can be enforced where a function begins", "write `clamp` or `report` on a parameter of a function with a body, or `self.gain.clamp(0.0, 1.0)` where the field is read";
    RANGE_OF_REFERENCE: "only a number that is passed by value can be clamped or reported", "pass the number by value, or write `x.clamp(0.0, 1.0)` where it is read";
    AXES: "`#[axes]` requires one field or two", "name the fields with the points of the axes, the outer one first: `#[axes(speeds, loads)]`";
    AXES_PLACE: "`#[axes]` belongs on a field that is a table", "move it to the array of the values, in one struct with its axes";
    RANGE_PLACE: "`#[range]` belongs on a field or a parameter that is a number", "move it to a field or a parameter";
    UNIT_PLACE: "`#[unit]` belongs on a number", "move it to a field, a parameter, a constant, or the function that returns the number";
    C_ALONE: "`#[c(…)]` must be below an attribute of the DSL", "write it below `#[function]`, `#[data]` or `#[component]`, or on a method of a marked `impl` block";
    SECTION_PLACE: "only a function or a constant can have a section", "remove the section";
    FALLBACK_PLACE: "`fallback` belongs on a variant of an enum", "write `#[c(fallback)]` above the variant as which an invalid value counts in the C";
    FALLBACK_TWICE: "an enum has at most one variant as which an invalid value counts", "remove one `#[c(fallback)]`";
    FALLBACK_PAYLOAD: "a variant with fields cannot stand for an invalid value, whose fields would mean nothing", "write `#[c(fallback)]` above a variant without fields";
    TABLE_UNNAMED: "a constant without a name is not emitted", "remove the attribute";
    C_ARGUMENT: "`#[c(…)]` accepts `name`, `section`, for functions `result`, and for variants `fallback`", "write `#[c(name = \"pid_step\", section = \".fast\")]`";
    C_NAME: "this is not a valid C identifier", "begin with a letter, and continue with letters, digits and `_`";
    C_SECTION: "this is not a valid section name", "write letters, digits, `.` and `_`: `.fast`";
    INLINE_SECTION: "an inlined function cannot have a section", "remove `#[inline]` or the section";
    GENERIC_NAME: "the instances of a generic item cannot share one C name", "remove the name, and name each instance with `type`";
    EXTERNAL_ARGUMENT: "`#[external]` requires a header", "write `#[external(header = \"board.h\")]`, with `name = \"…\"` if its C name differs";
    EXTERNAL_GENERIC: "an external function cannot be generic", "write one function for each type";
    ENTRY_ALONE: "`#[entry]` belongs on a method inside an `impl` block marked `#[component]`", "mark the `impl` block `#[component]`, or call a free function from an entry point";
    RUST_TYPE: "a function with the name of a Rust type hides that type", "rename it: `to_f64`";
    ENTRY_OF_DATA: "a type marked `#[data]` cannot have entry points", "mark the struct and this block `#[component]`";
    REQUIREMENT: "`#[requirement]` takes identifiers of requirements", "write `#[requirement(\"HLR-12\")]`, or several: `#[requirement(\"HLR-12\", \"HLR-13\")]`";
    MACRO: "this macro is not supported", "write the expression out, or a function marked `#[function]`";
    STATE_BLOCK: "a block of a state is a number, a vector or a `UnitQuaternion`", "write `f64`, `Vector3<f64>`, `SVector<f64, 5>` or `UnitQuaternion<f64>`; other data belongs to a struct around the state";
    STATE_EMPTY: "a state without a field has no errors", "give it a block: `position: Vector3<f64>`";
    STATE_NUMBERS: "the numbers of this block have another type than those of the first", "write all blocks of a state with `f64`, or all with `f32`";
    STATE_SHAPE: "a state is a struct whose blocks have names", "write `struct Motion { position: Vector3<f64> }`";
}

/// Macros that print to a reader.
const SHOWING: &str =
    "format print println eprint eprintln write writeln dbg trace debug info warn error log";

/// Returns the reason for an unsupported macro.
pub fn macro_call(name: &str) -> Reason {
    match name {
        _ if SHOWING.split(' ').any(|it| it == name) => FORMAT,
        "vec" => LIST,
        _ => MACRO,
    }
}

/// Returns the reason for an unsupported expression, and the tokens to mark.
pub fn expression(expr: &syn::Expr) -> (TokenStream, Reason) {
    match expr {
        syn::Expr::Closure(it) => (it.to_token_stream(), CLOSURE),
        syn::Expr::Async(it) => (it.async_token.to_token_stream(), ASYNC),
        syn::Expr::Await(it) => (it.await_token.to_token_stream(), ASYNC),
        syn::Expr::Unsafe(it) => (it.unsafe_token.to_token_stream(), UNSAFE),
        syn::Expr::RawAddr(it) => (it.to_token_stream(), RAW_BORROW),
        syn::Expr::Range(it) => (it.to_token_stream(), RANGE_VALUE),
        syn::Expr::Yield(it) => (it.yield_token.to_token_stream(), YIELD),
        syn::Expr::Infer(it) => (it.underscore_token.to_token_stream(), IGNORED),
        syn::Expr::Let(it) => (it.let_token.to_token_stream(), SYNTAX),
        other => (other.to_token_stream(), SYNTAX),
    }
}

/// Returns the reason for an unsupported implementation of a standard trait.
pub fn known_trait(path: &syn::Path) -> Option<Reason> {
    let name = path.segments.last()?.ident.to_string();
    Some(match name.as_str() {
        "Deref" | "DerefMut" => OPERATOR_TRAIT,
        "PartialOrd" | "Ord" => OWN_ORDER,
        "Drop" => DROP,
        "Default"
        | "Clone"
        | "Copy"
        | "Debug"
        | "Display"
        | "Eq"
        | "Hash"
        | "Into"
        | "IntoIterator"
        | "DoubleEndedIterator"
        | "ExactSizeIterator"
        | "FusedIterator" => STD_TRAIT,
        _ => return None,
    })
}

/// Returns the reason for an unsupported item of Rust's own libraries, with which a path begins; none for another
/// path.
pub fn library(path: &syn::Path) -> Option<Reason> {
    let first = path.segments.first().filter(|_| path.segments.len() > 1)?;
    match first.ident.to_string().as_str() {
        "std" => Some(STD),
        "core" => Some(CORE),
        "alloc" => Some(HEAP),
        _ => None,
    }
}

/// Returns the reason for a type that its name shows to be unsupported.
pub fn named_type(path: &syn::Path) -> Option<Reason> {
    let last = path.segments.last()?;
    let name = last.ident.to_string();
    // Without what it holds, it is the author's own of that name.
    let bare = path.segments.len() == 1 && last.arguments.is_empty();
    Some(match name.as_str() {
        "Cell" | "RefCell" | "Mutex" | "RwLock" if bare => return None,
        "Vec" => LIST,
        "String" => TEXT,
        "VecDeque" => QUEUE,
        "HashMap" | "BTreeMap" | "HashSet" | "BTreeSet" | "BinaryHeap" => MAP,
        "Box" | "Rc" | "Arc" => HEAP,
        "DMatrix" | "DVector" | "RowDVector" | "MatrixXx1" | "Matrix1xX" | "DMatrixView"
        | "Dyn" => DYNAMIC_MATRIX,
        "Cell" | "RefCell" | "Mutex" | "RwLock" | "AtomicBool" | "AtomicU32" | "AtomicUsize" => {
            SHARED_CELL
        }
        "UnitComplex" | "UnitDualQuaternion" | "Isometry2" | "IsometryMatrix2"
        | "IsometryMatrix3" | "Similarity2" | "Similarity3" | "Transform3" | "Affine3"
        | "Projective3" => ROTATION,
        "str" => STRING,
        _ => return None,
    })
}
