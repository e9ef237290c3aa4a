//! A method for any size, one of a generic type, and functions of a closure and of an iterator, which nothing calls.
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

#[data]
#[derive(Clone, Copy, Default)]
pub struct Line<T> {
    pub slope: T,
    pub offset: T,
}

#[data]
impl<T: Real> Line<T> {
    pub fn at(&self, x: T) -> T {
        self.slope * x + self.offset
    }

    pub fn root(&self) -> T {
        -self.offset / self.slope
    }
}

#[data]
#[derive(Clone, Copy, Default)]
pub struct Unused<T> {
    pub value: T,
}

#[data]
impl<T: Real> Unused<T> {
    pub fn twice(&self) -> T {
        self.value + self.value
    }
}

#[function]
pub fn lifted(line: &Line<f32>, x: f32) -> f32 {
    line.at(x) + 1.0
}

#[function]
pub fn total(values: impl Iterator<Item = f32>) -> f32 {
    values.sum()
}

#[function]
pub fn amplified(scale: &Scale) -> f32 {
    scale.gain * 2.0
}
