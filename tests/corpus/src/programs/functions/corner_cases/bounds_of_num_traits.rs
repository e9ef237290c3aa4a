//! Functions that are generic over numbers by the traits of `num_traits`. Each bound is alone, with calls by method and
//! by path; conversions are between numbers of any two types.

use bessemer::prelude::*;
use num_traits::float::{FloatConst, FloatCore};
use num_traits::{
    AsPrimitive, Bounded, CheckedAdd, Euclid, Float, FromPrimitive, Num, NumCast, One, PrimInt, Signed, ToPrimitive,
    WrappingAdd, WrappingSub, Zero,
};

/// The sum of three numbers, from `zero`.
#[function]
fn sum<T: Zero + Copy>(values: [T; 3]) -> T {
    values.iter().fold(T::zero(), |total, value| total + *value)
}

/// The product of the numbers that are not zero, from `one`.
#[function]
fn product<T: Num + Copy>(values: [T; 3]) -> T {
    let mut product = <T as One>::one();
    for value in values {
        if !value.is_zero() {
            product = product * value;
        }
    }
    product
}

/// Distance between the extremes of a type, modulo what it holds.
#[function]
fn span<T: Bounded + WrappingSub>() -> T {
    T::max_value().wrapping_sub(&<T as Bounded>::min_value())
}

/// The value between limits, and the magnitude of that.
#[function]
fn limited<T: FloatCore>(value: T, low: T, high: T) -> T {
    let limited = value.max(low).min(high);
    if limited.is_nan() { T::zero() } else { limited.abs() + T::epsilon() }
}

/// The share of a step, by conversions of literals.
#[function]
fn share<T: Float>(value: T) -> T {
    let half = T::from(0.5).unwrap();
    let third: T = NumCast::from(0.25_f32).unwrap();
    value * half + third * T::from(3).unwrap()
}

/// Elementary functions by the path of the trait.
#[function]
fn raised<T: Float>(base: T, exponent: T) -> T {
    <T as Float>::atan2(base, exponent) + Float::sqrt(base)
}

/// Magnitude and sign.
#[function]
fn split<T: Signed + Copy>(value: T) -> (T, T, bool) {
    (value.abs(), value.signum(), value.is_negative())
}

/// Sum modulo what the type holds, in another type.
#[function]
fn mixed<T: WrappingAdd + AsPrimitive<U>, U: Copy + 'static>(one: T, other: T) -> U {
    one.wrapping_add(&other).as_()
}

/// The sum if the type holds it.
#[function]
fn checked<T: CheckedAdd + Zero>(one: T, other: T) -> T {
    one.checked_add(&other).unwrap_or(T::zero())
}

/// The angle within one turn.
#[function]
fn within<T: Euclid>(angle: T, turn: T) -> T {
    angle.rem_euclid(&turn)
}

/// Counts bits of an integer.
#[function]
fn weight<T: PrimInt>(word: T) -> u32 {
    word.count_ones() + word.leading_zeros()
}

/// The number in another type and back, if both hold it.
#[function]
fn there<T: ToPrimitive + FromPrimitive>(value: T) -> Option<T> {
    T::from_i16(value.to_i16()?)
}

/// An interface whose implementors have what `FloatCore` has.
#[interface]
trait Sample: FloatCore {
    /// The weight of a sample.
    fn weight(self) -> Self;
}

#[data]
impl Sample for f32 {
    fn weight(self) -> f32 {
        self * 0.5
    }
}

#[data]
impl Sample for f64 {
    fn weight(self) -> f64 {
        self * 0.25
    }
}

#[function]
fn weighted<T: Sample>(value: T, other: T) -> T {
    value.weight().max(other) + T::from(2).unwrap()
}

#[function]
pub fn of_floats(x: f64, y: f32) -> (f64, f32) {
    let double = limited(x, -1.0, 1.0) + share(x) + sum([x, 1.0, x]) + weighted(x, 0.5);
    let single = limited(y, -1.0, 1.0) + share(y) + product([y, 0.0, 2.0]) + weighted(y, 0.5);
    (double, single)
}

#[function]
pub fn of_powers(x: f32, y: f32) -> (f32, f32) {
    (raised(x, 1.5), raised(x, y))
}

#[function]
pub fn of_integers(x: i32, y: u8) -> (i32, u8) {
    (sum([x / 4, 1, x / 4]), product([y / 64, 0, 3]))
}

#[function]
pub fn of_signs(x: i16, y: f32) -> (i16, i16, bool, f32, f32, bool) {
    let ((a, b, c), (d, e, f)) = (split(x), split(y));
    (a, b, c, d, e, f)
}

#[function]
pub fn of_words(x: u8, y: i16) -> (u8, i16, u32, f64, i16) {
    (span::<u8>(), span::<i16>(), mixed(x, 200), mixed(y, 30_000), checked(y, 20_000))
}

#[function]
pub fn of_angles(x: f64, y: i32) -> (f64, i32, u32, u32) {
    (within(x, 360.0), within(y, 360), weight(y), weight(7_u8))
}

/// Conversions to each kind of type.
#[function]
pub fn of_double(x: f64) -> (Option<u8>, Option<i32>, Option<i64>, Option<f32>) {
    (NumCast::from(x), num_traits::cast(x), num_traits::cast(x), NumCast::from(x))
}

#[function]
pub fn of_single(x: f32) -> (Option<i8>, Option<i32>, Option<u64>, Option<f64>) {
    (NumCast::from(x), num_traits::cast(x), num_traits::cast(x), NumCast::from(x))
}

#[function]
pub fn of_whole(x: i64) -> (Option<u8>, Option<i32>, Option<u64>, Option<f32>) {
    (NumCast::from(x), num_traits::cast(x), num_traits::cast(x), NumCast::from(x))
}

#[function]
pub fn of_size(x: u64, y: f64) -> (Option<usize>, Option<i8>, Option<i64>, Option<f64>) {
    (NumCast::from(x), num_traits::cast(x), there(x as i64), there(y))
}

/// Each constant of a float, whose name is in capitals as a variant's is.
#[function]
fn constants<T: FloatConst + Float>() -> [T; 19] {
    [
        T::E(),
        T::FRAC_1_PI(),
        T::FRAC_1_SQRT_2(),
        T::FRAC_2_PI(),
        T::FRAC_2_SQRT_PI(),
        T::FRAC_PI_2(),
        T::FRAC_PI_3(),
        T::FRAC_PI_4(),
        T::FRAC_PI_6(),
        <T as FloatConst>::FRAC_PI_8(),
        T::LN_10(),
        T::LN_2(),
        T::LOG10_2(),
        T::LOG10_E(),
        T::LOG2_10(),
        T::LOG2_E(),
        T::PI(),
        T::SQRT_2(),
        T::TAU(),
    ]
}

/// Constants as elements, operands, and of a known type.
#[function]
pub fn of_constants(angle: f64, gain: f32) -> ([f64; 19], [f32; 19], f64, f32) {
    (constants(), constants(), angle % (f64::SQRT_2() + <f64 as FloatConst>::TAU()), gain * f32::LN_2())
}

/// Bounds by names that the module above imports.
mod below {
    use super::{FloatConst, Num};
    use bessemer::prelude::*;

    /// A turn of a circle times a number.
    #[function]
    pub fn circles<T: FloatConst + Num>(count: T) -> T {
        T::TAU() * count + <T as FloatConst>::E() * T::one()
    }
}

/// By names of the module above.
#[function]
pub fn of_the_module_below(x: f64, y: f32) -> (f64, f32) {
    (below::circles(x), below::circles(y))
}
