//! A method for any size, and functions of a closure and of an iterator, which nothing calls.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default)]
pub struct Scale {
    pub gain: f32,
}

#[data]
impl Scale {
    pub fn scaled<const N: usize>(&self, values: &[f32; N]) -> [f32; N] {
        values.map(|value| value * self.gain)
    }

    pub fn applied(&self, change: impl Fn(f32) -> f32) -> f32 {
        change(self.gain)
    }
}

#[function]
pub fn total(values: impl Iterator<Item = f32>) -> f32 {
    values.sum()
}

#[function]
pub fn amplified(scale: &Scale) -> f32 {
    scale.gain * 2.0
}
