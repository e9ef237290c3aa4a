//! Numbers taken from a range that is held.
use bessemer::prelude::*;

#[function]
pub fn range_taken(mut part: core::ops::Range<u8>) -> Option<u8> {
    part.next();
    part.nth(1)
}
