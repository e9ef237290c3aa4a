//! Sequences that loops iterate over, and the claims of assertions.

use alloc::boxed::Box;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::Expr;

/// Sequence that a loop iterates over, composed of others by adapters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Source {
    /// The elements of an array, or what a function gives; whether the loop goes through a copy.
    Elements(Expr, bool),
    /// `from..to`.
    Numbers(Range),
    /// `array.windows(n)` and the like.
    Groups(Grouping, Expr, Expr),
    /// `a.zip(b)`: as far as the shorter of the two. Where the syntax does not show elements in `b`, the function that takes
    /// the next item of it.
    Zip(Box<Source>, Box<Source>, Option<u32>),
    /// `a.chain(b)`.
    Chain(Box<Source>, Box<Source>),
    /// `a.enumerate()`.
    Enumerate(Box<Source>),
    /// `a.rev()`.
    Rev(Box<Source>),
    /// `a.cycle()`.
    Cycle(Box<Source>),
    /// `a.skip(n)`.
    Skip(Box<Source>, Expr),
    /// `a.take(n)`.
    Take(Box<Source>, Expr),
    /// `a.step_by(n)`.
    StepBy(Box<Source>, Expr),
}

impl Source {
    /// Returns the sources of its items, pair by pair.
    pub fn leaves(&self) -> Vec<&Source> {
        match self {
            Source::Zip(one, other, _) => {
                let mut leaves = one.leaves();
                leaves.extend(other.leaves());
                leaves
            }
            Source::Enumerate(of)
            | Source::Rev(of)
            | Source::Cycle(of)
            | Source::Skip(of, _)
            | Source::Take(of, _)
            | Source::StepBy(of, _) => of.leaves(),
            Source::Elements(..) | Source::Numbers(_) | Source::Groups(..) | Source::Chain(..) => {
                alloc::vec![self]
            }
        }
    }
}

/// A range of numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Range {
    /// The first.
    pub from: Expr,
    /// The last, plus one unless `inclusive`. Without one, a step from the last number of its type is a fault.
    pub to: Option<Expr>,
    /// True if `to` itself is included.
    pub inclusive: bool,
    /// Their type.
    pub slot: u32,
}

/// Grouping of elements taken several at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Grouping {
    /// `.windows(n)`: each begins one further.
    Windows,
    /// `.chunks_exact(n)`: one behind the other, as long as they are whole.
    Whole,
    /// `.chunks(n)`: one behind the other, the last perhaps shorter.
    All,
}

/// The fault where an assertion does not hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Claim {
    /// Whatever the author says.
    Assertion,
    /// An index is beyond the end.
    Index,
    /// There is no room.
    Capacity,
    /// The bounds of `clamp` are the wrong way round.
    Clamp,
}
