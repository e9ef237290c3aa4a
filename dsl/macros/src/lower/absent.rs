//! Functions and methods that the DSL does not have, as far as their names show it.
//!
//! The name alone could be the author's own. So a method counts as known to be absent only with as
//! many arguments as the absent one takes, and never on `self`; `Type::method(&value)` always means
//! the author's.

use syn::spanned::Spanned;

use super::refuse::{self, Reason};
use super::text;

/// Names, how many arguments they take beside the receiver, and what to write instead.
const ABSENT: &[(&str, usize, &str)] = &[
    ("asinh", 0, "write `(x + (x * x + 1.0).sqrt()).ln()`"),
    ("acosh", 0, "write `(x + (x * x - 1.0).sqrt()).ln()`"),
    ("atanh", 0, "write `0.5 * (2.0 * x / (1.0 - x)).ln_1p()`"),
    ("log", 1, "write `x.ln() / base.ln()`"),
    ("sin_cos", 0, "call `sin` and `cos`"),
    ("pow", 1, "multiply: `x * x * x`"),
    ("recip", 0, "write `1.0 / x`"),
    ("mul_add", 2, "write `x * a + b`: rounded twice, it is the same on every target"),
    ("round", 0, "write `(x + 0.5).floor()`"),
    ("ceil", 0, "write `-(-x).floor()`"),
    ("trunc", 0, "write `x.abs().floor().copysign(x)`"),
    ("fract", 0, "write `x - x.floor()`"),
    ("signum is_sign_negative is_sign_positive", 0, "take the sign from `1.0_f64.copysign(x)`"),
    ("to_degrees", 0, "write `x * (180.0 / PI)`"),
    ("to_radians", 0, "write `x * (PI / 180.0)`"),
    ("rem_euclid div_euclid", 1, "write `(x / y).floor()`, and `x - y * (x / y).floor()`"),
    (
        "is_nan is_finite is_infinite",
        0,
        "compare with a limit: `x.abs() <= f64::MAX` is false for NaN and infinities",
    ),
    ("cmp partial_cmp total_cmp eq ne lt le gt ge", 1, "compare with `<`, `==` and the like"),
    ("checked_add checked_sub checked_mul checked_div", 1, WIDER),
    ("saturating_add saturating_sub saturating_mul", 1, WIDER),
    ("overflowing_add overflowing_sub overflowing_mul", 1, WIDER),
    ("into", 0, "write the type: `x as f64`"),
    ("clone", 0, "derive `Copy` too: then the value copies itself"),
    ("min max", 0, "compare the elements in a loop"),
    (
        "lu qr cholesky svd determinant try_inverse",
        0,
        "write the elimination out: it is a loop over the columns",
    ),
];

const WIDER: &str = "compute in a wider type, then `clamp`";

/// Those that are absent for a reason of their own, with their arguments.
const REASONS: &[(&str, usize, Reason)] = &[
    // What follows them in a chain needs no word of its own.
    ("iter iter_mut into_iter", 0, refuse::ITERATOR),
    ("windows chunks step_by", 1, refuse::ITERATOR),
    ("unwrap unwrap_or_default", 0, refuse::OPTION),
    ("expect unwrap_or", 1, refuse::OPTION),
    ("to_vec to_string to_owned", 0, refuse::HEAP),
    ("euler_angles axis_angle scaled_axis", 0, refuse::NALGEBRA_ANGLES),
    ("angle", 1, refuse::NALGEBRA_ANGLES),
    ("slerp", 2, refuse::NALGEBRA_ANGLES),
    ("as_slice as_ref as_mut", 0, refuse::SLICE),
];

/// Constructors and methods of nalgebra that go through the platform's sine and cosine.
const ANGLES: &[&str] = &[
    "from_euler_angles",
    "from_axis_angle",
    "from_scaled_axis",
    "from_angle",
    "rotation",
    "new_rotation",
    "new_rotation_wrt_point",
    "face_towards",
    "look_at_rh",
    "look_at_lh",
];

/// The reason for a method call whose name shows it to be out of reach.
pub fn method(call: &syn::ExprMethodCall) -> Option<Reason> {
    let (name, arguments) = (text(&call.method), call.args.len());
    let reason = REASONS.iter().find(|(names, count, _)| is(names, *count, &name, arguments));
    if let Some((.., reason)) = reason {
        return Some(reason.clone());
    }
    let own = format!("a method of your own is called by its path: `Type::{name}(…)`");
    Some(absent(&name, arguments)?.with_note(own))
}

fn is(names: &str, count: usize, name: &str, arguments: usize) -> bool {
    count == arguments && names.split(' ').any(|it| it == name)
}

fn absent(name: &str, arguments: usize) -> Option<Reason> {
    let mut table = ABSENT.iter();
    let (.., remedy) = table.find(|(names, count, _)| is(names, *count, name, arguments))?;
    Some(Reason::new(format!("`{name}` is not in the DSL yet"), remedy))
}

/// The reason for a function that its path shows to be out of reach.
pub fn function(function: &syn::ExprPath, arguments: usize) -> Option<Reason> {
    let names: Vec<_> = function.path.segments.iter().map(|segment| text(&segment.ident)).collect();
    let [.., owner, last] = names.as_slice() else { return None };
    if ANGLES.contains(&last.as_str()) {
        return Some(refuse::NALGEBRA_ANGLES);
    }
    if let Some(reason) = refuse::named_type(&syn::Ident::new(owner, function.span()).into()) {
        return Some(reason);
    }
    if bessemer_ir::Scalar::from_name(owner).is_some() {
        if last == "from" {
            let what = format!("`{owner}::from` is not in the DSL yet");
            return Some(Reason::new(what, "write the type: `x as f64`"));
        }
        return absent(last, arguments.saturating_sub(1));
    }
    match names[0].as_str() {
        "std" => Some(refuse::STD),
        "core" | "alloc" => Some(refuse::CORE),
        _ => (last == "default").then_some(refuse::ABSENT_DEFAULT),
    }
}
