//! An iterator of a generic type that is copied where a loop takes it.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Down<T> {
    left: u8,
    step: T,
}

#[data]
impl<T: Copy + Into<u8>> Iterator for Down<T> {
    type Item = u8;

    fn next(&mut self) -> Option<u8> {
        let step: u8 = self.step.into();
        self.left = self.left.checked_sub(step.max(1))?;
        Some(self.left)
    }
}

#[function]
pub fn copied_generic_iterator(from: u8) -> u32 {
    let down = Down { left: from, step: 60_u8 };
    let sum = down.take(9).map(u32::from).sum::<u32>();
    sum ^ u32::from(down.left)
}
