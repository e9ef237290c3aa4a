//! The elementary functions of `f32` in `f32` arithmetic alone, for processors without `f64` in hardware.
//!
//! The feature `single` of this crate replaces those of [`super::single`], which compute in double precision, by
//! these: see `docs/design/numbers.md`. They use no `f64` and no 64-bit integers. A fused multiply-add is used only
//! where it rounds nothing, so that splitting the factors into halves gives the same result. The error is at most one
//! unit in the last place; where a single sum would lose more, its rounding error is kept in a second float.

pub mod arctangent;
pub mod exponential;
pub mod hyperbolic;
pub mod logarithm;
pub mod power;
pub mod reduction;
pub mod roots;
pub mod sine;
pub mod tangent;

pub use arctangent::{acosf, asinf, atan2f, atanf};
pub use exponential::{exp_m1f, exp2f, expf};
pub use hyperbolic::{coshf, sinhf, tanhf};
pub use logarithm::{ln_1pf, lnf, log2f, log10f};
pub use power::{powff, powif};
pub use roots::{cbrtf, hypotf};
pub use sine::{cosf, sin_cosf, sinf};
pub use tangent::tanf;

use super::RawBits as _;
use crate::prelude::*;

/// 1.5 · 2²³: added to a smaller number it leaves the nearest integer in the last bits.
pub const TO_INTEGER: f32 = 12_582_912.0;

/// The leading 12 bits of a number: the product of two such is exact.
#[inline]
#[function]
pub(crate) fn leading(x: f32) -> f32 {
    f32::from_bits(x.raw_bits() & 0xffff_f000)
}

/// A number as a sum of two floats.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PairF32 {
    /// The number rounded to a float.
    pub high: f32,
    /// The error of `high`.
    pub low: f32,
}

/// The sum and its rounding error, if |`a`| ≥ |`b`| or the sum is exact (T. J. Dekker).
#[inline]
#[function]
pub(crate) fn ordered_sum(a: f32, b: f32) -> PairF32 {
    let high = a + b;
    PairF32 { high, low: b - (high - a) }
}

/// `x * a + b` where that is exactly a float, such as the rounding error of a product.
///
/// It is computed from halves of the factors (T. J. Dekker), or by a processor's fused instruction, which rounds
/// nothing there. Below 2⁻¹⁰⁰ and beyond 2¹²⁷ the two may differ: callers do not let a bit of their results depend on
/// that.
#[inline]
#[function]
pub(crate) fn exact_mul_addf(x: f32, a: f32, b: f32) -> f32 {
    let x_upper = leading(x);
    let x_lower = x - x_upper;
    let a_upper = leading(a);
    let a_lower = a - a_upper;
    ((x_upper * a_upper + b) + x_upper * a_lower + x_lower * a_upper) + x_lower * a_lower
}

#[cfg(test)]
mod tests {
    extern crate std;

    /// A processor's fused instruction and halves of the factors agree wherever the functions use them.
    #[test]
    fn exact_products_are_those_of_a_fused_instruction() {
        let turn = std::env::var("BESSEMER_TURN").ok().and_then(|it| it.parse().ok());
        let (stride, first) = match std::env::var_os("BESSEMER_FULL") {
            Some(_) => (1, 0),
            None => (4093, turn.unwrap_or(0_u32).wrapping_mul(1009) % 4093),
        };
        let mut factor = 0x3f80_0000_u32 ^ first;
        for bits in (0x2000_0000 + first..0x5f00_0000).step_by(stride) {
            factor = factor.wrapping_mul(0x0019_660d).wrapping_add(0x3c6e_f35f);
            let x = f32::from_bits(bits);
            // 2⁻¹⁶ to 2¹⁵, of either sign.
            let a = f32::from_bits((factor & 0x8fff_ffff | 0x3000_0000) + 0x0780_0000);
            let product = x * a;
            let halves = super::exact_mul_addf(x, a, -product);
            let fused = x.mul_add(a, -product);
            assert_eq!(halves.to_bits(), fused.to_bits(), "{x:e} {a:e}");
        }
    }
}
