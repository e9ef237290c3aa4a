//! A stack for what nests as deep as an author's expressions.
//!
//! A sum of two thousand terms is a tree of two thousand levels, and each stage calls itself once for a level. Whoever
//! hands a tree, or a module, to a stage does it here.

/// Bytes, of which only those that are used take memory: some ten kilobytes a level, in builds that are not optimised.
const STACK: usize = 1 << 30;

/// Does the work on a stack of its own, unless it is on one.
pub fn deep<T>(work: impl FnOnce() -> T) -> T {
    stacker::maybe_grow(STACK / 2, STACK, work)
}
