//! Helper functions for operations that C's operators do not have with Rust's meaning.
//!
//! Each is `static inline`, has no state, and has no undefined behaviour for any operand. It is defined once, in the
//! header of helpers, if a source calls it. Its name states operation and type. Its text depends on nothing else, so
//! it never changes.

mod conversions;
mod floats;
mod integers;

use std::collections::BTreeSet;
use std::sync::LazyLock;

use bessemer_ir::{Float, Int, Scalar};

use super::spelling::scalar_type;

/// A helper. The order of the variants is the order in the header: callees precede callers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Helper {
    /// Conversion of an unsigned integer to the signed integer with the same bits.
    Wrap(Int),
    /// Conversion of a small signed integer to `uint32_t`. A cast is equivalent, but gcc warns of its sign conversion
    /// wherever it is an operand.
    Extend(Int),
    /// Conversion of the result of an operator to another type. A cast would leave open in which of the two types the
    /// operator computes (MISRA C:2012, rule 10.8); the type of the parameter states it.
    Convert {
        /// Type of the operation.
        from: Scalar,
        /// Type of the result.
        to: Scalar,
    },
    /// Smaller of two numbers.
    Min(Scalar),
    /// Larger of two numbers.
    Max(Scalar),
    /// Nearest number within bounds.
    Clamp(Scalar),
    /// Absolute value of an integer.
    Abs(Int),
    /// Exclusive or of two integers that are then compared.
    Xor(Int),
    /// Left shift of a signed integer.
    ShiftLeft(Int),
    /// Rust's `>>` of a signed integer.
    ShiftRight(Int),
    /// Rust's `as` from float to integer.
    FromFloat(Int, Float),
    /// Bits of a float.
    Bits(Float),
    /// Bits of a float that is not a NaN.
    RawBits(Float),
    /// Float with these bits.
    FromBits(Float),
    /// Magnitude of one number with the sign of another.
    Copysign(Float),
    /// Quotient modulo 2^bits.
    WrappingDiv(Int),
    /// Remainder of the wrapping quotient.
    WrappingRem(Int),
    /// Saturating sum.
    SaturatingAdd(Int),
    /// Saturating difference.
    SaturatingSub(Int),
    /// Saturating product.
    SaturatingMul(Int),
    /// Quotient whose remainder is not negative.
    DivEuclid(Scalar),
    /// Remainder that is not negative.
    RemEuclid(Scalar),
    /// Absolute value of a signed integer, as an unsigned one.
    UnsignedAbs(Int),
    /// Distance of two integers, unsigned.
    AbsDiff(Int),
    /// Number of bits set, of 32 or 64.
    CountOnes(Int),
    /// Number of zero bits above the highest bit set, of 32 or 64.
    LeadingZeros(Int),
    /// Number of zero bits below the lowest bit set, of 32 or 64.
    TrailingZeros(Int),
    /// Integer with its bytes in reverse order.
    SwapBytes(Int),
    /// A `bool` in the caller's memory as a number, for any byte value.
    Flag,
    /// Sign of a float.
    Signum(Float),
    /// First of two numbers if it is at most the second, else the second.
    Lower(Float),
    /// First of two numbers if it is at least the second, else the second.
    Upper(Float),
    /// Smaller of two magnitudes, or the second if one is NaN: one instruction on processors with SSE.
    SmallerMagnitude(Float),
    /// Larger of two magnitudes, or the second if one is NaN.
    LargerMagnitude(Float),
    /// Scalar product of the columns of two matrices.
    Dot(Float),
    /// Scalar product of two columns of 8 to 15 elements.
    DotOf(Float, u8),
    /// Sum of the squares of a matrix's elements.
    NormSquared(Float),
}

impl Helper {
    /// Maps `usize` to `u64` and `isize` to `i64`, as in the C.
    fn plain(int: Int) -> Int {
        match int {
            Int::Usize => Int::U64,
            Int::Isize => Int::I64,
            other => other,
        }
    }

