//! A generic type with a refused method has no further error for its instance.
#![no_std]
use bessemer::prelude::*;

/// A stage.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stage<T> {
    /// Content.
    pub value: T,
}

/// The instance.
#[component]
pub type SingleStage = Stage<f32>;

#[component]
impl<T: Real> Stage<T> {
    /// A range that is held, and may change.
    #[entry]
    pub fn step(&mut self) -> T {
        let mut passes = 0..3;
        for _ in &mut passes {
            self.value = self.value + real(1.0);
        }
        self.value
    }
}
