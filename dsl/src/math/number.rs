//! Methods of numbers that take one instruction or a few, where core and std leave a result open or lack the method.

/// Rounding to whole numbers, conversion of angles, and signs of floats.
pub trait RoundMethods: Copy {
    /// The smallest whole number that is not below the number.
    fn dsl_ceil(self) -> Self;
    /// The number without its fractional part.
    fn dsl_trunc(self) -> Self;
    /// The nearest whole number; halves are rounded away from zero.
    fn dsl_round(self) -> Self;
    /// The fractional part, with the number's sign.
    fn dsl_fract(self) -> Self;
    /// Converts an angle from rad to degrees.
    fn dsl_to_degrees(self) -> Self;
    /// Converts an angle from degrees to rad.
    fn dsl_to_radians(self) -> Self;
    /// Returns true if the sign is negative, also for −0; false for a NaN.
    fn dsl_is_sign_negative(self) -> bool;
    /// Returns true if the sign is positive, also for +0; true for a NaN.
    fn dsl_is_sign_positive(self) -> bool;
}

/// Magnitude and sign of floats and signed integers.
pub trait SignMethods: Copy {
    /// The magnitude.
    ///
    /// # Panics
    ///
    /// For the lowest signed integer, as in Rust.
    fn dsl_abs(self) -> Self;
    /// The sign as −1 or 1; 0 for the integer 0, ±1 for a float ±0, NaN for a NaN.
    fn dsl_signum(self) -> Self;
}

/// Euclidean division: the remainder is not negative.
pub trait DivisionMethods: Copy {
    /// The quotient that leaves a remainder of 0 or more.
    ///
    /// # Panics
    ///
    /// For integers under the conditions of `/`.
    fn dsl_div_euclid(self, by: Self) -> Self;
    /// The remainder, which is 0 or more.
    ///
    /// # Panics
    ///
    /// For integers under the conditions of `%`.
    fn dsl_rem_euclid(self, by: Self) -> Self;
}

macro_rules! floats {
    ($($float:ident, $ceil:ident, $trunc:ident, $round:ident;)*) => {$(
        impl RoundMethods for $float {
            fn dsl_ceil(self) -> $float {
                libm::$ceil(self)
            }
            fn dsl_trunc(self) -> $float {
                libm::$trunc(self)
            }
            fn dsl_round(self) -> $float {
                libm::$round(self)
            }
            fn dsl_fract(self) -> $float {
                self - libm::$trunc(self)
            }
            fn dsl_to_degrees(self) -> $float {
                self.to_degrees()
            }
            fn dsl_to_radians(self) -> $float {
                self.to_radians()
            }
            fn dsl_is_sign_negative(self) -> bool {
                // The sign of a NaN differs between machines.
                !self.is_nan() && self.is_sign_negative()
            }
            fn dsl_is_sign_positive(self) -> bool {
                self.is_nan() || self.is_sign_positive()
            }
        }

        impl SignMethods for $float {
            fn dsl_abs(self) -> $float {
                self.abs()
            }
            fn dsl_signum(self) -> $float {
                self.signum()
            }
        }

        impl DivisionMethods for $float {
            fn dsl_div_euclid(self, by: $float) -> $float {
                let quotient = libm::$trunc(self / by);
                if self % by < 0.0 {
                    if by > 0.0 { quotient - 1.0 } else { quotient + 1.0 }
                } else {
                    quotient
                }
            }
            fn dsl_rem_euclid(self, by: $float) -> $float {
                let remainder = self % by;
                if remainder < 0.0 { remainder + by.abs() } else { remainder }
            }
        }
    )*};
}

floats! {
    f64, ceil, trunc, round;
    f32, ceilf, truncf, roundf;
}

macro_rules! integers {
    ($($int:ident)*) => {$(
        impl DivisionMethods for $int {
            fn dsl_div_euclid(self, by: $int) -> $int {
                self.div_euclid(by)
            }
            fn dsl_rem_euclid(self, by: $int) -> $int {
                self.rem_euclid(by)
            }
        }
    )*};
}

integers! { i8 i16 i32 i64 i128 isize u8 u16 u32 u64 u128 usize }

macro_rules! signed {
    ($($int:ident)*) => {$(
        impl SignMethods for $int {
            fn dsl_abs(self) -> $int {
                self.abs()
            }
            fn dsl_signum(self) -> $int {
                self.signum()
            }
        }
    )*};
}

signed! { i8 i16 i32 i64 i128 isize }