    /// Returns the helper with types that C distinguishes.
    pub fn normal(self) -> Helper {
        let scalar = |scalar| match scalar {
            Scalar::Int(int) => Scalar::Int(Helper::plain(int)),
            other => other,
        };
        match self {
            Helper::Wrap(int) => Helper::Wrap(Helper::plain(int)),
            Helper::Convert { from, to } => Helper::Convert { from: scalar(from), to: scalar(to) },
            Helper::Min(ty) => Helper::Min(scalar(ty)),
            Helper::Max(ty) => Helper::Max(scalar(ty)),
            Helper::Clamp(ty) => Helper::Clamp(scalar(ty)),
            Helper::Abs(int) => Helper::Abs(Helper::plain(int)),
            Helper::Xor(int) => Helper::Xor(Helper::plain(int)),
            Helper::ShiftLeft(int) => Helper::ShiftLeft(Helper::plain(int)),
            Helper::ShiftRight(int) => Helper::ShiftRight(Helper::plain(int)),
            Helper::FromFloat(int, float) => Helper::FromFloat(Helper::plain(int), float),
            Helper::WrappingDiv(int) => Helper::WrappingDiv(Helper::plain(int)),
            Helper::WrappingRem(int) => Helper::WrappingRem(Helper::plain(int)),
            Helper::SaturatingAdd(int) => Helper::SaturatingAdd(Helper::plain(int)),
            Helper::SaturatingSub(int) => Helper::SaturatingSub(Helper::plain(int)),
            Helper::SaturatingMul(int) => Helper::SaturatingMul(Helper::plain(int)),
            Helper::DivEuclid(ty) => Helper::DivEuclid(scalar(ty)),
            Helper::RemEuclid(ty) => Helper::RemEuclid(scalar(ty)),
            Helper::UnsignedAbs(int) => Helper::UnsignedAbs(Helper::plain(int)),
            Helper::AbsDiff(int) => Helper::AbsDiff(Helper::plain(int)),
            Helper::CountOnes(int) => Helper::CountOnes(Helper::plain(int)),
            Helper::LeadingZeros(int) => Helper::LeadingZeros(Helper::plain(int)),
            Helper::TrailingZeros(int) => Helper::TrailingZeros(Helper::plain(int)),
            Helper::SwapBytes(int) => Helper::SwapBytes(Helper::plain(int)),
            other => other,
        }
    }

    /// Returns its name in C.
    pub fn name(self) -> String {
        match self.normal() {
            Helper::Wrap(int) => format!("wrap_{}", int.name()),
            Helper::Extend(int) => format!("u32_from_{}", int.name()),
            Helper::Convert { from, to } => format!("{}_from_{}", to.name(), from.name()),
            Helper::Min(ty) => format!("min_{}", ty.name()),
            Helper::Max(ty) => format!("max_{}", ty.name()),
            Helper::Clamp(ty) => format!("clamp_{}", ty.name()),
            Helper::Abs(int) => format!("abs_{}", int.name()),
            Helper::Xor(int) => format!("xor_{}", int.name()),
            Helper::ShiftLeft(int) => format!("shift_left_{}", int.name()),
            Helper::ShiftRight(int) => format!("shift_right_{}", int.name()),
            Helper::FromFloat(int, float) => format!("{}_from_{}", int.name(), float.name()),
            Helper::Bits(float) => format!("bits_of_{}", float.name()),
            Helper::RawBits(float) => format!("raw_bits_of_{}", float.name()),
            Helper::FromBits(float) => format!("{}_from_bits", float.name()),
            Helper::Copysign(float) => format!("copysign_{}", float.name()),
            Helper::WrappingDiv(int) => format!("wrapping_div_{}", int.name()),
            Helper::WrappingRem(int) => format!("wrapping_rem_{}", int.name()),
            Helper::SaturatingAdd(int) => format!("saturating_add_{}", int.name()),
            Helper::SaturatingSub(int) => format!("saturating_sub_{}", int.name()),
            Helper::SaturatingMul(int) => format!("saturating_mul_{}", int.name()),
            Helper::DivEuclid(ty) => format!("div_euclid_{}", ty.name()),
            Helper::RemEuclid(ty) => format!("rem_euclid_{}", ty.name()),
            Helper::UnsignedAbs(int) => format!("unsigned_abs_{}", int.name()),
            Helper::AbsDiff(int) => format!("abs_diff_{}", int.name()),
            Helper::CountOnes(int) => format!("count_ones_{}", int.name()),
            Helper::LeadingZeros(int) => format!("leading_zeros_{}", int.name()),
            Helper::TrailingZeros(int) => format!("trailing_zeros_{}", int.name()),
            Helper::SwapBytes(int) => format!("swap_bytes_{}", int.name()),
            Helper::Flag => "u8_from_bool".to_owned(),
            Helper::Signum(float) => format!("signum_{}", float.name()),
            Helper::Lower(float) => format!("lower_{}", float.name()),
            Helper::Upper(float) => format!("upper_{}", float.name()),
            Helper::SmallerMagnitude(float) => format!("smaller_magnitude_{}", float.name()),
            Helper::LargerMagnitude(float) => format!("larger_magnitude_{}", float.name()),
            Helper::Dot(float) => format!("dot_{}", float.name()),
            Helper::DotOf(float, rows) => format!("dot_{}_{rows}", float.name()),
            Helper::NormSquared(float) => format!("norm_squared_{}", float.name()),
        }
    }

