//! A buffer of any size that nothing uses.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Buffer<const N: usize> {
    pub values: [f32; N],
}

#[data]
impl<const N: usize> Buffer<N> {
    pub fn first(&self) -> f32 {
        self.values[0]
    }
}

#[function]
pub fn whole(x: f32) -> f32 {
    x + 1.0
}
