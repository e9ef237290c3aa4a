//! Gray, Morton and Hamming codes, and a reader of bits with Exp-Golomb numbers.

use bessemer::prelude::*;
#[function]
pub const fn gray(x: u32) -> u32 {
    x ^ (x >> 1)
}

#[function]
pub const fn ungray(mut g: u32) -> u32 {
    let mut shift = 16;
    while shift > 0 {
        g ^= g >> shift;
        shift /= 2;
    }
    g
}

#[function]
fn spread(x: u16) -> u32 {
    const MASKS: [(u32, u32); 4] = [
        (8, 0x00FF_00FF),
        (4, 0x0F0F_0F0F),
        (2, 0x3333_3333),
        (1, 0x5555_5555),
    ];
    MASKS
        .iter()
        .fold(x as u32, |v, &(shift, mask)| (v | v << shift) & mask)
}

#[function]
pub fn morton(x: u16, y: u16) -> u32 {
    spread(x) | spread(y) << 1
}

#[function]
pub fn hamming_encode(nibble: u8) -> u8 {
    let d: [u8; 4] = core::array::from_fn(|i| nibble >> i & 1);
    let p0 = d[0] ^ d[1] ^ d[3];
    let p1 = d[0] ^ d[2] ^ d[3];
    let p2 = d[1] ^ d[2] ^ d[3];
    [p0, p1, d[0], p2, d[1], d[2], d[3]]
        .iter()
        .enumerate()
        .fold(0, |word, (i, bit)| word | bit << i)
}

#[function]
pub fn hamming_decode(mut word: u8) -> (u8, Option<u8>) {
    let syndrome = (0..7u8)
        .filter(|&i| word & (1 << i) != 0)
        .fold(0u8, |s, i| s ^ (i + 1));
    let fixed = match syndrome {
        0 => None,
        n => {
            word ^= 1 << (n - 1);
            Some(n)
        }
    };
    let nibble = [2, 4, 5, 6]
        .iter()
        .rev()
        .fold(0, |acc, &i| acc << 1 | (word >> i & 1));
    (nibble, fixed)
}

#[data]
pub struct BitReader<'a> {
    data: &'a [u8],
    position: usize,
}

#[data]
impl<'a> BitReader<'a> {
    pub fn new(data: &'a [u8]) -> Self {
        BitReader { data, position: 0 }
    }

    pub fn bit(&mut self) -> Option<bool> {
        let byte = self.data.get(self.position / 8)?;
        let bit = byte >> (7 - self.position % 8) & 1 == 1;
        self.position += 1;
        Some(bit)
    }

    pub fn bits(&mut self, count: u32) -> Option<u32> {
        (0..count).try_fold(0, |acc, _| Some(acc << 1 | u32::from(self.bit()?)))
    }

    /// Reads an Exp-Golomb number, as in H.264.
    pub fn golomb(&mut self) -> Option<u32> {
        let mut zeros = 0;
        #[bound(32)]
        while !self.bit()? {
            zeros += 1;
            if zeros > 31 {
                return None;
            }
        }
        Some((1 << zeros) - 1 + self.bits(zeros)?)
    }
}

#[function]
pub fn codes(x: u32, y: u16) -> [u32; 4] {
    let g = gray(x);
    [g, ungray(g) ^ x, morton(x as u16, y), x.reverse_bits().rotate_left(5) ^ x.swap_bytes()]
}

#[function]
pub fn noisy(nibbles: [u8; 4], flip: u8) -> u32 {
    nibbles
        .map(|n| hamming_decode(hamming_encode(n & 15) ^ (1 << (flip % 7))))
        .iter()
        .fold(0, |acc, (n, fixed)| acc << 8 | u32::from(*n) << 4 | u32::from(fixed.unwrap_or(0)))
}

#[function]
pub fn golombs(bytes: [u8; 6]) -> (u32, u32, u32) {
    let mut reader = BitReader::new(&bytes);
    let mut n = 0;
    let mut sum = 0u32;
    #[bound(48)]
    while let Some(v) = reader.golomb() {
        n += 1;
        sum = sum.wrapping_add(v);
    }
    let ones = bytes.iter().map(|b| b.count_ones()).sum();
    (n, sum, ones)
}
