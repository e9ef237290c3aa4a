//! Helpers for integers. C computes types below 32 bits in `int`, so each result is cast back.

use bessemer_ir::{Int, Scalar};

use super::{Helper, int_type, integer_name, unsigned_type};

/// Returns `value` cast to its type, if C has promoted it to `int`.
fn narrowed(int: Int, value: &str) -> String {
    if int.bits() < 32 { format!("({})({value})", int_type(int)) } else { value.to_owned() }
}

/// Returns the literal of an integer type.
fn literal(int: Int, value: u32) -> String {
    if int.signed() || int.bits() < 32 { value.to_string() } else { format!("{value}U") }
}

pub(super) fn wrapping_div(name: &str, int: Int) -> String {
    let (ty, wrap) = (int_type(int), Helper::Wrap(int).name());
    let unsigned = unsigned_type(int);
    let negated = if int.bits() < 32 {
        format!("({unsigned})(0U - (uint32_t)a)")
    } else {
        format!("0U - ({unsigned})a")
    };
    let quotient = narrowed(int, "a / b");
    format!(
        "/* a / b modulo 2^{bits}; b is not 0. */
static inline {ty} {name}({ty} a, {ty} b)
{{
    return b == -1 ? {wrap}({negated}) : {quotient};
}}",
        bits = int.bits()
    )
}

pub(super) fn wrapping_rem(name: &str, int: Int) -> String {
    let (ty, remainder) = (int_type(int), narrowed(int, "a % b"));
    format!(
        "/* The remainder of a / b, 0 for every a / -1; b is not 0. */
static inline {ty} {name}({ty} a, {ty} b)
{{
    return b == -1 ? 0 : {remainder};
}}"
    )
}

/// Returns the body of a saturating sum, difference or product of up to 32 bits, computed in a wider type.
fn saturated(name: &str, int: Int, what: &str, op: char) -> String {
    let ty = int_type(int);
    let wide = match (int, op) {
        (Int::U32, '*') => "uint64_t",
        (Int::U16, '*') => "uint32_t",
        _ if int.bits() == 32 => "int64_t",
        _ => "int32_t",
    };
    let (low, high) = (integer_name(int, "MIN"), integer_name(int, "MAX"));
    let lower = match (int.signed(), op) {
        (true, _) => format!(
            "    if (exact < {low}) {{
        return {low};
    }}
"
        ),
        (false, '-') => "    if (exact < 0) {
        return 0;
    }
"
        .to_owned(),
        (false, _) => String::new(),
    };
    // No difference of unsigned integers is too large.
    let upper = if !int.signed() && op == '-' {
        format!("({ty})exact")
    } else if int.signed() {
        format!("exact > {high} ? {high} : ({ty})exact")
    } else {
        format!("exact > ({wide}){high} ? {high} : ({ty})exact")
    };
    format!(
        "/* {what}, or the limit of the type beyond which it lies. */
static inline {ty} {name}({ty} a, {ty} b)
{{
    const {wide} exact = ({wide})a {op} ({wide})b;
{lower}    return {upper};
}}"
    )
}

pub(super) fn saturating_add(name: &str, int: Int) -> String {
    match int {
        Int::U64 => format!(
            "/* a + b, or the limit of the type beyond which it lies. */
static inline uint64_t {name}(uint64_t a, uint64_t b)
{{
    return a > UINT64_MAX - b ? UINT64_MAX : a + b;
}}"
        ),
        Int::I64 => format!(
            "/* a + b, or the limit of the type beyond which it lies. */
static inline int64_t {name}(int64_t a, int64_t b)
{{
    if (b > 0) {{
        return a > INT64_MAX - b ? INT64_MAX : a + b;
    }}
    return a < INT64_MIN - b ? INT64_MIN : a + b;
}}"
        ),
        _ => saturated(name, int, "a + b", '+'),
    }
}

