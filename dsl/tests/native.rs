//! An annotated item, run by Rust, does as written, save that the methods that the DSL owns
//! are the DSL's, in every spelling. This crate links std, so a method that slips past is std's.

use bessemer::math::{arctangent, sine, single, tangent};
use bessemer::prelude::*;

/// Another name for a float.
type Real = f64;

/// An argument whose sine std rounds otherwise: the sentinel of the tests below.
fn where_sines_differ() -> f64 {
    let mut candidates = (1..2_000_000).map(|i| f64::from(i) * 0.001);
    candidates.find(|&x| std_sin(x) != sine::sin(x)).expect("two implementations differ somewhere")
}

fn std_sin(x: f64) -> f64 {
    std::hint::black_box(x).sin()
}

/// The sine in every spelling; bit by bit.
#[function]
pub fn sines(x: f64, r: &f64) -> [f64; 6] {
    [x.sin(), f64::sin(x), Real::sin(x), <f64>::sin(x), r.sin(), (x + 0.0).sin()]
}

/// A sine inside an assertion.
#[function]
pub fn asserted(x: f64, expected: f64) -> bool {
    assert!(x.sin() == expected, "the sine of {x} is {}", x.sin());
    true
}

/// The others that a platform decides.
#[function]
pub fn others(x: f64, y: f64) -> [f64; 4] {
    [x.cos(), x.tan(), y.atan2(x), f64::atan2(y, x)]
}

/// In single precision.
#[function]
pub fn singles(x: f32, y: f32) -> [f32; 4] {
    [x.sin(), f32::cos(x), x.tan(), y.atan2(x)]
}

/// Returns results that Rust leaves open.
#[function]
pub fn edges(x: f64, y: f64) -> [f64; 4] {
    [x.min(y), f64::max(x, y), x.abs(), 1.0_f64.copysign(x)]
}

/// The bits.
#[function]
pub fn bits(x: f64, y: f32) -> [u64; 2] {
    [x.to_bits(), y.to_bits() as u64]
}

/// Returns results of integers.
#[function]
pub fn integers(n: i32, m: u8) -> [i32; 4] {
    [n.abs(), n.min(3), m.max(7) as i32, i32::clamp(n, -1, 1)]
}

/// A level, with methods that floats have too.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Level {
    /// Its value.
    pub value: f64,
}

#[component]
impl Level {
    /// A constant of its own.
    pub const STEP: f64 = 0.5;

    /// Not the exponential.
    pub fn exp(&mut self, by: f64) -> f64 {
        self.value += by;
        self.value
    }

    /// Not the floor of a float.
    pub fn floor(&self) -> f64 {
        self.value.floor() - 100.0
    }

    /// Not the sine of a float, and without a receiver.
    pub fn sin(x: f64) -> f64 {
        x.sin() + 100.0
    }

    fn round(&self) -> f64 {
        self.value + Self::STEP
    }

    /// Calls all of them.
    #[entry]
    pub fn step(&mut self) -> f64 {
        self.exp(1.0) + self.floor() + Level::floor(self) + Self::sin(0.0) + self.round()
    }
}

/// Calls them from elsewhere.
#[function]
pub fn from_elsewhere(level: &mut Level) -> f64 {
    level.exp(1.0) + level.floor() + Level::sin(0.0)
}

fn same(a: &[f64], b: &[f64]) {
    let bits = |all: &[f64]| {
        all.iter().map(|x| if x.is_nan() { 0 } else { x.to_bits() }).collect::<Vec<_>>()
    };
    assert_eq!(bits(a), bits(b), "{a:?} {b:?}");
}

#[test]
fn no_sine_slips_past() {
    let x = where_sines_differ();
    same(&sines(x, &x), &[sine::sin(x); 6]);
    assert!(asserted(x, sine::sin(x)));
}

#[test]
fn no_other_function_slips_past() {
    for i in 1..100_000 {
        let (x, y) = (f64::from(i) * 0.37, 1.0 / f64::from(i));
        let [cos, tan, atan2] = [sine::cos(x), tangent::tan(x), arctangent::atan2(y, x)];
        same(&others(x, y), &[cos, tan, atan2, atan2]);
    }
    let (x, y) = (2.5_f32, -1.25_f32);
    let expected = [single::sinf(x), single::cosf(x), single::tanf(x), single::atan2f(y, x)];
    assert_eq!(singles(x, y), expected);
}

#[test]
fn what_rust_leaves_open_is_settled() {
    same(&edges(-0.0, 0.0), &[-0.0, 0.0, 0.0, -1.0]);
    same(&edges(0.0, -0.0), &[-0.0, 0.0, 0.0, 1.0]);
    for nan in [f64::NAN, -f64::NAN] {
        same(&edges(nan, 2.0), &[2.0, 2.0, f64::NAN, 1.0]);
        same(&edges(2.0, nan), &[2.0, 2.0, 2.0, 1.0]);
        let canonical = [0x7ff8_0000_0000_0000, 0x7fc0_0000];
        assert_eq!(bits(nan, nan as f32), canonical);
    }
    assert_eq!(bits(-0.0, -0.0), [1 << 63, 1 << 31]);
}

/// The elements of D in U D Uᵀ.
#[function]
pub fn variances(p: &Matrix3<f64>) -> Option<Vector3<f64>> {
    Some(p.udu()?.d)
}

/// nalgebra squares by `powi`: with std a product, and without it `libm`'s `pow`, which rounds otherwise (to a first element
/// that ends in 80). So its bits hang on what else is linked.
#[test]
fn factors_of_a_covariance_are_of_products() {
    let words: [u64; 9] = [
        0x400c_d400_0000_0000,
        0xc002_d800_0000_0000,
        0xbfff_0800_0000_0000,
        0xc005_7400_0000_0000,
        0x400a_2400_0000_0000,
        0x400c_7400_0000_0000,
        0xc006_6c00_0000_0000,
        0x3fda_c000_0000_0000,
        0x3ffc_0000_0000_0000,
    ];
    let p = Matrix3::from_column_slice(&words.map(f64::from_bits));
    let first = variances(&p).map(|d| d[0].to_bits());
    assert_eq!(first, Some(0xc001_4ec6_509a_bd82));
}

#[test]
fn integers_are_as_in_rust() {
    assert_eq!(integers(-5, 3), [5, -5, 7, -1]);
    assert_eq!(integers(5, 9), [5, 3, 9, 1]);
}

#[test]
fn an_authors_method_may_have_an_owned_name() {
    let mut level = Level { value: 0.5 };
    assert_eq!(level.step(), 1.5 - 99.0 - 99.0 + 100.0 + 2.0);
    assert_eq!(from_elsewhere(&mut level), 2.5 - 98.0 + 100.0);
    // And outside of the DSL, by the author's name.
    assert_eq!((level.floor(), Level::sin(0.0), level.round()), (-98.0, 100.0, 3.0));
}

#[test]
#[should_panic]
fn clamping_between_crossed_bounds_is_a_fault() {
    integers_between(0, 1, -1);
}

/// Between two bounds.
#[function]
pub fn integers_between(n: i32, low: i32, high: i32) -> i32 {
    n.clamp(low, high)
}
