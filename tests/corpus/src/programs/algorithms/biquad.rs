//! A cascade of second-order sections in transposed direct form II.

use bessemer::prelude::*;

/// Number of sections in the cascade.
pub const SECTIONS: usize = 3;

/// One section: `(b0 + b1/z + b2/z²) / (1 + a1/z + a2/z²)`.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Section {
    pub b: [f32; 3],
    pub a: [f32; 2],
}

/// State of the cascade: two values for each section.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cascade {
    memory: [[f32; 2]; SECTIONS],
}

#[component]
impl Cascade {
    /// Filters one sample.
    #[entry(infallible)]
    pub fn step(&mut self, sections: &[Section; SECTIONS], sample: f32) -> f32 {
        let mut value = sample;
        for (section, memory) in sections.iter().zip(self.memory.iter_mut()) {
            let output = section.b[0] * value + memory[0];
            memory[0] = section.b[1] * value - section.a[0] * output + memory[1];
            memory[1] = section.b[2] * value - section.a[1] * output;
            value = output;
        }
        value
    }
}
