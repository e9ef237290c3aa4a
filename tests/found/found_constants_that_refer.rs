// Constants and statics that are slices, or references to arrays: of a module, a type, a function; gone through, matched, passed on.
pub mod found_constants_that_refer_m {
    use bessemer::prelude::*;
    #[data]
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Row { pub id: u8, pub gain: f32 }
    pub const ROWS: &[Row] = &[Row { id: 3, gain: 0.5 }, Row { id: 9, gain: -2.0 }, Row { id: 30, gain: 1.0e9 }];
    pub const BYTES: &[u8; 3] = b"abc";
    const BASE: [u16; 4] = [1, 2, 3, 40000];
    /// Said of it.
    #[data]
    pub const PART: &[u16] = &BASE;
    pub static FIXED: &[i32] = &[-7, 8, i32::MIN];
    const FAST: &[u8] = &[1, 2];
    const SLOW: &[u8] = &[9, 8, 7, 6];
    const LEN: usize = SLOW.len();
    #[data]
    #[derive(Clone, Copy, Default)]
    pub struct Kind(u8);
    #[data]
    impl Kind {
        pub const TABLE: &'static [(u8, i16)] = &[(1, -1), (7, 300), (200, 4)];
        const LETTERS: &'static [u8] = b"xyz";
        pub fn named(self) -> u8 { Self::LETTERS[self.0 as usize % Self::LETTERS.len()] }
        pub fn entry(self) -> Option<i16> { Self::TABLE.iter().find(|(k, _)| *k == self.0).map(|&(_, v)| v) }
    }
    #[function]
    fn total(of: &[u8]) -> u32 { of.iter().map(|&b| u32::from(b)).sum() }
    #[function]
    pub fn found_constants_that_refer(id: u8, i: usize, fast: bool) -> (f32, u32, u16) {
        let gain = ROWS.iter().find(|row| row.id == id % 32).map_or(0.0, |row| row.gain);
        let t = SLOW;
        let mut sum = 0u32;
        for b in t { sum += u32::from(*b); }
        for (k, &b) in BYTES.iter().enumerate() { sum += u32::from(b) * k as u32; }
        sum += if fast { total(FAST) } else { total(SLOW) } + total(&SLOW[1..]) + total(BYTES) + LEN as u32;
        if let [first, .., last] = SLOW { sum += u32::from(*first) + u32::from(*last); }
        if let Some(&x) = FAST.get(i) { sum += u32::from(x); }
        (gain, sum, PART[i])
    }
    #[function]
    pub fn found_constants_that_refer_b(k: u8, i: usize) -> (u8, i16, i32, u8) {
        const INNER: &[i32] = &[5, 6];
        let it = Kind(k);
        (it.named(), it.entry().unwrap_or(-9), FIXED[i % 3].wrapping_add(INNER[i % INNER.len()]), Kind::TABLE[i % 3].0)
    }
    #[function]
    pub fn found_constants_that_refer_c(k: u8) -> (Option<u8>, usize, bool) {
        (FAST.first().copied(), FAST.iter().chain(SLOW).filter(|&&b| b > k).count(), SLOW.contains(&k) || FAST == &[k, 2])
    }
}

pub use found_constants_that_refer_m::{found_constants_that_refer, found_constants_that_refer_b, found_constants_that_refer_c};
