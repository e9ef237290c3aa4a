//! The refusals: Rust that the DSL does not take, each with something to write instead.
//!
//! Every reason says what is wrong in the author's terms, then the remedy. A construct that is absent
//! here and from the lowering is refused as [`SYNTAX`]: never a panic, never wrong C.

use std::fmt::{self, Display, Formatter};

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::ToTokens;

/// Why something is refused.
#[derive(Clone, Copy)]
pub struct Reason {
    what: &'static str,
    remedy: &'static str,
}

impl Reason {
    /// The function that is refused is one of core's.
    pub fn is_of_core(self) -> bool {
        self.what == CORE.what
    }
}

impl Display for Reason {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{}\nhelp: {}", self.what, self.remedy)
    }
}

/// Where something is refused: a token, or syntax from its first to its last one.
pub trait Place {
    /// The error there.
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

/// Everything refused in one item, in the order of the source.
#[derive(Default)]
pub struct Refusals {
    errors: Vec<syn::Error>,
}

impl Refusals {
    /// Refuses what stands at `place`.
    pub fn add(&mut self, place: impl Place, reason: Reason) {
        self.errors.push(place.error(reason));
    }

    /// How much was refused.
    pub fn len(&self) -> usize {
        self.errors.len()
    }

    /// Takes back what was refused since there were so many.
    pub fn forget_since(&mut self, len: usize) {
        self.errors.truncate(len);
    }

    /// Whether nothing was refused.
    pub fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// The errors as tokens, each at its place.
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
        Refusals { errors: vec![error] }
    }
}