    /// Returns the helper that it calls.
    fn needs(self) -> Option<Helper> {
        match self {
            Helper::ShiftLeft(int) => Some(Helper::Wrap(int)),
            Helper::ShiftRight(int) => {
                Some(Helper::Wrap(if int.bits() < 32 { Int::I32 } else { int }))
            }
            Helper::NormSquared(float) => Some(Helper::Dot(float)),
            Helper::WrappingDiv(int) => Some(Helper::Wrap(int)),
            Helper::LeadingZeros(int) | Helper::TrailingZeros(int) => Some(Helper::CountOnes(int)),
            _ => None,
        }
    }

    /// Returns true if its text needs `math.h`.
    pub fn needs_math(self) -> bool {
        match self {
            Helper::Min(ty) | Helper::Max(ty) => matches!(ty, Scalar::Float(_)),
            Helper::DivEuclid(ty) | Helper::RemEuclid(ty) => matches!(ty, Scalar::Float(_)),
            Helper::Copysign(_) | Helper::Signum(_) => true,
            Helper::FromFloat(..) | Helper::Bits(_) => true,
            _ => false,
        }
    }

    /// Returns true if its text needs `string.h`.
    pub fn needs_string(self) -> bool {
        matches!(self, Helper::Bits(_) | Helper::RawBits(_) | Helper::FromBits(_) | Helper::Flag)
    }

