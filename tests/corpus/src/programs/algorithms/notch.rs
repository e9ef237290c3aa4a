//! A notch filter whose frequency follows a motor's speed.

use bessemer::prelude::*;

/// State of the filter.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Notch {
    inputs: [f32; 2],
    outputs: [f32; 2],
}

#[component]
impl Notch {
    /// Filters one sample; `frequency` and the sample rate `rate` are in Hz, `width` is a fraction of the frequency.
    #[entry(infallible)]
    pub fn step(&mut self, sample: f32, frequency: f32, width: f32, rate: f32) -> f32 {
        let angle = core::f32::consts::TAU * frequency / rate;
        let (sine, cosine) = (angle.sin(), angle.cos());
        let alpha = sine * width / 2.0;
        let scale = 1.0 / (1.0 + alpha);
        let middle = -2.0 * cosine * scale;
        let output = scale * (sample + self.inputs[1]) + middle * (self.inputs[0] - self.outputs[0])
            - (1.0 - alpha) * scale * self.outputs[1];
        self.inputs = [sample, self.inputs[0]];
        self.outputs = [output, self.outputs[0]];
        output
    }
}
