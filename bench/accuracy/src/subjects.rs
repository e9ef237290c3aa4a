//! The functions, and the truth of each.

use bessemer::math::{
    arctangent, exponential, hyperbolic, logarithm, power, roots, sine, single, tangent,
};
use rug::Float;

/// A function of one or of two arguments.
pub enum Of<One, Two> {
    One(One),
    Two(Two),
}

/// A function under measurement.
pub struct Subject {
    pub name: &'static str,
    pub double: Of<fn(f64) -> f64, fn(f64, f64) -> f64>,
    pub single: Of<fn(f32) -> f32, fn(f32, f32) -> f32>,
    pub truth: Of<fn(&mut Float), fn(&mut Float, &Float)>,
    /// Where most points lie, of each argument.
    pub range: [(f64, f64); 2],
    /// Whether multiples of π/2 are hard.
    pub periodic: bool,
}

const fn one(
    name: &'static str,
    double: fn(f64) -> f64,
    single: fn(f32) -> f32,
    truth: fn(&mut Float),
    range: (f64, f64),
) -> Subject {
    Subject {
        name,
        double: Of::One(double),
        single: Of::One(single),
        truth: Of::One(truth),
        range: [range, (0.0, 1.0)],
        periodic: range.1 == TURNS,
    }
}

const fn two(
    name: &'static str,
    double: fn(f64, f64) -> f64,
    single: fn(f32, f32) -> f32,
    truth: fn(&mut Float, &Float),
    range: [(f64, f64); 2],
) -> Subject {
    Subject {
        name,
        double: Of::Two(double),
        single: Of::Two(single),
        truth: Of::Two(truth),
        range,
        periodic: false,
    }
}

const TURNS: f64 = 12.5;

pub const SUBJECTS: &[Subject] = &[
    one("sin", sine::sin, single::sinf, |x| x.sin_mut(), (-TURNS, TURNS)),
    one("cos", sine::cos, single::cosf, |x| x.cos_mut(), (-TURNS, TURNS)),
    one("tan", tangent::tan, single::tanf, |x| x.tan_mut(), (-TURNS, TURNS)),
    one("asin", arctangent::asin, single::asinf, |x| x.asin_mut(), (-1.0, 1.0)),
    one("acos", arctangent::acos, single::acosf, |x| x.acos_mut(), (-1.0, 1.0)),
    one("atan", arctangent::atan, single::atanf, |x| x.atan_mut(), (-8.0, 8.0)),
    two("atan2", arctangent::atan2, single::atan2f, |y, x| y.atan2_mut(x), [(-2.0, 2.0); 2]),
    one("exp", exponential::exp, single::expf, |x| x.exp_mut(), (-745.2, 710.0)),
    one("exp2", exponential::exp2, single::exp2f, |x| x.exp2_mut(), (-1075.0, 1024.0)),
    one("exp_m1", exponential::exp_m1, single::exp_m1f, |x| x.exp_m1_mut(), (-3.0, 3.0)),
    one("ln", logarithm::ln, single::lnf, |x| x.ln_mut(), (0.0, 4.0)),
    one("log2", logarithm::log2, single::log2f, |x| x.log2_mut(), (0.0, 4.0)),
    one("log10", logarithm::log10, single::log10f, |x| x.log10_mut(), (0.0, 4.0)),
    one("ln_1p", logarithm::ln_1p, single::ln_1pf, |x| x.ln_1p_mut(), (-1.0, 3.0)),
    one("sinh", hyperbolic::sinh, single::sinhf, |x| x.sinh_mut(), (-25.0, 25.0)),
    one("cosh", hyperbolic::cosh, single::coshf, |x| x.cosh_mut(), (-25.0, 25.0)),
    one("tanh", hyperbolic::tanh, single::tanhf, |x| x.tanh_mut(), (-3.0, 3.0)),
    two(
        "powf",
        power::powf,
        single::powff,
        |x, y| x.pow_assign_(y),
        [(0.0, 10.0), (-100.0, 100.0)],
    ),
    one("cbrt", roots::cbrt, single::cbrtf, |x| x.cbrt_mut(), (-10.0, 10.0)),
    two("hypot", roots::hypot, single::hypotf, |x, y| x.hypot_mut(y), [(-2.0, 2.0); 2]),
];

trait PowAssign {
    fn pow_assign_(&mut self, y: &Float);
}

impl PowAssign for Float {
    fn pow_assign_(&mut self, y: &Float) {
        use rug::ops::PowAssign as _;
        self.pow_assign(y);
    }
}
