//! `max` by its bare name: the DSL does not see whose it is. A copy of what does not copy itself.
#![no_std]
use bessemer::prelude::*;
use core::cmp::max;

/// The larger.
#[function]
pub fn larger(a: u8, b: u8) -> u8 {
    max(a, b)
}

/// Clone alone.
#[data]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Log {
    /// What came.
    pub values: [u8; 4],
}

/// A copy.
#[function]
pub fn kept(log: &Log) -> u8 {
    let copy = log.clone();
    copy.values[0]
}
