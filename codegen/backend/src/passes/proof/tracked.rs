//! Records of what a loop does to numbers: orders that it preserves, movements, and numbers where paths meet.
//!
//! Must not know: how any of them is found ([`orders`](super::orders), [`moved`](super::moved)).

use bessemer_ir::LocalId;

use super::knowledge::Bounds;
use super::linear::Linear;
use super::values::{At, Point, Value};
use super::written::Target;

/// Movement in a pass from which a word may be set rather than moved.
pub(super) const FAR: i128 = 255;

/// End of an order that a loop may preserve.
#[derive(Clone)]
pub(super) enum End {
    /// The number in a local at that time.
    Local(LocalId),
    /// The number that a local had before the loop.
    Start(Linear),
}

/// Two numbers of which the first is at most the second.
#[derive(Clone)]
pub(super) struct Order(pub(super) End, pub(super) End);

/// A number that differs on two paths where they meet, with its value on each.
pub(super) struct Met {
    pub(super) here: Linear,
    pub(super) paths: [Linear; 2],
}

impl Met {
    /// Returns the number, unless its value is the same on both paths.
    pub(super) fn of(here: &Value, one: &Value, other: &Value) -> Option<Met> {
        let (Value::Number(here), Value::Number(one), Value::Number(other)) = (here, one, other)
        else {
            return None;
        };
        (one != other).then(|| Met { here: here.clone(), paths: [one.clone(), other.clone()] })
    }
}

/// A word that passes move.
pub(super) struct Moved {
    pub(super) word: Target,
    /// Its number before the loop.
    pub(super) old: Linear,
    /// Least and greatest movement of a pass.
    pub(super) by: Bounds,
}

/// Returns the number at a place, if it is known as a form.
pub(super) fn number_at<'p>(point: &'p Point, word: &Target) -> Option<&'p Linear> {
    match point.places.get(word.local.0)?.iter().find(|(at, _)| *at == word.at) {
        Some((_, Value::Number(form))) => Some(form),
        _ => None,
    }
}

/// Records the number at a place.
pub(super) fn put(point: &mut Point, word: &Target, number: Linear) {
    let held = point.places.change(word.local.0);
    held.retain(|(at, _): &(Vec<At>, Value)| *at != word.at);
    held.push((word.at.clone(), Value::Number(number)));
}
