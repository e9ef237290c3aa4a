//! Calls of `idsp` over plain numbers.

use crate::*;

pub fn angles(y: i32, x: i32, phase: i32) -> (i32, (i32, i32)) {
    (atan2(y, x), cossin(phase))
}

pub fn locked(inputs: [i32; 8], gain: i32) -> [(i32, i32); 8] {
    let mut pll = PLL::default();
    let mut out = [(0, 0); 8];
    for k in 0..8 {
        pll.update(Some(inputs[k]), gain);
        out[k] = (pll.phase(), pll.frequency());
    }
    out
}

pub fn counted(inputs: [i32; 8], shift: u32) -> [(i32, u32); 8] {
    let mut pll = RPLL::new(8);
    let mut out = [(0, 0); 8];
    for k in 0..8 {
        out[k] = pll.update(Some(inputs[k]), 8 + shift % 16, 9 + shift % 16);
    }
    out
}

pub fn modulated(inputs: [u32; 8]) -> [i8; 8] {
    let mut dsm = Dsm::<3>::default();
    let mut out = [0; 8];
    for k in 0..8 {
        out[k] = dsm.update(inputs[k]);
    }
    out
}

pub fn smoothed(inputs: [i32; 8], k: [i32; 2]) -> ([i32; 8], [i32; 8]) {
    let mut one = Lowpass1::default();
    let mut two = Lowpass2::default();
    let (mut first, mut second) = ([0; 8], [0; 8]);
    for n in 0..8 {
        first[n] = one.update(inputs[n], &[k[0]]);
        second[n] = two.update(inputs[n], &k);
    }
    (first, second)
}

pub fn scaled(lo: i32, hi: i32, shift: u32) -> i32 {
    saturating_scale(lo, hi, 1 + shift % 31)
}
