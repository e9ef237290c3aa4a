//! Mutable references that an `if`, a `match`, a block or a loop chooses, and that are borrowed again.
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
