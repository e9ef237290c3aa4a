//! Lowers syn's tree to the DSL's tree and to the witness copy, in one walk.
//!
//! Each method lowers one syntactic form, and rewrites it in place to its witness form: the same code with every
//! value passed through a slot, so that rustc's inferred types can be read. Spans, parentheses and the author's `&`
//! are preserved, so an error in the copy equals the original's.
//!
//! Unsupported Rust is refused at its own token, all of it at once ([`refuse`]).
//!
//! Each file lowers the forms in its name, as methods of [`Lowering`].
//!
//! Must not know: types, or the meaning of a call.

mod aliases;
mod call;
mod closure;
mod control;
mod deferred;
mod each;
mod expr;
mod generator;
mod handed;
mod hygiene;
mod link;
pub mod loops;
pub mod macros;
mod moved;
mod names;
mod operator;
mod pattern;
pub mod refuse;
mod rewrite;
mod signature;
pub mod sort;
mod statements;
mod strip;
mod syntax;
mod walk;
mod written;

pub use aliases::Aliases;
pub use call::companion_name;
pub use closure::{mutable_names, without_returns};
pub use generator::{hand_on, items};
pub use hygiene::check_hygiene;
pub use macros::asked;
pub use names::{Site, callee_name, generating, in_generation, own_name, site, slot_name, text};
pub use pattern::{is_constant_name, member};
pub use refuse::Refusals;
pub use signature::{
    Parameter, borrows, check_field, check_type, gives_reference, lends, name_parts, named_part,
    parameters,
};
pub use strip::{check_attributes, lasting_path, lasting_type, name_lifetimes, name_owner, strip};
pub use syntax::last_ident;
pub use walk::{Begin, Constant, Lowering};
