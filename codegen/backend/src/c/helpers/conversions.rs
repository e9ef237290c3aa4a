//! Helpers that convert values between types.

use bessemer_ir::{Float, Int, Scalar};

use super::super::spelling::scalar_type;
use super::{Helper, int_type};

/// Returns the conversions from each type in which C computes without a cast: floats, and integers of at least 32
/// bits.
pub(super) fn all() -> impl Iterator<Item = Helper> {
    let floats = [Float::F32, Float::F64].map(Scalar::Float);
    let every = move || Int::ALL.into_iter().map(Scalar::Int).chain(floats);
    let from = every().filter(|from| !matches!(from, Scalar::Int(int) if int.bits() < 32));
    from.flat_map(move |from| every().map(move |to| Helper::Convert { from, to }))
}

pub(super) fn wrap(name: &str, int: Int) -> String {
    let (ty, bits) = (int_type(int), int.bits());
    let (rest, negative) = if bits < 32 {
        (format!("(uint{bits}_t)(UINT{bits}_MAX - bits)"), format!("({ty})(-1 - ({ty})rest)"))
    } else {
        (format!("UINT{bits}_MAX - bits"), format!("-1 - ({ty})rest"))
    };
    format!(
        "/* The signed integer with these bits. */
static inline {ty} {name}(uint{bits}_t bits)
{{
#if defined(__GNUC__) && !defined(BESSEMER_PLAIN)
    /* These compilers document that they keep the bits. */
    return ({ty})bits;
#else
    const uint{bits}_t rest = {rest};
    return bits <= (uint{bits}_t)INT{bits}_MAX ? ({ty})bits : {negative};
#endif
}}"
    )
}

pub(super) fn extend(name: &str, int: Int) -> String {
    let ty = int_type(int);
    format!(
        "/* The value modulo 2^32. */
static inline uint32_t {name}({ty} value)
{{
    return (uint32_t)value;
}}"
    )
}

pub(super) fn convert(name: &str, from: Scalar, to: Scalar) -> String {
    let (ty, given) = (scalar_type(to), scalar_type(from));
    let what = match (from, to) {
        (Scalar::Int(from), Scalar::Int(to)) if from.min() < to.min() || from.max() > to.max() => {
            format!("The value modulo 2^{}", to.bits())
        }
        (Scalar::Int(_), Scalar::Int(_)) => format!("The same number, computed as {given}"),
        _ => format!("The nearest {ty}"),
    };
    format!(
        "/* {what}. */
static inline {ty} {name}({given} value)
{{
    return ({ty})value;
}}"
    )
}
