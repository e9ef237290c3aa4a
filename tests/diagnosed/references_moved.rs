//! References that are made to refer to something else.
#![no_std]
use bessemer::prelude::*;

/// Two buffers.
#[data]
#[derive(Clone, Copy, Debug, Default)]
pub struct Buffers {
    pub front: [f64; 2],
    pub back: [f64; 2],
}

/// Exchanges the names, not the buffers.
#[function]
pub fn exchanged(buffers: &mut Buffers, turned: bool) {
    let mut shown = &mut buffers.front;
    let mut drawn = &mut buffers.back;
    if turned {
        let kept = shown;
        shown = drawn;
        drawn = kept;
    }
    shown[0] = 1.0;
    drawn[0] = 2.0;
}

/// Swaps by a function.
#[function]
pub fn swapped(buffers: &mut Buffers, turned: bool) {
    let mut shown = &mut buffers.front;
    let mut drawn = &mut buffers.back;
    if turned {
        core::mem::swap(&mut shown, &mut drawn);
    }
    shown[0] = 1.0;
    drawn[0] = 2.0;
}

/// Several at once.
#[function]
pub fn turned(buffers: &mut Buffers) {
    let mut shown = &mut buffers.front;
    let mut drawn = &mut buffers.back;
    (shown, drawn) = (drawn, shown);
    shown[0] = 1.0;
    drawn[0] = 2.0;
}

/// The best so far.
#[function]
pub fn best(candidates: &[Buffers; 4]) -> f64 {
    let mut best = &candidates[0];
    for candidate in candidates {
        if candidate.front[0] > best.front[0] {
            best = candidate;
        }
    }
    best.back[1]
}

/// A parameter that refers to a constant.
#[function]
pub fn least(mut one: &f64) -> f64 {
    if *one < 2.0 {
        one = &2.0;
    }
    *one
}
