//! A function inside another is a separate C function, named after both; a constant slice is the array that it refers to.

use bessemer::prelude::*;

/// The median of five samples.
#[function]
pub fn middle([mut a, mut b, mut c, mut d, mut e]: [f32; 5]) -> f32 {
    /// Puts two samples in order.
    fn order(low: &mut f32, high: &mut f32) {
        if *high < *low {
            core::mem::swap(low, high);
        }
    }
    order(&mut a, &mut b);
    order(&mut d, &mut e);
    order(&mut c, &mut e);
    order(&mut c, &mut d);
    order(&mut a, &mut d);
    order(&mut a, &mut c);
    order(&mut b, &mut d);
    order(&mut b, &mut c);
    c
}

/// The first byte of a message's checksum; `None` for an unknown message.
#[function]
pub fn extra(message: u8) -> Option<u8> {
    const EXTRAS: &[(u8, u8)] = &[(0, 50), (1, 124), (24, 24), (30, 39), (33, 104)];
    EXTRAS.binary_search_by_key(&message, |&(known, _)| known).ok().map(|at| EXTRAS[at].1)
}

/// Smooths a signal.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mixing {
    pub state: f64,
}

#[component]
impl Mixing {
    /// Takes a sample; returns the smoothed signal.
    #[entry(infallible)]
    pub fn step(&mut self, sample: f64, fast: bool) -> f64 {
        fn mix(from: f64, to: f64, share: f64) -> f64 {
            from + (to - from) * share
        }
        self.state = mix(self.state, sample, if fast { 0.5 } else { 0.125 });
        self.state
    }
}
