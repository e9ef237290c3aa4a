//! What a function returns, as its callers may know it.
//!
//! The meaning: in every execution of the function that returns, whatever its arguments, each number that is listed lies
//! within its bounds. Of what an external function returns, which the firmware brings, nothing is listed.

use std::collections::BTreeMap;

use super::knowledge::Bounds;

/// Bounds of the numbers in a result, each with the fields that lead to it.
pub type Returns = BTreeMap<Vec<u32>, Bounds>;

/// What is returned, where `now` may be returned beside what was seen before.
pub(super) fn with(before: Option<Returns>, now: Returns) -> Returns {
    let Some(mut before) = before else { return now };
    before.retain(|at, held| {
        let now = now.get(at);
        now.inspect(|now| *held = (held.0.min(now.0), held.1.max(now.1))).is_some()
    });
    before
}
