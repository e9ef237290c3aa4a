//! Operators and methods of integers of 128 bits that both have, written once.
//!
//! A type's module has the functions that they call: `wrapping_add`, `sum_overflows` and the like.

/// Defines the shifts of a type by numbers of other types.
macro_rules! shifts {
    ($wide:ident: $($int:ident $up:ident $down:ident;)*) => {$(
        /// Moves the bits up.
        ///
        /// # Panics
        /// For fewer than 0 bits or more than 127.
        #[function(expand)]
        pub fn $up(number: $wide, bits: $int) -> $wide {
            crate::__shifts!(bits as u64 <= 127);
            wrapping_shl(number, bits as u32)
        }

        /// Moves the bits down.
        ///
        /// # Panics
        /// For fewer than 0 bits or more than 127.
        #[function(expand)]
        pub fn $down(number: $wide, bits: $int) -> $wide {
            crate::__shifts!(bits as u64 <= 127);
            wrapping_shr(number, bits as u32)
        }
    )*};
}
pub(super) use shifts;

/// Defines the conversions of a type to other numbers.
macro_rules! narrowings {
    ($wide:ident: $($int:ident $to:ident $try_to:ident;)*) => {$(
        /// Keeps the lower bits.
        #[function(expand)]
        pub fn $to(number: $wide) -> $int {
            number.low as $int
        }

        /// Narrows a number if it fits.
        ///
        /// # Errors
        /// A number that does not fit.
        #[function]
        #[allow(clippy::result_unit_err)]
        pub fn $try_to(number: $wide) -> Result<$int, ()> {
            if is_within(number, $int::MIN as i64, $int::MAX as u64) { Ok(number.low as $int) } else { Err(()) }
        }
    )*};
}
pub(super) use narrowings;

