//! The value analysis: abstract interpretation with intervals and a few relations.
//!
//! A *state* of an execution says which word each place holds. A [`State`] represents a set of them, its meaning:
//! * an interval of a place ([`domain`]): the word there lies within;
//! * a float of a place: the word there is that float, and no NaN;
//! * a relation ([`relations`]): the condition, evaluated there, gives true.
//!
//! A state belongs to the meaning if all of these hold of it. Every function here keeps the one invariant: **each
//! execution that reaches a point without a fault is in the meaning of what is known at that point.**
//! * [`evaluate`] and [`transfer`]: the value of an expression lies in what is computed for it;
//! * [`State::assign`], [`State::forget`]: what may have been written is no longer known;
//! * [`results`]: what a call gives lies in what its function was seen to return;
//! * [`assume`]: a condition narrows the state only where it decides that the code runs (a branch, a check before);
//! * [`State::join`]: the meaning holds that of both sides;
//! * [`loops`]: what is known at the head of a loop holds before its first pass, and again after each pass that
//!   begins there;
//! * [`walk`]: the same rules along statements, for a look ahead at the body of a loop.
//!
//! Enums and `bool`s come from outside, too, where any byte can represent one. So an enum of `n` variants has `n + 1`
//! values here, the indices of its variants and one for whatever is none of them ([`State::stray`]).
//!
//! Must not know: which checks are written (`faults` asks), how statements are rewritten, C.

mod assume;
mod domain;
mod evaluate;
mod given;
mod glance;
mod invariant;
mod known;
mod loops;
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
