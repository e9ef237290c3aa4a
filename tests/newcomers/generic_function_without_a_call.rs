//! A function for each float that nothing calls.
use bessemer::prelude::*;

#[function]
pub fn halved<T: Real>(x: T) -> T {
    x * bessemer::math::real(0.5)
}

#[function]
pub fn whole(x: f32) -> f32 {
    x + 1.0
}