/// Defines the methods of a type of two words, `$high` and `u64`, in its module.
macro_rules! methods {
    ($wide:ident: $high:ident) => {
        super::methods::shifts! {
            $wide:
            i8 shl_i8 shr_i8;
            i16 shl_i16 shr_i16;
            i32 shl_i32 shr_i32;
            i64 shl_i64 shr_i64;
            isize shl_isize shr_isize;
            u8 shl_u8 shr_u8;
            u16 shl_u16 shr_u16;
            u32 shl_u32 shr_u32;
            u64 shl_u64 shr_u64;
            usize shl_usize shr_usize;
        }

        super::methods::narrowings! {
            $wide:
            i8 to_i8 try_to_i8;
            i16 to_i16 try_to_i16;
            i32 to_i32 try_to_i32;
            i64 to_i64 try_to_i64;
            isize to_isize try_to_isize;
            u8 to_u8 try_to_u8;
            u16 to_u16 try_to_u16;
            u32 to_u32 try_to_u32;
            u64 to_u64 try_to_u64;
            usize to_usize try_to_usize;
        }

        /// The bits that are 1 in both numbers.
        #[function(expand)]
        pub fn both(one: $wide, other: $wide) -> $wide {
            $wide { high: one.high & other.high, low: one.low & other.low }
        }

        /// The bits that are 1 in at least one of the numbers.
        #[function(expand)]
        pub fn either(one: $wide, other: $wide) -> $wide {
            $wide { high: one.high | other.high, low: one.low | other.low }
        }

        /// The bits in which the two differ.
        #[function(expand)]
        pub fn differing(one: $wide, other: $wide) -> $wide {
            $wide { high: one.high ^ other.high, low: one.low ^ other.low }
        }

        /// The bits that a number does not have.
        #[function(expand)]
        pub fn opposite(number: $wide) -> $wide {
            $wide { high: !number.high, low: !number.low }
        }

        /// `a + b`; `None` if it overflows.
        #[function]
        #[inline]
        pub fn checked_add(a: $wide, b: $wide) -> Option<$wide> {
            if sum_overflows(a, b) { None } else { Some(wrapping_add(a, b)) }
        }

        /// `a - b`; `None` if it overflows.
        #[function]
        #[inline]
        pub fn checked_sub(a: $wide, b: $wide) -> Option<$wide> {
            if difference_overflows(a, b) { None } else { Some(wrapping_sub(a, b)) }
        }

        /// `a * b`; `None` if it overflows.
        #[function]
        #[inline]
        pub fn checked_mul(a: $wide, b: $wide) -> Option<$wide> {
            if product_overflows(a, b) { None } else { Some(wrapping_mul(a, b)) }
        }

        /// `a / b`; `None` for a divisor of 0 or an overflow.
        #[function]
        pub fn checked_div(a: $wide, b: $wide) -> Option<$wide> {
            if is_zero(b) || quotient_overflows(a, b) { None } else { Some(quotient(a, b)) }
        }

        /// `a % b`; `None` for a divisor of 0 or an overflow of the quotient.
        #[function]
        pub fn checked_rem(a: $wide, b: $wide) -> Option<$wide> {
            if is_zero(b) || quotient_overflows(a, b) { None } else { Some(remainder(a, b)) }
        }

        /// `a << bits`; `None` if `bits` is not below the width.
        #[function]
        pub fn checked_shl(a: $wide, bits: u32) -> Option<$wide> {
            if bits < 128 { Some(wrapping_shl(a, bits)) } else { None }
        }

        /// `a >> bits`; `None` if `bits` is not below the width.
        #[function]
        pub fn checked_shr(a: $wide, bits: u32) -> Option<$wide> {
            if bits < 128 { Some(wrapping_shr(a, bits)) } else { None }
        }

        /// `a + b` wrapped to 128 bits, and whether it overflows.
        #[function]
        pub fn overflowing_add(a: $wide, b: $wide) -> ($wide, bool) {
            (wrapping_add(a, b), sum_overflows(a, b))
        }

        /// `a - b` wrapped to 128 bits, and whether it overflows.
        #[function]
        pub fn overflowing_sub(a: $wide, b: $wide) -> ($wide, bool) {
            (wrapping_sub(a, b), difference_overflows(a, b))
        }

        /// `a * b` wrapped to 128 bits, and whether it overflows.
        #[function]
        pub fn overflowing_mul(a: $wide, b: $wide) -> ($wide, bool) {
            (wrapping_mul(a, b), product_overflows(a, b))
        }

        /// `a + b`, or the nearest value of the type.
        #[function]
        pub fn saturating_add(a: $wide, b: $wide) -> $wide {
            if sum_overflows(a, b) { limit(is_negative(b)) } else { wrapping_add(a, b) }
        }

        /// `a - b`, or the nearest value of the type.
        #[function]
        pub fn saturating_sub(a: $wide, b: $wide) -> $wide {
            if difference_overflows(a, b) { limit(!is_negative(b)) } else { wrapping_sub(a, b) }
        }

        /// `a * b`, or the nearest value of the type.
        #[function]
        pub fn saturating_mul(a: $wide, b: $wide) -> $wide {
            if product_overflows(a, b) {
                limit(is_negative(a) != is_negative(b))
            } else {
                wrapping_mul(a, b)
            }
        }

        /// `base` to the power of `exponent`.
        ///
        /// # Panics
        /// For a power that needs more bits.
        #[function]
        pub fn pow(base: $wide, exponent: u32) -> $wide {
            let mut result = $wide { high: 0, low: 1 };
            let mut square = base;
            let mut left = exponent;
            for _ in 0..32 {
                if left & 1 == 1 {
                    result = product(result, square);
                }
                left >>= 1;
                if left == 0 {
                    break;
                }
                square = product(square, square);
            }
            result
        }

        /// `base` to the power of `exponent`, wrapped to 128 bits.
        #[function]
        pub fn wrapping_pow(base: $wide, exponent: u32) -> $wide {
            let mut result = $wide { high: 0, low: 1 };
            let mut square = base;
            let mut left = exponent;
            for _ in 0..32 {
                if left & 1 == 1 {
                    result = wrapping_mul(result, square);
                }
                left >>= 1;
                if left == 0 {
                    break;
                }
                square = wrapping_mul(square, square);
            }
            result
        }

        /// Moves the bits up; those that leave come in below.
        #[function]
        #[inline]
        pub fn rotate_left(number: $wide, bits: u32) -> $wide {
            let below = logical_shr(number, 0_u32.wrapping_sub(bits));
            either(wrapping_shl(number, bits), below)
        }

        /// Moves the bits down; those that leave come in above.
        #[function]
        #[inline]
        pub fn rotate_right(number: $wide, bits: u32) -> $wide {
            rotate_left(number, 0_u32.wrapping_sub(bits))
        }

        /// Number of bits that are 1.
        #[function(expand)]
        pub fn count_ones(number: $wide) -> u32 {
            number.high.count_ones() + number.low.count_ones()
        }

        /// Number of bits that are 0.
        #[function(expand)]
        pub fn count_zeros(number: $wide) -> u32 {
            number.high.count_zeros() + number.low.count_zeros()
        }

        /// Number of zero bits above the highest 1.
        #[function]
        #[inline]
        pub fn leading_zeros(number: $wide) -> u32 {
            if number.high == 0 {
                64 + number.low.leading_zeros()
            } else {
                number.high.leading_zeros()
            }
        }

        /// Number of one bits above the highest 0.
        #[function]
        #[inline]
        pub fn leading_ones(number: $wide) -> u32 {
            leading_zeros(opposite(number))
        }

        /// Number of zero bits below the lowest 1.
        #[function]
        #[inline]
        pub fn trailing_zeros(number: $wide) -> u32 {
            if number.low == 0 {
                64 + number.high.trailing_zeros()
            } else {
                number.low.trailing_zeros()
            }
        }

        /// Number of one bits below the lowest 0.
        #[function]
        #[inline]
        pub fn trailing_ones(number: $wide) -> u32 {
            trailing_zeros(opposite(number))
        }

        /// The number with its bytes in reverse order.
        #[function(expand)]
        pub fn swap_bytes(number: $wide) -> $wide {
            $wide { high: number.low.swap_bytes() as $high, low: number.high.swap_bytes() as u64 }
        }

        /// The nearest number in single precision.
        #[function]
        pub fn to_f32(number: $wide) -> f32 {
            let magnitude = unsigned_abs(number);
            if magnitude.high == 0 {
                let near = magnitude.low as f32;
                return if is_negative(number) { -near } else { near };
            }
            // The bits that are rounded away matter as one, and the factor is a power of two.
            let places = magnitude.high.leading_zeros();
            let scaled = unsigned::wrapping_shl(magnitude, places);
            let leading = (scaled.high | u64::from(scaled.low != 0)) as f32;
            let near = leading * f32::from_bits((191 - places) << 23);
            if is_negative(number) { -near } else { near }
        }

        /// The nearest number in double precision.
        #[function]
        pub fn to_f64(number: $wide) -> f64 {
            let magnitude = unsigned_abs(number);
            if magnitude.high == 0 {
                let near = magnitude.low as f64;
                return if is_negative(number) { -near } else { near };
            }
            // The bits that are rounded away matter as one, and the factor is a power of two.
            let places = magnitude.high.leading_zeros();
            let scaled = unsigned::wrapping_shl(magnitude, places);
            let leading = (scaled.high | u64::from(scaled.low != 0)) as f64;
            let near = leading * f64::from_bits(u64::from(1087 - places) << 52);
            if is_negative(number) { -near } else { near }
        }

        /// The bytes, the least significant first.
        #[function]
        pub fn to_le_bytes(number: $wide) -> [u8; 16] {
            let mut bytes = [0; 16];
            for i in 0..8 {
                bytes[i] = (number.low >> (8 * i)) as u8;
                bytes[8 + i] = (number.high >> (8 * i)) as u8;
            }
            bytes
        }

        /// The bytes, the most significant first.
        #[function]
        pub fn to_be_bytes(number: $wide) -> [u8; 16] {
            to_le_bytes(swap_bytes(number))
        }

        /// The number of these bytes, the least significant first.
        #[function]
        pub fn from_le_bytes(bytes: [u8; 16]) -> $wide {
            let (mut high, mut low) = (0, 0);
            for i in 0..8 {
                low |= u64::from(bytes[i]) << (8 * i);
                high |= u64::from(bytes[8 + i]) << (8 * i);
            }
            $wide { high: high as $high, low }
        }

        /// The number of these bytes, the most significant first.
        #[function]
        pub fn from_be_bytes(bytes: [u8; 16]) -> $wide {
            swap_bytes(from_le_bytes(bytes))
        }
    };
}
pub(super) use methods;