    /// Returns its definition; `copy` is the name of `memcpy` in it.
    pub fn text(self, copy: &str) -> String {
        let name = self.name();
        match self.normal() {
            Helper::Wrap(int) => conversions::wrap(&name, int),
            Helper::Extend(int) => conversions::extend(&name, int),
            Helper::Convert { from, to } => conversions::convert(&name, from, to),
            Helper::Min(Scalar::Float(float)) => extreme(&name, float, "smaller", "<", "!="),
            Helper::Max(Scalar::Float(float)) => extreme(&name, float, "larger", ">", "=="),
            Helper::Min(ty) => choose(&name, ty, "smaller of two integers", "<"),
            Helper::Max(ty) => choose(&name, ty, "larger of two integers", ">"),
            Helper::Clamp(ty) => clamp(&name, ty),
            Helper::Abs(int) => absolute(&name, int),
            Helper::Xor(int) => integers::exclusive(&name, int),
            Helper::ShiftLeft(int) => shift_left(&name, int),
            Helper::ShiftRight(int) => shift_right(&name, int),
            Helper::FromFloat(int, float) => from_float(&name, int, float),
            Helper::Bits(float) => bits(&name, float, copy),
            Helper::RawBits(float) => raw_bits(&name, float, copy),
            Helper::FromBits(float) => from_bits(&name, float, copy),
            Helper::Copysign(float) => copysign(&name, float),
            Helper::WrappingDiv(int) => integers::wrapping_div(&name, int),
            Helper::WrappingRem(int) => integers::wrapping_rem(&name, int),
            Helper::SaturatingAdd(int) => integers::saturating_add(&name, int),
            Helper::SaturatingSub(int) => integers::saturating_sub(&name, int),
            Helper::SaturatingMul(int) => integers::saturating_mul(&name, int),
            Helper::DivEuclid(Scalar::Float(float)) => floats::div_euclid(&name, float),
            Helper::RemEuclid(Scalar::Float(float)) => floats::rem_euclid(&name, float),
            Helper::DivEuclid(ty) => integers::div_euclid(&name, ty),
            Helper::RemEuclid(ty) => integers::rem_euclid(&name, ty),
            Helper::UnsignedAbs(int) => integers::unsigned_abs(&name, int),
            Helper::AbsDiff(int) => integers::abs_diff(&name, int),
            Helper::CountOnes(int) => integers::count_ones(&name, int),
            Helper::LeadingZeros(int) => integers::leading_zeros(&name, int),
            Helper::TrailingZeros(int) => integers::trailing_zeros(&name, int),
            Helper::SwapBytes(int) => integers::swap_bytes(&name, int),
            Helper::Flag => flag(&name, copy),
            Helper::Signum(float) => floats::signum(&name, float),
            Helper::Lower(float) => ordered(&name, float, "smaller of two numbers", "<="),
            Helper::Upper(float) => ordered(&name, float, "larger of two numbers", ">="),
            // Without zeros of both signs, equal operands are one value.
            Helper::SmallerMagnitude(float) => {
                ordered(&name, float, "smaller of two magnitudes", "<")
            }
            Helper::LargerMagnitude(float) => {
                ordered(&name, float, "larger of two magnitudes", ">")
            }
            Helper::Dot(float) => floats::dot(&name, float),
            Helper::DotOf(float, rows) => floats::dot_of(&name, float, rows),
            Helper::NormSquared(float) => floats::norm_squared(&name, float),
        }
    }
}

/// Numbers of terms of which a scalar product has one block of eight lanes, and perhaps further terms.
pub const ONE_BLOCK: std::ops::Range<u8> = 8..16;

/// Returns true if a helper function has this name. No other function or variable may have it, in any file.
pub fn is_helper_name(name: &str) -> bool {
    static NAMES: LazyLock<BTreeSet<String>> = LazyLock::new(|| all().map(Helper::name).collect());
    NAMES.contains(name)
}

/// Returns every possible helper.
fn all() -> impl Iterator<Item = Helper> {
    let of_int: [fn(Int) -> Helper; 17] = [
        Helper::Wrap,
        Helper::Abs,
        Helper::Xor,
        Helper::ShiftLeft,
        Helper::ShiftRight,
        Helper::WrappingDiv,
        Helper::WrappingRem,
        Helper::SaturatingAdd,
        Helper::SaturatingSub,
        Helper::SaturatingMul,
        Helper::UnsignedAbs,
        Helper::AbsDiff,
        Helper::CountOnes,
        Helper::LeadingZeros,
        Helper::TrailingZeros,
        Helper::SwapBytes,
        |int| Helper::FromFloat(int, Float::F32),
    ];
    let from_double = |int| Helper::FromFloat(int, Float::F64);
    let of_float: [fn(Float) -> Helper; 11] = [
        Helper::Bits,
        Helper::RawBits,
        Helper::FromBits,
        Helper::Copysign,
        Helper::Signum,
        Helper::Lower,
        Helper::Upper,
        Helper::SmallerMagnitude,
        Helper::LargerMagnitude,
        Helper::Dot,
        Helper::NormSquared,
    ];
    let of_either: [fn(Scalar) -> Helper; 5] =
        [Helper::Min, Helper::Max, Helper::Clamp, Helper::DivEuclid, Helper::RemEuclid];
    let floats = [Float::F32, Float::F64];
    let scalars = Int::ALL.map(Scalar::Int).into_iter().chain(floats.map(Scalar::Float));
    let ints = of_int.into_iter().flat_map(|helper| Int::ALL.map(helper));
    ints.chain([Int::I8, Int::I16].map(Helper::Extend))
        .chain(conversions::all())
        .chain([Helper::Flag])
        .chain(Int::ALL.map(from_double))
        .chain(
            floats
                .into_iter()
                .flat_map(|float| ONE_BLOCK.map(move |rows| Helper::DotOf(float, rows))),
        )
        .chain(of_float.into_iter().flat_map(move |helper| floats.map(helper)))
        .chain(scalars.flat_map(move |scalar| of_either.map(|helper| helper(scalar))))
}

