//! Bounds on types that are no parameters, conversions of a type to itself, several blocks of one generic type, and generic
//! comparisons.

use bessemer::prelude::*;
use core::cmp::Ordering;
use num_traits::{Float, PrimInt};

/// An angle in degrees.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Degrees(pub f64);

/// An angle in rad.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Radians(pub f64);

#[data]
impl From<Degrees> for Radians {
    fn from(angle: Degrees) -> Radians {
        Radians(angle.0 * 0.017_453_292_519_943_295)
    }
}

#[data]
impl From<Radians> for Degrees {
    fn from(angle: Radians) -> Degrees {
        Degrees(angle.0 / 0.017_453_292_519_943_295)
    }
}

/// A place on a sphere, by two angles of one unit.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot<A> {
    /// North of the equator.
    pub latitude: A,
    /// East of the meridian.
    pub longitude: A,
}

#[data]
impl From<Radians> for Spot<Radians> {
    fn from(angle: Radians) -> Spot<Radians> {
        Spot { latitude: angle, longitude: Radians(0.0) }
    }
}

#[data]
impl<A: Copy> Spot<A>
where
    Radians: From<A>,
{
    /// The latitude, rad.
    pub fn north(&self) -> f64 {
        Radians::from(self.latitude).0
    }
}

#[data]
impl<A> Spot<A>
where
    Radians: From<A>,
    A: From<Radians>,
    Self: Copy,
{
    /// The place farther north by an angle in rad.
    pub fn moved(self, by: f64) -> Spot<A> {
        let north: Radians = self.latitude.into();
        Spot { latitude: Radians(north.0 + by).into(), ..self }
    }
}

#[data]
impl Spot<Degrees> {
    /// The latitude in whole degrees.
    pub fn whole(&self) -> i64 {
        self.latitude.0 as i64
    }
}

/// An instance with the methods of all three blocks.
#[data]
pub type Mark = Spot<Degrees>;

/// A limit that any angle sets.
#[interface]
trait Limit<A>
where
    Radians: From<A>,
{
    /// The limit, rad.
    fn limit(&self, angle: A) -> f64;

    /// Half of it.
    fn half(&self, angle: A) -> f64 {
        0.5 * self.limit(angle)
    }
}

#[data]
impl<A> Limit<A> for f64
where
    Radians: From<A>,
{
    fn limit(&self, angle: A) -> f64 {
        self.min(Radians::from(angle).0)
    }
}

/// The latitude of a place that an angle converts to.
#[function]
fn seen<A: Copy>(angle: Radians) -> A
where
    Spot<A>: From<Radians>,
{
    let spot: Spot<A> = angle.into();
    spot.latitude
}

/// A value that converts to a float, also from that float.
#[function]
fn put<T: Float>(value: impl Into<T>) -> T {
    value.into() + T::one()
}

/// Passes its own type on.
#[function]
fn kept<T: Float>(value: T) -> T {
    put(value)
}

/// Order of any two.
#[function]
fn order<T: Ord + Copy>(one: T, other: T) -> i8 {
    match one.cmp(&other) {
        Ordering::Less => -1,
        Ordering::Equal => 0,
        Ordering::Greater => 1,
    }
}

/// Order of any two that may have none.
#[function]
fn ranked<T: PartialOrd + Copy>(one: T, other: T) -> Option<i8> {
    Some(match one.partial_cmp(&other)? {
        Ordering::Less => -1,
        Ordering::Equal => 0,
        Ordering::Greater => 1,
    })
}

/// All shifts of an integer by its bits, and its order.
#[function]
fn shifted<T: PrimInt>(word: T, by: u32) -> ([T; 4], T, i8) {
    let shifts = [word.unsigned_shl(by), word.unsigned_shr(by), word.signed_shl(by), word.signed_shr(by)];
    let limited = word.max(T::zero()).min(T::max_value() >> 1).clamp(T::one(), T::max_value());
    let order = match word.cmp(&T::one()) {
        Ordering::Less => -1,
        Ordering::Equal => 0,
        Ordering::Greater => 1,
    };
    (shifts, limited, order)
}

#[function]
pub fn of_degrees(latitude: f64, by: f64) -> (f64, f64, i64) {
    let spot = Spot { latitude: Degrees(latitude), longitude: Degrees(1.0) };
    (spot.north(), spot.moved(by).latitude.0, spot.whole())
}

#[function]
pub fn of_radians(latitude: f64, by: f64) -> (f64, f64, f64) {
    let spot = Spot { latitude: Radians(latitude), longitude: Radians(1.0) };
    let seen: Radians = seen(Radians(by));
    (spot.north(), spot.moved(by).latitude.0, seen.0)
}

#[function]
pub fn of_limits(limit: f64, angle: f64) -> (f64, f64) {
    (limit.limit(Degrees(angle)), limit.half(Radians(angle)))
}

#[function]
pub fn of_floats(x: f64, y: f32) -> (f64, f32, f64, Option<i8>, Option<i8>) {
    (kept(x), kept(y), put(y), ranked(x, 1.0), ranked(y, y))
}

#[function]
pub fn of_bytes(x: u8, y: i8, by: u32) -> (([u8; 4], u8, i8), ([i8; 4], i8, i8)) {
    (shifted(x, by), shifted(y, by))
}

#[function]
pub fn of_words(x: u64, y: i32, by: u32) -> (([u64; 4], u64, i8), ([i32; 4], i32, i8)) {
    (shifted(x, by % 64), shifted(y, by % 32))
}

#[function]
pub fn of_orders(x: i16, y: i16, flag: bool) -> (i8, i8, i8, Option<i8>) {
    (order(x, y), order(flag, x > y), order((x, flag), (y, true)), ranked(x, y))
}
