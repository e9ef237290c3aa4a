//! Fast functions in every part of their domain, and beyond it.

use bessemer::fast;
use bessemer::prelude::*;

/// Sine, cosine, and both at once.
#[function]
pub fn turned(angle: f32) -> [f32; 4] {
    let (sine, cosine) = fast::sin_cos(angle);
    [fast::sin(angle), fast::cos(angle), sine, cosine]
}

/// A power of e, and the angle of a point.
#[function]
pub fn grown(x: f32, y: f32) -> [f32; 2] {
    [fast::exp(x), fast::atan2(y, x)]
}

/// A rotating field.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Field {
    /// Angle, rad.
    pub angle: f32,
}

#[component]
impl Field {
    /// Advances the angle; the result is the first phase.
    #[entry(infallible, single)]
    pub fn step(&mut self, rate: f32) -> f32 {
        self.angle += rate;
        rate * fast::sin(self.angle)
    }
}
