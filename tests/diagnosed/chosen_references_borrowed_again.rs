//! Mutable references that an `if`, a `match`, a block or a loop chooses, and that are borrowed again, whole or in part.
#![no_std]
use bessemer::prelude::*;

/// One of two variables, by an `if`.
#[function]
pub fn by_if(x: u32) -> u32 {
    let (mut a, mut b) = (x, 4);
    let chosen = &mut *(if x > 3 { &mut a } else { &mut b });
    *chosen = 7;
    a ^ b
}

/// One of two variables, by a `match`.
#[function]
pub fn by_match(x: u32) -> u32 {
    let (mut a, mut b) = (x, 4);
    let chosen = &mut **(&mut match x {
        3 => &mut a,
        _ => &mut b,
    });
    *chosen = 7;
    a ^ b
}

/// A variable, by a block.
#[function]
pub fn by_block(x: u32) -> u32 {
    let mut a = [x, 2];
    let chosen = &mut *{ &mut a };
    chosen[0] ^= 3;
    a[0]
}

/// A variable, by a loop.
#[function]
pub fn by_loop(x: u32) -> u32 {
    let mut a = x;
    let chosen = &mut *loop {
        break &mut a;
    };
    *chosen = 2;
    a
}

/// A pair.
#[data]
#[derive(Clone, Copy)]
pub struct Pair {
    /// First.
    pub x: u32,
    /// Second.
    pub y: [u32; 2],
}

/// A field of one of two variables.
#[function]
pub fn a_field(c: bool) -> u32 {
    let (mut p, mut q) = (Pair { x: 1, y: [2, 3] }, Pair { x: 4, y: [5, 6] });
    let chosen = &mut (if c { &mut p } else { &mut q }).x;
    *chosen = 7;
    p.x ^ q.x
}

/// An element of a field of one of two variables.
#[function]
pub fn an_element(c: bool) -> u32 {
    let (mut p, mut q) = (Pair { x: 1, y: [2, 3] }, Pair { x: 4, y: [5, 6] });
    let chosen = &mut (match c {
        true => &mut p,
        false => &mut q,
    })
    .y[1];
    *chosen = 7;
    p.y[1] ^ q.y[1]
}
