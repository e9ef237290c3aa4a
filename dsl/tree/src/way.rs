//! The ranges and sequences of loops, the targets of assignments, and the claims of assertions.

use serde::{Deserialize, Serialize};

use super::{Expr, Pattern};

/// The way through an array.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Order {
    /// From the first element to the last.
    #[default]
    Up,
    /// From the last to the first, its index with each.
    Down,
    /// From the last to the first, counted from 0.
    Mirrored,
}

/// `.skip(n)`, or `.take(n)`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cut {
    /// Leaves so many out; else takes so many.
    pub skip: bool,
    /// Counted from the last one.
    pub back: bool,
    /// How many.
    pub count: Expr,
}

/// How elements are taken several at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Grouping {
    /// `.windows(n)`: each begins one further.
    Windows,
    /// `.chunks_exact(n)`: one behind the other, as long as they are whole.
    Whole,
    /// `.chunks(n)`: one behind the other, the last perhaps shorter.
    All,
    /// `.step_by(n)`: the first of each, by itself.
    First,
    /// `.cycle()`, perhaps with `.skip(n)`: single elements, from that number on, and the first behind the last.
    Around,
}

/// Groups that take the place of single elements.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Group {
    /// How.
    pub way: Grouping,
    /// Of how many elements.
    pub size: Expr,
}

/// An array that a loop goes through.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// The part that is taken from each element.
    pub pattern: Pattern,
    /// The array.
    pub array: Expr,
    /// Whether the loop goes through a copy.
    pub owned: bool,
    /// Groups that take the place of single elements.
    pub group: Option<Group>,
    /// Whether it is gone through from its end, beside others that are not.
    #[serde(default)]
    pub reversed: bool,
}

impl Part {
    /// Each element by itself, from the first on.
    pub fn of(pattern: Pattern, array: Expr, owned: bool) -> Part {
        Part { pattern, array, owned, group: None, reversed: false }
    }
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
