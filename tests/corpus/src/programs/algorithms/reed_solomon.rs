//! Reed–Solomon over GF(256): computes syndromes and corrects one error.
use bessemer::prelude::*;

pub const N: usize = 15;
const PARITY: usize = 4;

const fn exponents() -> [u8; 255] {
    let mut table = [0; 255];
    let mut x: u16 = 1;
    let mut i = 0;
    while i < 255 {
        table[i] = x as u8;
        x <<= 1;
        if x & 0x100 != 0 {
            x ^= 0x11D;
        }
        i += 1;
    }
    table
}

const EXP: [u8; 255] = exponents();
const LOG: [u8; 256] = {
    let mut table = [0; 256];
    let mut i = 0;
    while i < 255 {
        table[EXP[i] as usize] = i as u8;
        i += 1;
    }
    table
};

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gf(u8);

impl core::ops::Mul for Gf {
    type Output = Gf;
    fn mul(self, other: Gf) -> Gf {
        self.times(other)
    }
}

#[data]
impl Gf {
    pub fn times(self, other: Gf) -> Gf {
        match (self, other) {
            (Gf(0), _) | (_, Gf(0)) => Gf(0),
            (Gf(a), Gf(b)) => {
                let sum = usize::from(LOG[a as usize]) + usize::from(LOG[b as usize]);
                Gf(EXP[sum % 255])
            }
        }
    }

    pub fn plus(self, other: Gf) -> Gf {
        Gf(self.0 ^ other.0)
    }
}

#[function]
pub fn syndromes(word: &[u8; N]) -> [Gf; PARITY] {
    core::array::from_fn(|j| {
        let root = Gf(EXP[j]);
        word.iter().fold(Gf(0), |sum, &symbol| sum.times(root).plus(Gf(symbol)))
    })
}

#[function]
pub fn corrected(mut word: [u8; N]) -> Option<[u8; N]> {
    let s = syndromes(&word);
    if s.iter().all(|s| s.0 == 0) {
        return Some(word);
    }
    if s.iter().any(|&s| s == Gf(0)) {
        return None;
    }
    let ratio = |i: usize| (255 + i16::from(LOG[s[i + 1].0 as usize]) - i16::from(LOG[s[i].0 as usize])) % 255;
    let place = ratio(0);
    if (1..PARITY - 1).any(|i| ratio(i) != place) || place as usize >= N {
        return None;
    }
    word[N - 1 - place as usize] ^= s[0].0;
    Some(word)
}
