//! Value analysis: abstract interpretation with intervals and some relations.
//!
//! A *state* of an execution is the word at each place. A [`State`] represents the set of states that satisfy its
//! facts:
//!
//! * an interval of a place ([`domain`]): the word is in it;
//! * a float of a place: the word is that float, and no NaN;
//! * a relation ([`relations`]): the condition, evaluated in the state, is true.
//!
//! Every function here preserves one invariant: **each execution that reaches a point without a fault satisfies the
//! facts at that point.**
//!
//! * [`evaluate`] and [`transfer`]: the value of an expression is in the computed interval;
//! * [`State::assign`], [`State::forget`]: facts about written places are dropped;
//! * [`results`]: the result of a call is in the intervals of its function's summary;
//! * [`assume`]: a condition narrows the state only where it holds (in a branch, after a check);
//! * [`State::join`]: the result includes both operands' states;
//! * [`loops`]: facts at the head of a loop hold before its first pass, and after each pass that begins with them;
//! * [`orders`]: orders of two numbers that a write, a join or a pass of a loop preserves;
//! * [`walk`]: the same rules along statements, to look ahead at a loop's body.
//!
//! Enums and `bool`s may come from outside, where they can be any byte. So an enum of `n` variants has `n + 1` values
//! here: the indices of its variants, and one for every invalid value ([`State::stray`]).
//!
//! Must not know: which checks are emitted (`faults` queries the analysis), how statements are rewritten, C.

mod assume;
mod bounds;
mod defined;
mod domain;
mod evaluate;
mod floats;
mod given;
mod glance;
mod invariant;
mod known;
mod loops;
mod orders;
mod relations;
mod results;
mod state;
#[cfg(test)]
mod tests;
mod transfer;
mod walk;

pub(super) use domain::Interval;
pub(super) use loops::Loop;
pub(super) use results::Results;
pub(super) use state::State;
pub(super) use walk::held;
