//! Sequences that loops iterate over, and the claims of assertions.

use alloc::boxed::Box;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::Expr;

/// Sequence that a loop iterates over, composed of others by adapters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Source {
    /// Elements of an array, or items of a function's result; true if the loop iterates over a copy.
    Elements(Expr, bool),
    /// `from..to`.
    Numbers(Range),
    /// `array.windows(n)` and the like.
    Groups(Grouping, Expr, Expr),
    /// `a.zip(b)`, which ends with the shorter of the two. If the syntax does not show that `b` has elements, the
    /// number is the callee that takes its next item.
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

    /// Returns true if a condition holds for the source, or for one that it adapts or combines.
    pub fn any(&self, holds: &impl Fn(&Source) -> bool) -> bool {
        holds(self)
            || match self {
                Source::Zip(one, other, _) | Source::Chain(one, other) => {
                    one.any(holds) || other.any(holds)
                }
                Source::Enumerate(of)
                | Source::Rev(of)
                | Source::Cycle(of)
                | Source::Skip(of, _)
                | Source::Take(of, _)
                | Source::StepBy(of, _) => of.any(holds),
                Source::Elements(..) | Source::Numbers(_) | Source::Groups(..) => false,
            }
    }
}

/// A range of numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Range {
    /// First number.
    pub from: Expr,
    /// Last number, plus one unless `inclusive`. Without it, a step from the last number of the type is a fault.
    pub to: Option<Expr>,
    /// True if the range includes `to`.
    pub inclusive: bool,
    /// Slot of the numbers' type.
    pub slot: u32,
}

/// Grouping of elements taken several at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Grouping {
    /// `.windows(n)`: each begins one element after the one before.
    Windows,
    /// `.chunks_exact(n)`: consecutive groups, without an incomplete one.
    Whole,
    /// `.chunks(n)`: consecutive groups, of which the last may be shorter.
    All,
}

/// Fault of a failed assertion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Claim {
    /// An assertion of the author's.
    Assertion,
    /// An index is out of range.
    Index,
    /// A container is full.
    Capacity,
    /// The bounds of `clamp` are in the wrong order.
    Clamp,
    /// A result does not fit into its type.
    Overflow,
    /// A divisor is zero.
    DivisionByZero,
    /// A number is shifted by its width or more.
    Shift,
}
