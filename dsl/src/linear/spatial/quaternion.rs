//! Quaternions, not necessarily of length 1.

use nalgebra::{Quaternion as Native, Vector3, Vector4};

use crate::math::{Real, real};
use crate::{data, function, library};

/// A quaternion w + i·𝐢 + j·𝐣 + k·𝐤.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Quaternion<T> {
    /// The factor of 𝐢.
    pub i: T,
    /// The factor of 𝐣.
    pub j: T,
    /// The factor of 𝐤.
    pub k: T,
    /// The real part.
    pub w: T,
}

#[library(QuaternionCompanions)]
impl<T: Real> Native<T> {
    /// Builds a quaternion from its real part and its factors of 𝐢, 𝐣 and 𝐤.
    #[by_value(vector)]
    pub fn from_parts(scalar: T, vector: &Vector3<T>) -> Self {
        Native::new(scalar, vector.x, vector.y, vector.z)
    }

    /// Builds the quaternion with these factors of 𝐢, 𝐣 and 𝐤 and the real part 0.
    #[by_value(vector)]
    pub fn from_imag(vector: &Vector3<T>) -> Self {
        Native::new(T::ZERO, vector.x, vector.y, vector.z)
    }

    /// A number as a quaternion.
    pub fn from_real(number: T) -> Self {
        Native::new(number, T::ZERO, T::ZERO, T::ZERO)
    }

    /// The conjugate.
    pub fn conjugate(q: &Self) -> Self {
        Native::new(q.w, -q.i, -q.j, -q.k)
    }

    /// Conjugates a quaternion in place.
    pub fn conjugate_mut(q: &mut Self) {
        q.i = -q.i;
        q.j = -q.j;
        q.k = -q.k;
    }

    /// The real part.
    #[inline]
    pub fn scalar(q: &Self) -> T {
        q.w
    }

    /// The factors of 𝐢, 𝐣 and 𝐤.
    pub fn imag(q: &Self) -> Vector3<T> {
        Vector3::new(q.i, q.j, q.k)
    }

    /// The dot product: the sum of the products of the four parts.
    pub fn dot(a: &Self, b: &Self) -> T {
        (a.i * b.i + a.k * b.k) + (a.j * b.j + a.w * b.w)
    }

    /// The length.
    #[method(norm, magnitude)]
    pub fn norm(q: &Self) -> T {
        norm_squared(q).sqrt()
    }

    /// The square of the length.
    #[method(norm_squared, magnitude_squared)]
    pub fn norm_squared(q: &Self) -> T {
        (q.i * q.i + q.k * q.k) + (q.j * q.j + q.w * q.w)
    }

    /// The quaternion divided by its length.
    pub fn normalize(q: &Self) -> Self {
        unscaled(q, norm(q))
    }

    /// Normalises a quaternion in place and returns its former length.
    pub fn normalize_mut(q: &mut Self) -> T {
        let length = norm(q);
        *q = unscaled(q, length);
        length
    }

    /// The inverse; none if the square of the length is below ε.
    pub fn try_inverse(q: &Self) -> Option<Self> {
        let squared = norm_squared(q);
        if squared >= T::EPSILON { Some(unscaled(&conjugate(q), squared)) } else { None }
    }

    /// Linear interpolation between `a` (`share` 0) and `b` (`share` 1).
    pub fn lerp(a: &Self, b: &Self, share: T) -> Self {
        sum(&scaled(a, T::ONE - share), &scaled(b, share))
    }

    /// The product with itself.
    pub fn squared(q: &Self) -> Self {
        product(q, q)
    }

    /// The quaternion with each part halved.
    pub fn half(q: &Self) -> Self {
        unscaled(q, real(2.0))
    }
}

/// Builds a quaternion from its parts in the order 𝐢, 𝐣, 𝐤, real.
#[function]
pub fn from_vector<T: Real>(parts: Vector4<T>) -> Native<T> {
    Native::new(parts.w, parts.x, parts.y, parts.z)
}

/// Builds a quaternion from an array in the order 𝐢, 𝐣, 𝐤, real.
#[function]
pub fn from_array<T: Real>(parts: [T; 4]) -> Native<T> {
    Native::new(parts[3], parts[0], parts[1], parts[2])
}

/// Hamilton's product.
#[function]
pub fn product<T: Real>(a: &Native<T>, b: &Native<T>) -> Native<T> {
    Native::new(
        a.w * b.w - a.i * b.i - a.j * b.j - a.k * b.k,
        a.w * b.i + a.i * b.w + a.j * b.k - a.k * b.j,
        a.w * b.j - a.i * b.k + a.j * b.w + a.k * b.i,
        a.w * b.k + a.i * b.j - a.j * b.i + a.k * b.w,
    )
}

/// The sum.
#[function]
pub fn sum<T: Real>(a: &Native<T>, b: &Native<T>) -> Native<T> {
    Native::new(a.w + b.w, a.i + b.i, a.j + b.j, a.k + b.k)
}

/// The difference.
#[function]
pub fn difference<T: Real>(a: &Native<T>, b: &Native<T>) -> Native<T> {
    Native::new(a.w - b.w, a.i - b.i, a.j - b.j, a.k - b.k)
}

/// The quaternion with each part multiplied by a number.
#[function]
pub fn scaled<T: Real>(q: &Native<T>, factor: T) -> Native<T> {
    Native::new(q.w * factor, q.i * factor, q.j * factor, q.k * factor)
}

/// Product of a number and a quaternion.
#[function]
pub fn scaled_by<T: Real>(factor: T, q: &Native<T>) -> Native<T> {
    Native::new(factor * q.w, factor * q.i, factor * q.j, factor * q.k)
}

/// The quaternion with each part divided by a number.
#[function]
pub fn unscaled<T: Real>(q: &Native<T>, divisor: T) -> Native<T> {
    Native::new(q.w / divisor, q.i / divisor, q.j / divisor, q.k / divisor)
}

/// The quaternion with each part negated.
#[function]
pub fn negative<T: Real>(q: &Native<T>) -> Native<T> {
    Native::new(-q.w, -q.i, -q.j, -q.k)
}