pub(super) fn saturating_sub(name: &str, int: Int) -> String {
    match int {
        Int::U32 | Int::U64 => {
            let ty = int_type(int);
            format!(
                "/* a - b, or 0 where b is larger. */
static inline {ty} {name}({ty} a, {ty} b)
{{
    return a > b ? a - b : 0U;
}}"
            )
        }
        Int::I64 => format!(
            "/* a - b, or the limit of the type beyond which it lies. */
static inline int64_t {name}(int64_t a, int64_t b)
{{
    if (b < 0) {{
        return a > INT64_MAX + b ? INT64_MAX : a - b;
    }}
    return a < INT64_MIN + b ? INT64_MIN : a - b;
}}"
        ),
        _ => saturated(name, int, "a - b", '-'),
    }
}

pub(super) fn saturating_mul(name: &str, int: Int) -> String {
    match int {
        Int::U64 => format!(
            "/* a * b, or the limit of the type beyond which it lies. */
static inline uint64_t {name}(uint64_t a, uint64_t b)
{{
    return b != 0U && a > UINT64_MAX / b ? UINT64_MAX : a * b;
}}"
        ),
        Int::I64 => format!(
            "/* a * b, or the limit of the type beyond which it lies. */
static inline int64_t {name}(int64_t a, int64_t b)
{{
    if (a > 0 && b > 0) {{
        return a > INT64_MAX / b ? INT64_MAX : a * b;
    }}
    if (a < 0 && b < 0) {{
        return a < INT64_MAX / b ? INT64_MAX : a * b;
    }}
    if (a > 0 && b < 0) {{
        return b < INT64_MIN / a ? INT64_MIN : a * b;
    }}
    if (a < 0 && b > 0) {{
        return a < INT64_MIN / b ? INT64_MIN : a * b;
    }}
    return 0;
}}"
        ),
        _ => saturated(name, int, "a * b", '*'),
    }
}

fn signed(scalar: Scalar) -> Int {
    match scalar {
        Scalar::Int(int) => int,
        _ => unreachable!("floats have helpers of their own"),
    }
}

pub(super) fn div_euclid(name: &str, scalar: Scalar) -> String {
    let int = signed(scalar);
    let ty = int_type(int);
    let quotient = narrowed(int, "a / b");
    let (down, up) = (narrowed(int, "quotient - 1"), narrowed(int, "quotient + 1"));
    format!(
        "/* a / b rounded so that a remainder of 0 or more is left; b is not 0, and the quotient fits. */
static inline {ty} {name}({ty} a, {ty} b)
{{
    const {ty} quotient = {quotient};
    if (a % b < 0) {{
        return b > 0 ? {down} : {up};
    }}
    return quotient;
}}"
    )
}

pub(super) fn rem_euclid(name: &str, scalar: Scalar) -> String {
    let int = signed(scalar);
    let ty = int_type(int);
    let remainder = narrowed(int, "a % b");
    let (plus, minus) = (narrowed(int, "remainder + b"), narrowed(int, "remainder - b"));
    format!(
        "/* The remainder of a / b that is 0 or more; b is not 0, and the quotient fits. */
static inline {ty} {name}({ty} a, {ty} b)
{{
    const {ty} remainder = {remainder};
    if (remainder < 0) {{
        return b > 0 ? {plus} : {minus};
    }}
    return remainder;
}}"
    )
}

/// Returns `a - b` of two signed values, in the unsigned type, modulo its range.
fn unsigned_difference(int: Int, a: &str, b: &str) -> String {
    let unsigned = unsigned_type(int);
    if int.bits() < 32 && int.signed() {
        // A signed difference must not be cast to an unsigned type (MISRA C:2012, rule 10.8), so both operands are cast first.
        format!("({unsigned})(({unsigned}){a} - ({unsigned}){b})")
    } else if int.bits() < 32 {
        format!("({unsigned})({a} - {b})")
    } else if int.signed() {
        format!("({unsigned}){a} - ({unsigned}){b}")
    } else {
        format!("{a} - {b}")
    }
}

pub(super) fn unsigned_abs(name: &str, int: Int) -> String {
    let (ty, unsigned) = (int_type(int), unsigned_type(int));
    let negated = if int.bits() < 32 {
        format!("({unsigned})-value")
    } else {
        format!("0U - ({unsigned})value")
    };
    format!(
        "/* The absolute value, unsigned. */
static inline {unsigned} {name}({ty} value)
{{
    return value < 0 ? {negated} : ({unsigned})value;
}}"
    )
}

