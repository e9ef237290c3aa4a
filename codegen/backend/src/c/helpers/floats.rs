//! Helpers for floats that need more than one operation.

use bessemer_ir::Float;

/// Returns the C type of a float, and the suffixes of `math.h` functions and literals.
fn names(float: Float) -> (&'static str, &'static str, &'static str) {
    match float {
        Float::F32 => ("float", "f", "F"),
        Float::F64 => ("double", "", ""),
    }
}

pub(super) fn signum(name: &str, float: Float) -> String {
    let (ty, f, l) = names(float);
    format!(
        "/* 1 with the sign of value, its zero included; NaN for a NaN. */
static inline {ty} {name}({ty} value)
{{
    return isnan(value) != 0 ? value : copysign{f}(1.0{l}, value);
}}"
    )
}

pub(super) fn rem_euclid(name: &str, float: Float) -> String {
    let (ty, f, l) = names(float);
    format!(
        "/* The remainder of a / b, from 0 to the size of b. */
static inline {ty} {name}({ty} a, {ty} b)
{{
    const {ty} remainder = fmod{f}(a, b);
    return remainder < 0.0{l} ? remainder + fabs{f}(b) : remainder;
}}"
    )
}

pub(super) fn div_euclid(name: &str, float: Float) -> String {
    let (ty, f, l) = names(float);
    format!(
        "/* The whole number of times that b goes into a, leaving a remainder of 0 or more. */
static inline {ty} {name}({ty} a, {ty} b)
{{
    const {ty} quotient = trunc{f}(a / b);
    if (fmod{f}(a, b) < 0.0{l}) {{
        return b > 0.0{l} ? quotient - 1.0{l} : quotient + 1.0{l};
    }}
    return quotient;
}}"
    )
}
