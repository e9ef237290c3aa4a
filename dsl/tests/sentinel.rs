//! No elementary function slips past to the platform's: this crate links std, and each function is
//! called at an argument where std rounds otherwise.

use bessemer::math::{
    arctangent, exponential, fused, hyperbolic, logarithm, power, roots, sine, single, tangent,
};
use bessemer::prelude::*;

/// For each function: the call in a model, the DSL's own, std's, and the range in which they are told
/// apart.
macro_rules! sentinels {
    ($($test:ident: $float:ident, $method:ident($($other:literal)?), $own:path, $range:expr;)*) => {$(
        mod $test {
            use super::*;

            #[function]
            pub fn in_a_model(x: $float) -> [$float; 2] {
                [x.$method($($other)?), $float::$method(x $(, $other)?)]
            }
        }

        #[test]
        fn $test() {
            let [low, high]: [$float; 2] = $range;
            let mut parted = false;
            for step in 0..200_000 {
                let x = low + (high - low) * (step as $float / 200_000.0);
                let own = $own(x $(, $other)?);
                parted |= std::hint::black_box(x).$method($($other)?) != own;
                assert_eq!($test::in_a_model(x), [own; 2], "{x:e}");
            }
            assert!(parted, "std computes the same everywhere: no sentinel");
        }
    )*};
}

sentinels! {
    sines: f64, sin(), sine::sin, [-20.0, 20.0];
    cosines: f64, cos(), sine::cos, [-20.0, 20.0];
    tangents: f64, tan(), tangent::tan, [-20.0, 20.0];
    arcsines: f64, asin(), arctangent::asin, [-1.0, 1.0];
    arccosines: f64, acos(), arctangent::acos, [-1.0, 1.0];
    arctangents: f64, atan(), arctangent::atan, [-20.0, 20.0];
    angles: f64, atan2(1.25), arctangent::atan2, [-20.0, 20.0];
    exponentials: f64, exp(), exponential::exp, [-20.0, 20.0];
    binary_exponentials: f64, exp2(), exponential::exp2, [-20.0, 20.0];
    exponentials_less_one: f64, exp_m1(), exponential::exp_m1, [-2.0, 2.0];
    logarithms: f64, ln(), logarithm::ln, [0.1, 20.0];
    binary_logarithms: f64, log2(), logarithm::log2, [0.1, 20.0];
    decimal_logarithms: f64, log10(), logarithm::log10, [0.1, 20.0];
    logarithms_of_one_more: f64, ln_1p(), logarithm::ln_1p, [-0.9, 20.0];
    hyperbolic_sines: f64, sinh(), hyperbolic::sinh, [-20.0, 20.0];
    hyperbolic_cosines: f64, cosh(), hyperbolic::cosh, [-20.0, 20.0];
    hyperbolic_tangents: f64, tanh(), hyperbolic::tanh, [-2.0, 2.0];
    powers: f64, powf(1.75), power::powf, [0.1, 20.0];
    cube_roots: f64, cbrt(), roots::cbrt, [-20.0, 20.0];
    sines_f32: f32, sin(), single::sinf, [-20.0, 20.0];
    cosines_f32: f32, cos(), single::cosf, [-20.0, 20.0];
    tangents_f32: f32, tan(), single::tanf, [-20.0, 20.0];
    arcsines_f32: f32, asin(), single::asinf, [-1.0, 1.0];
    arccosines_f32: f32, acos(), single::acosf, [-1.0, 1.0];
    arctangents_f32: f32, atan(), single::atanf, [-20.0, 20.0];
    angles_f32: f32, atan2(1.25), single::atan2f, [-20.0, 20.0];
    exponentials_f32: f32, exp(), single::expf, [-20.0, 20.0];
    binary_exponentials_f32: f32, exp2(), single::exp2f, [-20.0, 20.0];
    exponentials_less_one_f32: f32, exp_m1(), single::exp_m1f, [-2.0, 2.0];
    logarithms_f32: f32, ln(), single::lnf, [0.1, 20.0];
    binary_logarithms_f32: f32, log2(), single::log2f, [0.1, 20.0];
    decimal_logarithms_f32: f32, log10(), single::log10f, [0.1, 20.0];
    logarithms_of_one_more_f32: f32, ln_1p(), single::ln_1pf, [-0.9, 20.0];
    hyperbolic_sines_f32: f32, sinh(), single::sinhf, [-20.0, 20.0];
    hyperbolic_cosines_f32: f32, cosh(), single::coshf, [-20.0, 20.0];
    hyperbolic_tangents_f32: f32, tanh(), single::tanhf, [-2.0, 2.0];
    powers_f32: f32, powf(1.75), single::powff, [0.1, 20.0];
    cube_roots_f32: f32, cbrt(), single::cbrtf, [-20.0, 20.0];
    whole_powers_f32: f32, powi(7), single::powif, [-20.0, 20.0];
}

/// Returns results that std computes with the same bits.
#[function]
fn without_a_sentinel(x: f64, y: f32) -> [f64; 4] {
    let (sine, cosine) = x.sin_cos();
    [x.mul_add(x, -1.0) + f32::mul_add(y, y, -1.0) as f64, sine + cosine, x.hypot(1.25), x.powi(7)]
}

#[test]
fn those_without_a_sentinel() {
    for step in 0..10_000 {
        let x = f64::from(step) * 0.01;
        let y = x as f32;
        let fused = fused::mul_add(x, x, -1.0) + f64::from(fused::mul_addf(y, y, -1.0));
        let both = sine::sin(x) + sine::cos(x);
        let expected = [fused, both, roots::hypot(x, 1.25), power::powi(x, 7)];
        assert_eq!(without_a_sentinel(x, y), expected);
    }
}
