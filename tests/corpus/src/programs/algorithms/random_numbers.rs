//! Pseudo-random generators behind a trait, `&mut impl Rng`, with a distribution and a shuffle.

use bessemer::prelude::*;
#[interface]
pub trait Rng {
    fn next_u32(&mut self) -> u32;

    fn unit(&mut self) -> f32 {
        (self.next_u32() >> 8) as f32 * (1.0 / 16_777_216.0)
    }

    fn below(&mut self, bound: u32) -> u32 {
        ((u64::from(self.next_u32()) * u64::from(bound)) >> 32) as u32
    }

    fn shuffle<T>(&mut self, items: &mut [T])
    where
        Self: Sized,
    {
        for i in (1..items.len()).rev() {
            let j = self.below(i as u32 + 1) as usize;
            items.swap(i, j);
        }
    }
}

#[data]
#[derive(Clone, Debug)]
pub struct XorShift32(u32);

#[data]
impl XorShift32 {
    pub fn new(seed: u32) -> Self {
        Self(if seed == 0 { 0x9E37_79B9 } else { seed })
    }
}

#[data]
impl Rng for XorShift32 {
    fn next_u32(&mut self) -> u32 {
        let Self(x) = self;
        *x ^= *x << 13;
        *x ^= *x >> 17;
        *x ^= *x << 5;
        *x
    }
}

#[data]
#[derive(Clone, Debug)]
pub struct Pcg {
    state: u64,
    increment: u64,
}

#[data]
impl Pcg {
    pub fn new(seed: u64, stream: u64) -> Self {
        let mut rng = Pcg { state: 0, increment: stream << 1 | 1 };
        rng.next_u32();
        rng.state = rng.state.wrapping_add(seed);
        rng.next_u32();
        rng
    }
}

#[data]
impl Rng for Pcg {
    fn next_u32(&mut self) -> u32 {
        let old = self.state;
        self.state = old
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(self.increment);
        let mixed = (((old >> 18) ^ old) >> 27) as u32;
        mixed.rotate_right((old >> 59) as u32)
    }
}

#[function]
pub fn normal<R: Rng + ?Sized>(rng: &mut R) -> f32 {
    let sum: f32 = (0..12).map(|_| rng.unit()).sum();
    sum - 6.0
}

#[function]
pub fn monte_carlo_pi(rng: &mut impl Rng, samples: u32) -> f32 {
    let inside = (0..samples)
        .filter(|_| {
            let (x, y) = (rng.unit(), rng.unit());
            x * x + y * y <= 1.0
        })
        .count();
    4.0 * inside as f32 / samples as f32
}

#[function]
pub fn dice(seed: u32) -> ([u8; 8], f32) {
    let mut rng = XorShift32::new(seed);
    let mut deck = [0, 1, 2, 3, 4, 5, 6, 7];
    rng.shuffle(&mut deck);
    (deck, normal(&mut rng))
}

#[function]
pub fn pi(seed: u64, use_pcg: bool) -> f32 {
    if use_pcg {
        monte_carlo_pi(&mut Pcg::new(seed, 54), 200)
    } else {
        monte_carlo_pi(&mut XorShift32::new(seed as u32), 200)
    }
}
