//! Functions and methods that the DSL does not have, as far as their names show it.
//!
//! The name alone could be the author's own. So a method counts as known to be absent only with as
//! many arguments as the absent one takes, and never on `self`; `Type::method(&value)` always means
//! the author's.

use syn::spanned::Spanned;

use super::names::text;
use super::refuse;
use super::refuse::Reason;

/// Names, how many arguments they take beside the receiver, and what to write instead.
const ABSENT: &[(&str, usize, &str)] = &[
    ("asinh", 0, "write `(x + (x * x + 1.0).sqrt()).ln()`"),
    ("acosh", 0, "write `(x + (x * x - 1.0).sqrt()).ln()`"),
    ("atanh", 0, "write `0.5 * (2.0 * x / (1.0 - x)).ln_1p()`"),
    (
        "is_sorted_by is_sorted_by_key",
        1,
        "write `values.windows(2).all(|pair| pair[0] <= pair[1])`",
    ),
    ("to_be to_le to_ne_bytes", 0, BYTES),
    ("from_be from_le from_ne_bytes", 0, BYTES),
    ("try_inverse_mut", 0, "call `bessemer::inverse_mut`"),
    ("symmetric_eigen symmetric_eigenvalues", 0, "call `bessemer::linear::symmetric_eigen(&a)`"),
    ("svd svd_unordered", 2, "call `bessemer::linear::svd(&a)`"),
    ("singular_values", 0, "call `bessemer::linear::svd(&a)`"),
    ("ln_determinant", 0, "add up the logarithms of the diagonal of `l()`, twice"),
    (
        "angle",
        1,
        "write `a.cross(&b).norm().atan2(a.dot(&b))`, in the plane `a.perp(&b).atan2(a.dot(&b))`",
    ),
    ("full_piv_lu col_piv_qr", 0, "call `lu` or `qr`, or `bessemer::linear::svd(&a)`"),
    ("schur hessenberg eigenvalues", 0, "compute it ahead, or write the iteration out"),
    ("unpack", 0, "call `l()`: what stands above the diagonal is zero"),
    ("rows_mut columns_mut rows columns", 2, "write `fixed_rows::<N>(i)`, `fixed_columns::<N>(j)`"),
    (
        "view view_mut",
        2,
        "write `fixed_view::<R, C>(i, j)`: its size is known when the C is written",
    ),
];

const BYTES: &str = "write `to_be_bytes`, `from_le_bytes` and the like: the same on every target";

/// Those that are absent for a reason of their own, with their arguments.
const REASONS: &[(&str, usize, Reason)] = &[
    // What follows them in a chain needs no word of its own.
    ("iter iter_mut into_iter", 0, refuse::ITERATOR),
    ("windows chunks chunks_exact rchunks", 1, refuse::ITERATOR),
    ("to_vec into_vec", 0, refuse::LIST),
    ("to_string to_owned", 0, refuse::TEXT),
];

/// Constructors of nalgebra that go through the platform's sine and cosine, and of which of its types they are.
const ANGLES: &[(&[&str], &str)] = &[
    (
        &["UnitQuaternion", "Rotation2", "Rotation3"],
        "from_angle from_matrix face_towards look_at_rh look_at_lh rotation_between",
    ),
    (&["Isometry3"], "new rotation face_towards look_at_rh look_at_lh"),
    (
        &["Matrix3", "Matrix4"],
        "from_euler_angles from_axis_angle from_scaled_axis new_rotation new_rotation_wrt_point face_towards look_at_rh look_at_lh",
    ),
];

/// Constructors of nalgebra's matrices, and what to write instead.
const MATRICES: &[(&str, &str)] = &[
    (
        "from_partial_diagonal",
        "write `from_diagonal(&v)` of a whole diagonal, or `zeros()` and the elements",
    ),
    (
        "from_iterator from_row_iterator",
        "write `from_fn(|row, column| …)`, or `from_column_slice(&values)`",
    ),
    ("from_vec", "write `from_column_slice(&values)`"),
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
    let has = |names: &str| names.split(' ').any(|it| it == last);
    if ANGLES.iter().any(|(types, names)| types.contains(&owner.as_str()) && has(names)) {
        return Some(refuse::NALGEBRA_ANGLES);
    }
    let matrix = ["Matrix", "SMatrix", "Vector", "SVector", "RowVector"];
    let kept = MATRICES.iter().find(|(names, _)| names.split(' ').any(|it| it == last));
    if let (true, Some((_, remedy))) = (matrix.iter().any(|it| owner.starts_with(it)), kept) {
        return Some(Reason::new(format!("`{last}` is not in the DSL"), remedy));
    }
    if let Some(reason) = refuse::named_type(&syn::Ident::new(owner, function.span()).into()) {
        return Some(reason);
    }
    if bessemer_ir::Scalar::from_name(owner).is_some() {
        return absent(last, arguments.saturating_sub(1));
    }
    match names[0].as_str() {
        "std" => Some(refuse::STD),
        "core" | "alloc" => Some(refuse::CORE),
        _ => None,
    }
}
