//! Validation of a module. Passes, interpreter and back ends rely on these rules, which [`validate()`] checks.
//!
//! **Definitions**
//! * Every handle is in range; a struct's fields refer to earlier structs only; a call names an earlier
//!   function, so nothing recurses. Every span names a file of the module.
//! * Every type has between 1 and [`MAX_WORDS`] words: no empty struct, enum, array or matrix. `Unit` is
//!   used only as the result of a function. Types nest at most [`MAX_NESTING`] deep.
//! * A function that represents a kernel has the signature of [`Kernel::function`] and no body; it may have one
//!   more parameter, by which its caller passes memory.
//! * Fields of one struct, and variants of one enum, have different names.
//! * A constant, and the initial state of a component, has exactly the words of its type, each a value of
//!   its leaf. (`bool` 0 or 1; integers in range; enums below the number of variants; `f32` in 32 bits.)
//! * Parameters are locals; only they are references.
//!
//! **Statements**
//! * A local is declared (by a parameter, a `let`, a `for`) at most once in its function, before its use
//!   and in a block around it, and has been assigned on every path to a use. A part of a value is assigned,
//!   or passed by reference, only after the whole has been assigned.
//! * Nothing is assigned or passed by mutable reference through a `Ref` parameter; neither is the variable of a loop.
//! * Conditions are `bool`. A `Check` has a condition without calls.
//! * A `match` is on an integer or an enum; its values are in range, distinct, at least one to an arm;
//!   it has an `otherwise`, or names every variant.
//! * Bounds of a loop and its variable have one integer type. `Break` and `Continue` are in loops.
//! * Every path returns a value of the function's type; a function of result `Unit` returns none.
//! * A value of type `Unit` is never used: such a call is a statement.
//!
//! **Expressions**, bottom-up: each node has the type that its kind and its operands give, places and
//! loads too.
//! * Literals are words of a scalar or enum; `Neg` takes signed integers and floats, `Not` `bool` and
//!   integers; `+ - * / %` numbers, `& | ^` `bool` and integers, all of one type; shifts two integers;
//!   comparisons two scalars or enums of one type.
//! * Casts are those of Rust: numbers to numbers, `bool` and enums to integers, `bool` to `bool`.
//! * Intrinsics take operands of one type, and which that may be is said by [`Intrinsic::result`].
//!
//! [`Intrinsic::result`]: bessemer_ir::Intrinsic::result
//! [`Kernel::function`]: bessemer_ir::Kernel::function
//!
//! * The first field of a choice is a `bool` or an enum, and a literal of it in a literal of the struct;
//!   each other field belongs to one case. The first field of a sequence is a `usize`, the second an array.
//! * Structs, arrays and matrices have an element for each place, each of its type; a splat fills an
//!   array with its element type or a matrix with its scalar.
//! * Routines take matrices of floats (`Transpose`: of anything) of shapes that fit; `Scale` and
//!   `Unscale` a scalar second; `Cross` two of 3×1 or two of 1×3.
//! * A call passes what the parameters' modes and types request. A place passed by mutable reference
//!   does not overlap a place that another argument passes by reference. A call inside a later argument does not write
//!   to a place that an earlier one passes by reference. (By-value arguments may read it: they are copies.)
//! * Blocks nest at most [`MAX_BLOCKS`] deep and operands [`MAX_HEIGHT`], so that recursive functions can process them on a stack
//!   of [`deep`](crate::deep). The text form has less of both.
//!
//! Absent: anything that changes a module; anything that knows C.

mod body;
mod expr;
mod flow;
mod items;
mod problem;

use bessemer_ir::Module;

pub use bessemer_ir::text::MAX_NESTING;
pub use body::{MAX_BLOCKS, MAX_HEIGHT};
pub use items::MAX_WORDS;
pub use problem::{Error, Problem, Subject};

/// Checks every invariant of this module's documentation; all violations, in the order of the module.
/// Bodies are looked at only once the definitions hold.
pub fn validate(module: &Module) -> Result<(), Vec<Error>> {
    let (sizes, mut errors) = items::check(module);
    if errors.is_empty() {
        for index in 0..module.functions.len() {
            errors.extend(body::check(module, &sizes, index));
        }
    }
    if errors.is_empty() { Ok(()) } else { Err(errors) }
}
