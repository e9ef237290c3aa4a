//! The measured functions, and their true values by MPFR.

use bessemer::math::{
    arctangent, exponential, hyperbolic, logarithm, power, roots, sine, single, tangent,
};
use rug::Float;

use crate::points::{DOMAINS, Domain};

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
}

impl Subject {
    /// Returns the domain on which the function is measured.
    ///
    /// # Panics
    /// For a function that `DOMAINS` lacks.
    pub fn domain(&self) -> &'static Domain {
        let found = DOMAINS.iter().find(|domain| domain.name == self.name);
        found.expect("each function has its domain")
    }
}

const fn one(
    name: &'static str,
    double: fn(f64) -> f64,
    single: fn(f32) -> f32,
    truth: fn(&mut Float),
) -> Subject {
    Subject { name, double: Of::One(double), single: Of::One(single), truth: Of::One(truth) }
}

const fn two(
    name: &'static str,
    double: fn(f64, f64) -> f64,
    single: fn(f32, f32) -> f32,
    truth: fn(&mut Float, &Float),
) -> Subject {
    Subject { name, double: Of::Two(double), single: Of::Two(single), truth: Of::Two(truth) }
}

pub const SUBJECTS: &[Subject] = &[
    one("sin", sine::sin, single::sinf, |x| x.sin_mut()),
    one("cos", sine::cos, single::cosf, |x| x.cos_mut()),
    one("tan", tangent::tan, single::tanf, |x| x.tan_mut()),
    one("asin", arctangent::asin, single::asinf, |x| x.asin_mut()),
    one("acos", arctangent::acos, single::acosf, |x| x.acos_mut()),
    one("atan", arctangent::atan, single::atanf, |x| x.atan_mut()),
    two("atan2", arctangent::atan2, single::atan2f, |y, x| y.atan2_mut(x)),
    one("exp", exponential::exp, single::expf, |x| x.exp_mut()),
    one("exp2", exponential::exp2, single::exp2f, |x| x.exp2_mut()),
    one("exp_m1", exponential::exp_m1, single::exp_m1f, |x| x.exp_m1_mut()),
    one("ln", logarithm::ln, single::lnf, |x| x.ln_mut()),
    one("log2", logarithm::log2, single::log2f, |x| x.log2_mut()),
    one("log10", logarithm::log10, single::log10f, |x| x.log10_mut()),
    one("ln_1p", logarithm::ln_1p, single::ln_1pf, |x| x.ln_1p_mut()),
    one("sinh", hyperbolic::sinh, single::sinhf, |x| x.sinh_mut()),
    one("cosh", hyperbolic::cosh, single::coshf, |x| x.cosh_mut()),
    one("tanh", hyperbolic::tanh, single::tanhf, |x| x.tanh_mut()),
    two("powf", power::powf, single::powff, |x, y| x.pow_assign_(y)),
    one("cbrt", roots::cbrt, single::cbrtf, |x| x.cbrt_mut()),
    two("hypot", roots::hypot, single::hypotf, |x, y| x.hypot_mut(y)),
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
