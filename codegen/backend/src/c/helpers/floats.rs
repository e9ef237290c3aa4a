//! Helpers for floats that need more than one operation.

use super::Helper;
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

/// Returns the scalar product of columns with one block of eight lanes. A lane of one term needs no zero of its own,
/// because the sum that it is added to begins with one.
pub(super) fn dot_of(name: &str, float: Float, rows: u8) -> String {
    let (ty, _, l) = names(float);
    let mut sums = String::new();
    for lane in 0..4 {
        let other = lane + 4;
        sums += &format!("    sum += a[{lane}] * b[{lane}] + a[{other}] * b[{other}];\n");
    }
    for row in 8..rows {
        sums += &format!("    sum += a[{row}] * b[{row}];\n");
    }
    format!(
        "/* The scalar product of {rows} elements, in nalgebra's order. */
static inline {ty} {name}(const {ty} *a, const {ty} *b)
{{
    {ty} sum = 0.0{l};
{sums}    return sum;
}}"
    )
}

pub(super) fn dot(name: &str, float: Float) -> String {
    let (ty, _, l) = names(float);
    let zero = format!("0.0{l}");
    let mut lanes = String::new();
    for lane in 1..8 {
        lanes.push_str(&format!("            lane[{lane}] += a[i + {lane}U] * b[i + {lane}U];\n"));
    }
    let zeros = [zero.as_str(); 8].join(", ");
    format!(
        "/* The scalar product of two matrices by columns, in eight lanes and in nalgebra's order. */
static inline {ty} {name}(const {ty} *a, const {ty} *b, uint32_t rows, uint32_t columns)
{{
    {ty} sum = {zero};
    for (uint32_t column = 0U; column < columns; column++) {{
        {ty} lane[8] = {{{zeros}}};
        const uint32_t end = (column + 1U) * rows;
        uint32_t i = column * rows;
        for (; end - i >= 8U; i += 8U) {{
            lane[0] += a[i] * b[i];
{lanes}        }}
        sum += lane[0] + lane[4];
        sum += lane[1] + lane[5];
        sum += lane[2] + lane[6];
        sum += lane[3] + lane[7];
        for (; i < end; i++) {{
            sum += a[i] * b[i];
        }}
    }}
    return sum;
}}"
    )
}

pub(super) fn norm_squared(name: &str, float: Float) -> String {
    let (ty, _, l) = names(float);
    let zero = format!("0.0{l}");
    let dot = Helper::Dot(float).name();
    format!(
        "/* The sum of the squares of a matrix, column by column and in nalgebra's order. */
static inline {ty} {name}(const {ty} *a, uint32_t rows, uint32_t columns)
{{
    {ty} sum = {zero};
    for (uint32_t column = 0U; column < columns; column++) {{
        const {ty} *x = &a[column * rows];
        if (rows == 4U) {{
            sum += (x[0] * x[0] + x[2] * x[2]) + (x[1] * x[1] + x[3] * x[3]);
        }} else {{
            sum += {dot}(x, x, rows, 1U);
        }}
    }}
    return sum;
}}"
    )
}