pub(super) fn abs_diff(name: &str, int: Int) -> String {
    let (ty, unsigned) = (int_type(int), unsigned_type(int));
    let (up, down) = (unsigned_difference(int, "b", "a"), unsigned_difference(int, "a", "b"));
    format!(
        "/* How far apart two integers are. */
static inline {unsigned} {name}({ty} a, {ty} b)
{{
    return a < b ? {up} : {down};
}}"
    )
}

pub(super) fn count_ones(name: &str, int: Int) -> String {
    let (ty, bits) = (int_type(int), int.bits());
    let mask = |byte: &str| {
        let digits = byte.repeat(bits as usize / 8);
        if bits == 64 { format!("UINT64_C(0x{digits})") } else { format!("0x{digits}U") }
    };
    let (pairs, nibbles, bytes) = (mask("55"), mask("33"), mask("0F"));
    let (ones, shift) = (mask("01"), bits - 8);
    let sum = format!("(fours * {ones}) >> {shift}U");
    let sum = if bits == 64 { format!("(uint32_t)({sum})") } else { sum };
    format!(
        "/* How many bits are set: counted in pairs, in fours, in bytes, and these added up. */
static inline uint32_t {name}({ty} bits)
{{
    const {ty} ones = bits - ((bits >> 1U) & {pairs});
    const {ty} twos = (ones & {nibbles}) + ((ones >> 2U) & {nibbles});
    const {ty} fours = (twos + (twos >> 4U)) & {bytes};
    return {sum};
}}"
    )
}

pub(super) fn leading_zeros(name: &str, int: Int) -> String {
    let (ty, count) = (int_type(int), Helper::CountOnes(int).name());
    let mut text = String::new();
    let mut shift = 1;
    while shift < int.bits() {
        text.push_str(&format!("    filled |= filled >> {shift}U;\n"));
        shift *= 2;
    }
    format!(
        "/* How many bits stand above the highest that is set; all, if none is. */
static inline uint32_t {name}({ty} bits)
{{
    {ty} filled = bits;
{text}    return {count}(~filled);
}}"
    )
}

pub(super) fn trailing_zeros(name: &str, int: Int) -> String {
    let (ty, count) = (int_type(int), Helper::CountOnes(int).name());
    format!(
        "/* How many bits stand below the lowest that is set; all, if none is. */
static inline uint32_t {name}({ty} bits)
{{
    return {count}(~bits & (bits - {one}));
}}",
        one = literal(int, 1)
    )
}

pub(super) fn swap_bytes(name: &str, int: Int) -> String {
    let ty = int_type(int);
    let body = match int.bits() {
        16 => "    return (uint16_t)((uint16_t)(bits << 8U) | (bits >> 8U));\n".to_owned(),
        32 => {
            "    const uint32_t pairs = ((bits & 0x00FF00FFU) << 8U) | ((bits >> 8U) & 0x00FF00FFU);
    return (pairs << 16U) | (pairs >> 16U);\n"
                .to_owned()
        }
        _ => "    const uint64_t bytes = UINT64_C(0x00FF00FF00FF00FF);
    const uint64_t halves = UINT64_C(0x0000FFFF0000FFFF);
    const uint64_t pairs = ((bits & bytes) << 8U) | ((bits >> 8U) & bytes);
    const uint64_t fours = ((pairs & halves) << 16U) | ((pairs >> 16U) & halves);
    return (fours << 32U) | (fours >> 32U);\n"
            .to_owned(),
    };
    format!(
        "/* The bytes in the opposite order. */
static inline {ty} {name}({ty} bits)
{{
{body}}}"
    )
}

/// Returns the exclusive or as a function, since gcc takes the operator in a comparison for a complement, and warns.
pub fn exclusive(name: &str, int: Int) -> String {
    let ty = int_type(int);
    format!(
        "/* The bits in which two integers differ. */\nstatic inline {ty} {name}({ty} a, {ty} b)\n{{\n    return ({ty})(a ^ b);\n}}"
    )
}