/// Where `syntax` begins, behind its attributes: its first token.
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
    ARGUMENTS: "this attribute takes no arguments", "leave them out";
    NOT_A_FUNCTION: "`#[function]` stands on a free function", "a struct, an enum and an `impl` block take `#[data]`, or `#[component]`";
    REWRITTEN_CALL: "a function that is rewritten calls nothing but its own closures", "`#[function(expand)]` also stands where it is called, and may";
    METHOD_ALONE: "a method is part of its `impl` block", "mark the `impl` block `#[data]` or `#[component]`, and leave `#[function]` out";
    NOT_DATA: "this attribute stands on a struct, an enum, an `impl` block or a constant", "a free function takes `#[function]`";
    EMPTY_COMPONENT: "a component without fields has no state to keep", "mark it and its `impl` blocks `#[data]`, or give it a field";
    EMPTY_NAME: "a struct without fields is no type in the C, and has no name there", "leave the name out, or give one to its methods";
    EMPTY_ENUM: "C has no enum without variants", "give it a variant; a type that only tells others apart is a `struct Name;`";
    COMPONENT_ENUM: "a component is a struct", "keep the enum in a field of one, and mark it `#[data]`";
    IMPL_ITEM: "this is not part of an `impl` block of the DSL", "write methods and constants";
    CFG: "what `#[cfg]` leaves out of the Rust would still be in the C", "put `#[cfg]` on the whole item, above the attribute of the DSL";
    ATTRIBUTE: "this attribute has no meaning in the C", "leave it out; lint levels and doc comments may stay";
    NESTED_CONST: "a block inside a function has no names of its own in the DSL", "move it to the top of the function";
    IGNORED: "`_` is not a place in the DSL", "write `let _ = …;`";
    CORE: "functions of the standard library are not in the DSL", "write it out, or use the method of the same name";
    ROTATION: "of nalgebra's transformations this one is not in the DSL", "use `UnitQuaternion`, `Rotation2`, `Rotation3`, `Translation3` or `Isometry3`";
    LATER: "several variables that are assigned later stand in one `let`", "write a `let` for each";
    DESTRUCTURING: "this pattern is not in the DSL here", "take the value apart with `let`: `let [x, y] = pair;`, `let Gains { p, i } = gains;`";
    BINDING_PATTERN: "this pattern binds a reference to what has no place", "leave `ref` out: the name stands for the value; or give the value a name first";
    PATTERN: "this pattern is not in the DSL", "match on values, ranges, variants, structs, tuples, arrays, names and `_`";
    DISCRIMINANT: "variants with payload have no numbers of their own in the DSL", "leave them out; where a protocol fixes them, `match` on the value";
    UNION: "a union's bytes have no type that the C could check", "use a struct, and `to_bits`/`from_bits` for the bits of a float";
    STRING: "text is not in the DSL yet", "use an enum for a choice; bytes are `*b\"abc\"`, or `Text::of(b\"abc\")` of any length up to that of a `Text<8>`";
    WIDE_INTEGER: "C99 has no 128-bit integer", "use `u64` or `i64`";
    FUNCTION_VALUE: "functions are not values in the DSL", "call the function by its name; what is exchanged is an `#[interface]`, or an `enum` with a `match`";
    FUNCTION_POINTER: "function pointers hide what is called from the stack analysis", "choose with an `enum` and a `match`";
    RECURSION: "recursion has no bound that the C could promise", "write a loop over a range";
    OPEN_RANGE: "this range is open, so the loop has no bound", "write both ends, `for i in 0..n`; or leave it: `if … { break; }`";
    SHOWN_BOUND: "the bound of this loop shows", "leave `#[bound]` out";
    BOUND: "the bound of a loop is a number, or a constant", "write `#[bound(64)]`, or `#[bound(LIMIT)]`";
    VARIANT_VALUE: "which variant a value has is not a value in the DSL", "ask `matches!(mode, Mode::Idle | …)`, or write a method with a `match` that gives a number for each";
    LENT_PARAMETER: "a parameter that is called takes the closure as it is", "leave the `&` out, here and where it is passed: `f: impl Fn(f64) -> f64`";
    HYGIENE_UNKNOWN: "a macro makes this function, and this rustc does not show which names are its own", "write the function out, or build with the rustc of `rust-version`";
    CLOSURE: "a closure is not a value in the DSL", "give it a name with `let` and call it, pass it to a function, or write it in `.map(…)`, `.fold(…)` and the like";
    CLOSURE_VALUE: "a closure is called or passed to a function in the DSL, and not kept", "call it, or write a function marked `#[function]`";
    CLOSURE_MOVE: "a closure that takes a copy of what changes is not in the DSL", "leave `move` out, or copy before to a name without `mut`: `let k = k;`";
    EXPANDED_RETURN: "this would leave the caller of a function that stands where it is called", "let its body end in the value: `if … { a } else { b }`";
    HYGIENE: "a macro makes a name here that it is given as well: the two are one in the DSL", "give the name in the macro another name";
    ASYNC: "there is no executor in firmware that a model could await", "write a component whose `step` is called once per period";
    UNSAFE: "`unsafe` has no meaning that the C could keep", "state is a field of the component; the firmware's functions are `#[external(header = \"board.h\")]`; elements have indices, floats `to_bits`";
    RAW_BORROW: "raw pointers are not in the DSL", "pass `&` or `&mut`";
    POINTER: "raw pointers are not in the DSL", "pass `&T` or `&mut T`";
    EXTERN: "an external function needs a stand-in that the simulation can run", "write `#[external(header = \"board.h\")]` above a function of Rust that does the same";
    SLICE: "a slice is passed, and not held: its length is not known when the C is written", "hold an array, `[T; N]`, or a `List<T, N>`";
    TRAIT_OBJECT: "trait objects need a table of function pointers", "name the type, or choose with an `enum` and a `match`";
    IMPL_TRAIT: "`impl Trait` hides the type that the C has to name", "name the type; a closure is taken by `impl Fn(f64) -> f64`, in functions and in methods of a type";
    ITERATOR_TAIL: "a function that gives an iterator ends in it", "let its last expression be the iterator: `self.values.iter().copied()`";
    ITERATOR_OUTSIDE: "an iterator is gone through where it is made, which only a function or a method of the model's own can be", "go through it inside, and give what comes of it";
    GENERIC_ALIAS: "the name of an instance has no parameters of its own", "name each instance: `pub type PidF32 = Pid<f32>;`";
    RETURNED_REFERENCE: "what the firmware calls gives a value", "return a copy, or the index of the element";
    LENT_CLOSURE: "a function that takes a closure gives a value in the DSL", "return a copy, or the index of the element";
    REFERENCE_FIELD: "a reference in a struct would let two owners share memory in the C", "hold the value, or pass the reference to the method";
    NEVER: "a function that never returns would hang the firmware", "return a value";
    RECEIVER: "this receiver is not in the DSL", "write `self`, `&self` or `&mut self`";
    STATIC: "a `static mut` is a global that anybody changes", "state belongs into the component: a field, which its methods change through `&mut self`; a table that nobody changes is a `const`";
    NESTED_ITEM: "inside a function the DSL has functions and constants, and no other items", "move it out, next to the function";
    YIELD: "generators are not in the DSL", "keep the state in a component, and step it";
    RANGE_VALUE: "a range that is written down is not a value in the DSL", "write it in a `for`; one that is held, `RangeInclusive::new(a, b)`, or as a constant: `const LIMITS: Range<u8> = 2..5;`";
    OPERATOR_TRAIT: "what lends by itself hides in the Rust what the C has to name", "write a method that gives the reference, `fn inner(&self) -> &Inner`";
    OWN_ADAPTER: "an iterator of one's own is its `next` in the DSL", "leave this method out: Rust makes it of `next`";
    EXCLUSIVE_OPERAND: "an operand is not written in the DSL", "take it by `&`, or by value; or write a method with a name";
    GENERIC_EQUALITY: "a `==` of one's own of a type with type parameters is not in the DSL", "derive `PartialEq`, implement it for each instance, or write a method with a name: `fn is_same(&self, other: &Self) -> bool`";
    TWO_TYPES_EQUAL: "`==` compares values of one type in the DSL", "convert one of the two, or write a method with a name";
    OWN_UNEQUAL: "`!=` is the opposite of `==` in the DSL", "leave `ne` out: Rust makes it of `eq`";
    OWN_ORDER: "an order of one's own is not in the DSL", "write a method with a name, `fn is_before(&self, other: &Self) -> bool`; or derive `PartialOrd` (enums without payload), or compare parts";
    FOREIGN_OPERAND: "operators and conversions are those of numbers and of types of the author's own in the DSL", "write a method with a name, `fn as_array(self) -> [f64; 2]`";
    RUST_TRAIT: "by this name the DSL means a trait of Rust's", "give it another name";
    STD_TRAIT: "this trait is Rust's own: no model calls it", "leave the attribute out";
    NOT_A_TRAIT: "`#[interface]` stands on a trait", "a struct, an enum and an `impl` block take `#[data]` or `#[component]`, a function `#[function]`";
    INTERFACE_ITEM: "this is not part of an interface of the DSL", "write methods, constants and types";
    LIST: "a model has no heap, on which a `Vec` grows", "use `List<T, N>`, a list of at most `N` elements, or an array `[T; N]`";
    TEXT: "a model has no heap, on which a `String` grows", "use `Text<N>`, a text of at most `N` bytes; for a choice an enum";
    QUEUE: "a model has no heap, on which a queue grows", "use an array `[T; N]` and the index of the oldest element, or `List<T, N>`";
    MAP: "a model has no heap, on which a map grows", "use a `List<(K, V), N>` that is searched, or an array with the key as index";
    HEAP: "a model has no heap", "hold the value itself; of several kinds make an `enum`";
    DYNAMIC_MATRIX: "the size of a dynamic matrix is not known when the C is written", "use `SMatrix<f64, R, C>` or `SVector<f64, N>`";
    STD: "std is not there on the target", "use `core`, and pass what the platform provides as an input";
    SHARED_CELL: "shared mutable state is not in the DSL", "state belongs into the component: a field, which its methods change through `&mut self`";
    FORMAT: "text is not formatted on the target", "return the numbers, and format them where they are shown";
    ENTRY_ARGUMENT: "`#[entry]` takes nothing, `infallible`, `atomic` or `single`", "write `#[entry]`, `#[entry(infallible)]`, `#[entry(atomic)]` or `#[entry(single)]`";
    ENTRY_BOTH: "an infallible entry has nothing to roll back", "leave out `atomic`, or `infallible`";
    ENTRY_INLINE: "an entry point is called by the firmware, and stands by itself", "leave `#[inline(always)]` out";
    ENTRY_GENERIC: "the firmware calls functions of fixed types: an entry point is not generic", "name the types; for several make the component generic, and name its instances";
    ENTRY_CLOSURE: "the firmware has no closure to pass to an entry point", "choose with an `enum` and a `match`, or make the component generic over an `#[interface]`";
    UNROLL: "this does not say how far a loop is written out", "write `#[unroll(4)]`, at most 64, or `#[keep]`";
    UNIT: "this is no unit", "write `#[unit(\"m/s\")]`";
    FOREIGN_IMPLEMENTATION: "an interface is implemented by numbers and by types of the author's own in the DSL", "wrap the value: `#[data] struct Gain(f64);`, and implement the interface for that";
    INTERFACE_CLOSURE: "a method of an interface takes no closure in the DSL", "write a function or a method of a type that takes it";
    RANGE: "this is no range", "write the least and the greatest number: `#[range(0.0..=5.0)]`";
    RANGE_PLACE: "a range is that of a number that is set", "write it on a field or a parameter";
    UNIT_PLACE: "a unit is that of a number", "write it on a field, a parameter, a constant, or on the function that gives the number";
    C_ALONE: "`#[c(…)]` means something below the DSL's attribute alone", "write it below `#[function]`, `#[data]` or `#[component]`, or on a method of a marked `impl` block";
    SECTION_PLACE: "only a function or a constant has a place in the object file", "leave the section out";
    TABLE_UNNAMED: "a constant without a name is not part of the C", "leave the attribute out";
    C_ARGUMENT: "`#[c(…)]` takes `name`, `section`, and of functions `result`", "write `#[c(name = \"pid_step\", section = \".fast\")]`";
    C_NAME: "this is no name that C takes", "begin with a letter; go on with letters, digits and `_`";
    C_SECTION: "this is no name of a section", "write letters, digits, `.`, `_`: `.fast`";
    INLINE_SECTION: "a function that stands where it is called is in no section of its own", "leave `#[inline]` out, or the section";
    GENERIC_NAME: "each instance of what is generic needs a name of its own in the C", "leave the name out, and name the instance with `type`";
    EXTERNAL_ARGUMENT: "an external function names its header", "write `#[external(header = \"board.h\")]`, with `name = \"…\"` if it is called otherwise in the C";
    EXTERNAL_GENERIC: "an external function has one type", "write one function for each type";
    ENTRY_ALONE: "`#[entry]` stands on a method inside an `impl` block marked `#[component]`", "write `#[component]` above the `impl` block; a free function is called from an entry point";
    RUST_TYPE: "a function of the DSL that is named as one of Rust's types hides that type", "give it another name, `to_f64`";
    ENTRY_OF_DATA: "plain data has no entry points", "mark the struct and this block `#[component]`";
    MACRO: "this macro is not part of the DSL", "write the expression out, or a function marked `#[function]`";
}

