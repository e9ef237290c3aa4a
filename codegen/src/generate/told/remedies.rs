//! Remedies: something to write in place of what the DSL does not have.

use super::types::{is_known, is_parameter};

/// A remedy for a method that this kind of type has in Rust.
pub fn instead(method: &str, owner: &str) -> Option<&'static str> {
    let generic = is_parameter(owner);
    Some(match method {
        "min" | "max" | "clamp" if generic => {
            "compare what is generic with `<`: `if b < a { b } else { a }`"
        }
        _ if generic || !is_known(owner) => return None,
        "pseudo_inverse" => "write `bessemer::linear::svd(&a).pseudo_inverse(least)`",
        "zip_zip_map" => "write `zip_map` twice, or `from_fn(|row, column| …)`",
        "eq" | "ne" | "lt" | "le" | "gt" | "ge" => {
            "compare with `==`, `<` and the like; all elements with `a[..] == b[..]`"
        }
        "midpoint" => "write `0.5 * (a + b)`",
        "saturating_add_signed" | "wrapping_add_signed" => {
            "convert both to the wider signed type, `i64::from(x)`, and back with `try_from`"
        }
        _ => return None,
    })
}
