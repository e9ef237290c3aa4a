//! Remedies for items of Rust that the DSL does not have.

use super::types::{is_known, is_parameter};

/// Returns the remedy for a method that this kind of type has in Rust.
pub fn instead(method: &str, owner: &str) -> Option<&'static str> {
    let generic = is_parameter(owner);
    Some(match method {
        "len" if owner == "str" => {
            "the C has a number for each name, and no bytes: compute the length ahead, `const LENGTH: usize = NAME.len();`"
        }
        _ if owner == "str" => {
            "the C has a number for each name, and no bytes: compare names by `==` or `match`; write `Text<N>` for a text with bytes"
        }
        "min" | "max" | "clamp" if generic => {
            "compare generic values with `<`: `if b < a { b } else { a }`"
        }
        _ if generic || !is_known(owner) => return None,
        "abs" if owner.starts_with('u') => {
            "an unsigned number has no sign, and `a - b` faults below 0: write `a.abs_diff(b)`"
        }
        "sqrt" if !owner.starts_with('f') => {
            "write `n.isqrt()`, which rounds down, or `f64::from(n).sqrt()`"
        }
        "pseudo_inverse" => "write `bessemer::linear::svd(&a).pseudo_inverse(least)`",
        "zip_zip_map" => "write `zip_map` twice, or `from_fn(|row, column| …)`",
        "eq" | "ne" | "lt" | "le" | "gt" | "ge" => {
            "compare with `==`, `<` and the like; all elements with `a[..] == b[..]`"
        }
        "midpoint" => "write `0.5 * (a + b)`",
        "to_ne_bytes" | "from_ne_bytes" => {
            "write `to_be_bytes`, `from_le_bytes` and the like: the same on every target"
        }
        "is_sorted_by" | "is_sorted_by_key" => {
            "write `values.windows(2).all(|pair| pair[0] <= pair[1])`"
        }
        "rchunks" | "rchunks_exact" => {
            "iterate from the end with `.chunks(n).rev()`, or by indices: `for i in (0..n).rev()`"
        }
        "to_vec" | "into_vec" => {
            "a model has no heap: use `List<T, N>`, a list of at most `N` elements, or an array `[T; N]`"
        }
        "to_string" | "to_owned" => {
            "a model has no heap: use `Text<N>`, a text of at most `N` bytes; use an enum for a choice"
        }
        "try_inverse_mut" => "call `bessemer::inverse_mut`",
        "symmetric_eigen" => "call `bessemer::linear::symmetric_eigen(&a)`",
        "symmetric_eigenvalues" => "write `bessemer::linear::symmetric_eigen(&a).eigenvalues`",
        "svd" | "svd_unordered" | "singular_values" => "call `bessemer::linear::svd(&a)`",
        "ln_determinant" => "add up the logarithms of the diagonal of `l()`, twice",
        "angle" => {
            "write `a.cross(&b).norm().atan2(a.dot(&b))`, in the plane `a.perp(&b).atan2(a.dot(&b))`"
        }
        "full_piv_lu" | "col_piv_qr" => "call `lu` or `qr`, or `bessemer::linear::svd(&a)`",
        "schur" | "hessenberg" | "eigenvalues" => "compute it ahead, or write the iteration out",
        "unpack" => "call `l()`: the elements above the diagonal are zero",
        "rows" | "rows_mut" | "columns" | "columns_mut" => {
            "write `fixed_rows::<N>(i)`, `fixed_columns::<N>(j)`"
        }
        "view" | "view_mut" => {
            "write `fixed_view::<R, C>(i, j)`: its size is known when the C is written"
        }
        "from_partial_diagonal" => {
            "write `from_diagonal(&v)` of a whole diagonal, or `zeros()` and the elements"
        }
        "from_iterator" | "from_row_iterator" => {
            "write `from_fn(|row, column| …)`, or `from_column_slice(&values)`"
        }
        "from_vec" => "write `from_column_slice(&values)`",
        "new" | "rotation" if owner.starts_with("Isometry") => ANGLES,
        "face_towards" | "look_at_rh" | "look_at_lh" => {
            "build it from its axes: `let z = direction.normalize(); let x = up.cross(&z).normalize(); let y = z.cross(&x);`, then `Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[x, y, z]))`"
        }
        "from_angle"
        | "from_matrix"
        | "from_euler_angles"
        | "from_axis_angle"
        | "from_scaled_axis"
        | "new_rotation"
        | "new_rotation_wrt_point" => ANGLES,
        _ => return None,
    })
}

/// Returns the remedy for an item of another crate, which has no attributes: the DSL's equivalent, if there is one.
pub fn of_crate(name: &str) -> &'static str {
    match name {
        "libm" | "micromath" => {
            "call the method of the float, `x.sin()`: its bits are the same in Rust and C; write other functions out in a function marked `#[function]`"
        }
        "num_traits" | "num" | "num_integer" => {
            "call a method of `Zero`, `One`, `Bounded`, `Float`, `FloatCore`, `Signed`, `NumCast`, `AsPrimitive` and the like, of numbers; or declare a trait of your own with `#[interface]`"
        }
        "nalgebra" | "simba" => {
            "docs/book/reference/methods.md lists the methods of nalgebra that the DSL has, for the version of nalgebra that `bessemer` has: `use bessemer::nalgebra;`"
        }
        "crc" | "crc32fast" | "crc16" => {
            "compute the checksum in a function marked `#[function]`: a loop over the bytes that shifts and takes `^` with the polynomial, or a table in a `const`"
        }
        "bitfield" | "bitfield_struct" | "modular_bitfield" | "bitflags" => {
            "declare `#[data] struct Register(u16);` with methods that shift and mask"
        }
        "heapless" | "arrayvec" | "smallvec" | "tinyvec" => {
            "use the DSL's `List<T, N>`, a list of at most `N` elements, or `Text<N>`, a text of at most `N` bytes"
        }
        "fixed" => {
            "store an integer and its scale: `#[data] struct Q15(i16);` with operators of its own"
        }
        "uom" | "dimensioned" => "store the number, and name its unit: `#[unit(\"m/s\")]`",
        "rand" | "rand_core" | "fastrand" => {
            "pass random values to the entry point as an argument, or write the generator in a type marked `#[data]`"
        }
        _ => {
            "nobody can mark another crate's code: write it in a function or a type of your own that is marked, or pass its result to the entry point as an argument"
        }
    }
}

/// Returns true if [`of_crate`] has a remedy for this crate alone.
pub fn is_known_crate(name: &str) -> bool {
    of_crate(name) != of_crate("")
}

const ANGLES: &str = "nalgebra calls the platform's sine and cosine here: call the function of `bessemer::rotation`, `from_euler_angles(roll, pitch, yaw)`, `from_axis_angle(&axis, angle)`, `from_scaled_axis(v)`, `matrix_from_euler_angles(…)` and the like";
