//! The text form of the IR: [`print()`] and [`parse()`], inverse to each other in everything, spans,
//! documentation and comments included.
//!
//! ```text
//! module demo
//! file "demo/src/lib.rs"
//!
//! /// Gains of one axis.
//! @0:3:12 struct Pid in demo {
//!   /// Proportional.
//!   p: f64,
//! }
//!
//! const LIMIT in demo: f64 = 2.5
//!
//! @0:9:8 entry fn Pid::step in demo(self: &Pid, error: f64) -> f64 as thrust {
//!   // Never more than the motor takes.
//!   @10:5 let raw: f64 = self.p@15 * error@24;
//!   @11:5 return raw.min(LIMIT);
//! }
//! ```
//!
//! * **Spans**: `@column`, `@line:column` or `@file:line:column`, in front of items and statements,
//!   behind expressions, places and types of locals. What is left out is taken from the statement (or
//!   item) around. Without any `@`: a statement has the span of what surrounds it; an expression has
//!   its first operand's where the operand comes first, else its statement's.
//! * `@0:9:14 hexadecimal 32768`: the literal there, of that word, is written in base sixteen; with
//!   `constant 3` the author wrote that constant, and with `variant 2 0` that variant of an enum.
//! * **Names** stand bare where they are unique and defined above, else behind their handle:
//!   `%3.err` (local), `#3.step` (function), `const#3.LIMIT`, `struct#3.Pid`, `enum#3.Mode`. A name
//!   that is no identifier or is a word of this language is in double quotes. Locals are numbered
//!   from the last declaration on; `let name: type` declares, `let name` refers to what is declared;
//!   `var` declares without a statement.
//! * **Types** of expressions follow from their operands; `(expression : type)` states another.
//!   Integers carry a suffix, `3i32`; without one they are `usize`. `0x…` is a bare word.
//! * **Operators** and their precedence are Rust's. Intrinsics and routines are methods, `x.min(y)`,
//!   `a.tr_mul(b)`; `splat<4>(x)`, `splat<3, 1>(x)` and `matrix<3, 1>(a, b, c)` build matrices by
//!   columns; `m[row, column]`; `struct Pid { p: x }`; `x as f64`.
//! * **Statements** are Rust's, with `for i: usize in rev 0..n`, `check condition else overflow;` and
//!   `_ => {}` for the rest of a `match`.
//! * **Comments** `//` right above a statement belong to it; elsewhere they are dropped. A comment or
//!   doc line of more than plain characters stands as `//"…"`, `///"…"`.
//!
//! Invariants: `parse(print(m)) == m` for a module whose functions have as many locals as parameters
//! or more, and whose nesting stays within [`MAX_NESTING`] and [`MAX_HEIGHT`]; the parser returns an
//! error and never panics, overflows or runs out of memory, whatever the input.
//!
//! Absent: validity. A module that no back end would take prints and parses all the same.

mod lex;
mod names;
mod parse;
mod parse_body;
mod parse_expr;
mod parse_type;
mod print;
mod print_body;
mod print_expr;
mod scope;

pub use lex::ParseError;
pub use names::{FAULTS, INTRINSICS, ROUTINES};
pub use parse::parse;
pub use print::print;

/// Largest nesting of parentheses, blocks and types in the text.
pub const MAX_NESTING: u32 = 128;

/// Largest number of operand levels of an expression.
pub const MAX_HEIGHT: u32 = 512;