/// Returns the helpers together with those that they call.
pub fn closure(helpers: &BTreeSet<Helper>) -> BTreeSet<Helper> {
    helpers.iter().flat_map(|helper| [Some(*helper), helper.needs()]).flatten().collect()
}

fn int_type(int: Int) -> &'static str {
    scalar_type(Scalar::Int(int))
}

fn float_type(float: Float) -> &'static str {
    scalar_type(Scalar::Float(float))
}

/// Returns the unsigned integer of the same width.
pub fn unsigned(int: Int) -> Int {
    match int.bits() {
        8 => Int::U8,
        16 => Int::U16,
        32 => Int::U32,
        _ => Int::U64,
    }
}

/// Returns the C type of the unsigned integer of the same width.
pub fn unsigned_type(int: Int) -> &'static str {
    int_type(unsigned(int))
}

fn extreme(name: &str, float: Float, word: &str, op: &str, sign: &str) -> String {
    let ty = float_type(float);
    format!(
        "/* The {word} of two numbers: -0 < +0, and a NaN gives the other. */
static inline {ty} {name}({ty} a, {ty} b)
{{
    if (a {op} b || isnan(b) != 0) {{
        return a;
    }}
    if (b {op} a || isnan(a) != 0) {{
        return b;
    }}
    return signbit(a) {sign} 0 ? a : b;
}}"
    )
}

fn choose(name: &str, scalar: Scalar, word: &str, op: &str) -> String {
    let ty = scalar_type(scalar);
    format!(
        "/* The {word}. */
static inline {ty} {name}({ty} a, {ty} b)
{{
    return a {op} b ? a : b;
}}"
    )
}

fn ordered(name: &str, float: Float, word: &str, op: &str) -> String {
    let word = format!("{word}; the second if one is NaN");
    choose(name, Scalar::Float(float), &word, op)
}

fn clamp(name: &str, scalar: Scalar) -> String {
    let ty = scalar_type(scalar);
    let nan = if matches!(scalar, Scalar::Float(_)) { "; NaN stays NaN" } else { "" };
    format!(
        "/* The number nearest to value from low to high{nan}. */
static inline {ty} {name}({ty} value, {ty} low, {ty} high)
{{
    if (value < low) {{
        return low;
    }}
    return value > high ? high : value;
}}"
    )
}

fn absolute(name: &str, int: Int) -> String {
    let ty = int_type(int);
    let negated = if int.bits() < 32 { format!("({ty})-value") } else { "-value".to_owned() };
    format!(
        "/* The absolute value; value is not the smallest of its type. */
static inline {ty} {name}({ty} value)
{{
    return value < 0 ? {negated} : value;
}}"
    )
}

fn shift_left(name: &str, int: Int) -> String {
    let (ty, bits) = (int_type(int), int.bits());
    let wrap = Helper::Wrap(int).name();
    let shifted = if bits < 32 {
        format!("(uint{bits}_t)((uint32_t)value << count)")
    } else {
        format!("(uint{bits}_t)value << count")
    };
    format!(
        "/* The bits of value shifted left by count, which is less than {bits}. */
static inline {ty} {name}({ty} value, uint32_t count)
{{
    return {wrap}({shifted});
}}"
    )
}