/// Macros that show something to a reader.
const SHOWING: &str =
    "format print println eprint eprintln write writeln dbg trace debug info warn error log";

/// The reason for a macro that is not taken.
pub fn macro_call(name: &str) -> Reason {
    match name {
        _ if SHOWING.split(' ').any(|it| it == name) => FORMAT,
        "vec" => LIST,
        _ => MACRO,
    }
}

/// The reason for an expression that is not taken, and where to say it.
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

/// The reason for an implementation of one of Rust's own traits.
pub fn known_trait(path: &syn::Path) -> Option<Reason> {
    let name = path.segments.last()?.ident.to_string();
    Some(match name.as_str() {
        "Deref" | "DerefMut" => OPERATOR_TRAIT,
        "PartialOrd" | "Ord" => OWN_ORDER,
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
        | "FusedIterator"
        | "Drop" => STD_TRAIT,
        _ => return None,
    })
}

/// The reason for what is out of reach in a library of Rust's own, with which a path begins; none if it begins otherwise.
pub fn library(path: &syn::Path) -> Option<Reason> {
    let first = path.segments.first().filter(|_| path.segments.len() > 1)?;
    match first.ident.to_string().as_str() {
        "std" => Some(STD),
        "core" => Some(CORE),
        "alloc" => Some(HEAP),
        _ => None,
    }
}

/// The reason for a type that its name shows to be out of reach.
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
        "u128" | "i128" => WIDE_INTEGER,
        "str" => STRING,
        _ => return None,
    })
}
