//! Idioms of plain Rust: a trait that combines bounds, builders, a packet with an error type, and a ring with an
//! iterator.

use bessemer::nalgebra::RealField;
use bessemer::prelude::*;
use core::fmt;

/// Number types of the models.
#[interface]
pub trait Num: RealField + Copy {}
#[data]
impl<T: RealField + Copy> Num for T {}

/// A controller.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct Pid<T> { kp: T, ki: T, kd: T, integral: T, last: Option<T>, limit: (T, T) }
#[data]
impl<T: Num> Pid<T> {
    /// A controller with a proportional gain.
    pub fn new(kp: T) -> Self { Self { kp, ki: T::zero(), kd: T::zero(), integral: T::zero(), last: None, limit: (-T::one(), T::one()) } }
    /// The controller with an integral gain.
    #[must_use]
    pub fn with_ki(mut self, ki: T) -> Self { self.ki = ki; self }
    /// The controller with a derivative gain.
    #[must_use]
    pub const fn with_kd(self, kd: T) -> Self { Self { kd, ..self } }
    /// One period; returns the limited output.
    pub fn step(&mut self, error: T, dt: T) -> T {
        self.integral += error * dt;
        let rate = self.last.map_or(T::zero(), |last| (error - last) / dt);
        self.last = Some(error);
        let out = self.kp * error + self.ki * self.integral + self.kd * rate;
        let (low, high) = self.limit;
        if out > high { self.integral -= error * dt; high } else if out < low { low } else { out }
    }
}
/// Controllers in both precisions.
#[function]
pub fn pids(x: f64, y: f32) -> f64 {
    let mut a = Pid::new(2.0).with_ki(0.1).with_kd(0.01);
    let mut b = Pid::new(1.0_f32).with_ki(0.5);
    a.step(x, 0.01) + f64::from(b.step(y, 0.1))
}
/// Reason why there is no packet.
#[data]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error { Short { need: usize, got: usize }, Crc(u8), Kind }
impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self { Self::Short { need, got } => write!(f, "{need} {got}"), Self::Crc(c) => write!(f, "{c}"), Self::Kind => f.write_str("kind") }
    }
}
impl core::error::Error for Error {}
/// Result of parsing a packet.
type Result<T, E = Error> = core::result::Result<T, E>;
/// A packet.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Packet { id: u8, values: [i16; 3], stamp: u32 }
#[data]
impl Packet {
    const LEN: usize = 12;
    /// Parses received bytes.
    pub fn parse(bytes: &[u8]) -> Result<Packet> {
        let bytes: &[u8; Self::LEN] = bytes.get(..Self::LEN).and_then(|b| b.try_into().ok()).ok_or(Error::Short { need: Self::LEN, got: bytes.len() })?;
        let sum = bytes[..11].iter().fold(0_u8, |sum, b| sum.wrapping_add(*b));
        if sum != bytes[11] { return Err(Error::Crc(sum)); }
        let mut values = [0; 3];
        for (value, pair) in values.iter_mut().zip(bytes[1..7].chunks_exact(2)) {
            *value = i16::from_be_bytes([pair[0], pair[1]]);
        }
        let stamp = u32::from_le_bytes(bytes[7..11].try_into().unwrap());
        Ok(Packet { id: bytes[0], values, stamp })
    }
    /// Writes the packet as bytes.
    pub fn write(&self, out: &mut [u8; Self::LEN]) {
        out[0] = self.id;
        for (i, v) in self.values.iter().enumerate() { out[1 + 2 * i..][..2].copy_from_slice(&v.to_be_bytes()); }
        out[7..11].copy_from_slice(&self.stamp.to_le_bytes());
        out[11] = out[..11].iter().copied().fold(0, u8::wrapping_add);
    }
}
/// Parses bytes and writes them again.
#[function]
pub fn round_trip(bytes: &[u8; 12]) -> Result<u32> {
    let p = Packet::parse(bytes)?;
    let mut out = [0; 12];
    p.write(&mut out);
    let q = match Packet::parse(&out) { Ok(q) if q == p => q, Ok(_) => return Err(Error::Kind), Err(e @ Error::Crc(_)) => return Err(e), Err(_) => Packet::default() };
    Ok(q.stamp ^ u32::from(q.id))
}
/// A ring buffer of the last items.
#[data]
#[derive(Clone, Debug)]
pub struct Ring<T, const N: usize> { items: [Option<T>; N], head: usize, len: usize }
impl<T: Copy, const N: usize> Default for Ring<T, N> { fn default() -> Self { Self { items: [None; N], head: 0, len: 0 } } }
#[data]
impl<T: Copy + PartialOrd, const N: usize> Ring<T, N> {
    /// Adds an item; returns the one that it replaces, if any.
    pub fn push(&mut self, item: T) -> Option<T> {
        let at = (self.head + self.len) % N;
        if self.len == N { self.head = (self.head + 1) % N; } else { self.len += 1; }
        self.items[at].replace(item)
    }
    /// Iterates from the oldest item on.
    pub fn iter(&self) -> impl Iterator<Item = T> + '_ { (0..self.len).filter_map(move |i| self.items[(self.head + i) % N]) }
    /// The largest item.
    pub fn largest(&self) -> Option<T> { self.iter().reduce(|a, b| if b > a { b } else { a }) }
}
/// Uses a ring of numbers.
#[function]
pub fn rings(x: &[f32; 6]) -> f32 {
    let mut r = Ring::<f32, 4>::default();
    for v in x { r.push(*v); }
    r.largest().unwrap_or(f32::NAN) + r.iter().sum::<f32>() / r.iter().count().max(1) as f32
}