fn shift_right(name: &str, int: Int) -> String {
    let (ty, bits) = (int_type(int), int.bits());
    let held = if bits < 32 { Int::I32 } else { int };
    let (unsigned, wrap) = (unsigned_type(held), Helper::Wrap(held).name());
    let top = if bits == 64 { "UINT64_C(0x8000000000000000)" } else { "0x80000000U" };
    let back = if bits < 32 { format!("({ty})") } else { String::new() };
    let shifted =
        if bits < 32 { format!("({ty})(value >> count)") } else { "value >> count".into() };
    format!(
        "/* value divided by 2^count and rounded down; count is less than {bits}. */
static inline {ty} {name}({ty} value, uint32_t count)
{{
#if defined(__GNUC__) && !defined(BESSEMER_PLAIN)
    /* These compilers document that they shift the sign in. */
    return {shifted};
#else
    const {unsigned} sign = {top} >> count;
    const {unsigned} bits = ({unsigned})value;
    return {back}{wrap}(((bits >> count) ^ sign) - sign);
#endif
}}"
    )
}

fn from_float(name: &str, int: Int, float: Float) -> String {
    let (ty, value) = (int_type(int), float_type(float));
    let suffix = if float == Float::F32 { "F" } else { "" };
    let (above, limit) = (int.max() + 1, integer_name(int, "MAX"));
    let above = format!("{above}.0{suffix}");
    let (below, floor) = if int.signed() {
        (format!("{}.0{suffix}", int.min()), integer_name(int, "MIN"))
    } else {
        (format!("0.0{suffix}"), "0".to_owned())
    };
    format!(
        "/* The integer nearest to value towards zero, within its type; 0 for a NaN. */
static inline {ty} {name}({value} value)
{{
    if (isnan(value) != 0) {{
        return 0;
    }}
    if (value <= {below}) {{
        return {floor};
    }}
    return value >= {above} ? {limit} : ({ty})value;
}}"
    )
}

fn integer_name(int: Int, which: &str) -> String {
    format!("{}INT{}_{which}", if int.signed() { "" } else { "U" }, int.bits())
}

fn bits(name: &str, float: Float, copy: &str) -> String {
    let (ty, bits, nan) = match float {
        Float::F32 => ("float", 32, "0x7FC00000U"),
        Float::F64 => ("double", 64, "UINT64_C(0x7FF8000000000000)"),
    };
    format!(
        "/* The bits of a number; every NaN has the same. */
static inline uint{bits}_t {name}({ty} value)
{{
    uint{bits}_t bits = {nan};
    if (isnan(value) == 0) {{
        (void){copy}(&bits, &value, sizeof bits);
    }}
    return bits;
}}"
    )
}

fn flag(name: &str, copy: &str) -> String {
    format!(
        "/* 1 for true and 0 for false; read as a byte, which may be any. */
static inline uint8_t {name}(const bool *flag)
{{
    uint8_t byte = 0U;
    (void){copy}(&byte, flag, sizeof byte);
    return (byte != 0U) ? 1U : 0U;
}}"
    )
}

fn raw_bits(name: &str, float: Float, copy: &str) -> String {
    let (ty, bits) = match float {
        Float::F32 => ("float", 32),
        Float::F64 => ("double", 64),
    };
    format!(
        "/* The bits of a number that is not a NaN. */
static inline uint{bits}_t {name}({ty} value)
{{
    uint{bits}_t bits;
    (void){copy}(&bits, &value, sizeof bits);
    return bits;
}}"
    )
}

fn from_bits(name: &str, float: Float, copy: &str) -> String {
    let (ty, bits) = match float {
        Float::F32 => ("float", 32),
        Float::F64 => ("double", 64),
    };
    format!(
        "/* The number with these bits. */
static inline {ty} {name}(uint{bits}_t bits)
{{
    {ty} value;
    (void){copy}(&value, &bits, sizeof value);
    return value;
}}"
    )
}

fn copysign(name: &str, float: Float) -> String {
    let (ty, f) = if float == Float::F32 { ("float", "f") } else { ("double", "") };
    format!(
        "/* The size of one number with the sign of another; a NaN counts as positive. */
static inline {ty} {name}({ty} size, {ty} sign)
{{
    return isnan(sign) != 0 ? fabs{f}(size) : copysign{f}(size, sign);
}}"
    )
}
