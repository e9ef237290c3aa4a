//! Inverse and determinant of matrices with two and three rows, written out by minors.

use bessemer_ir::{Float, Kernel};

use super::inverse_of_four::four;
use crate::kernels::Source;
use crate::kernels::text::{bytes, fill, values, vectors_if};

const ONE: &str = "\
if (a[0] == $zero) {
    return false;
}
a[0] = $one / a[0];
return true;
";

/// Code for a 2×2 matrix in one vector, for targets with a vector that wide.
const TWO: &str = "\
typedef $real matrix_t __attribute__((vector_size(4 * $bytes), aligned($bytes), may_alias));
const matrix_t m = *(const matrix_t *)a;
const matrix_t products = m * __builtin_shufflevector(m, m, 3, 2, 1, 0);
const $real determinant = products[0] - products[1];
if (determinant == $zero) {
    return false;
}
const matrix_t signs = {$one, -$one, -$one, $one};
*(matrix_t *)a = __builtin_shufflevector(m, m, 3, 1, 2, 0) * signs / determinant;
return true;
";

const TWO_NUMBERS: &str = "\
const $real m11 = a[0];
const $real m21 = a[1];
const $real m12 = a[2];
const $real m22 = a[3];
const $real determinant = m11 * m22 - m21 * m12;
if (determinant == $zero) {
    return false;
}
a[0] = m22 / determinant;
a[1] = -m21 / determinant;
a[2] = -m12 / determinant;
a[3] = m11 / determinant;
return true;
";

/// The elements of a 3×3 matrix, three minors and the determinant.
const MINORS: &str = "\
const $real m11 = a[0];
const $real m21 = a[1];
const $real m31 = a[2];
const $real m12 = a[3];
const $real m22 = a[4];
const $real m32 = a[5];
const $real m13 = a[6];
const $real m23 = a[7];
const $real m33 = a[8];
const $real minor_11 = m22 * m33 - m32 * m23;
const $real minor_12 = m21 * m33 - m31 * m23;
const $real minor_13 = m21 * m32 - m31 * m22;
const $real determinant = m11 * minor_11 - m12 * minor_12 + m13 * minor_13;
";

/// Code that computes eight of the nine elements at once, each as the difference of two products. In `f64` it takes
/// 0.7 of the time for a matrix that has been in memory, but 1.2 for one that a product has just stored: loads of
/// eight numbers wait for stores of two.
const EIGHT_OF_THREE: &str = "\
/* All elements but the last at once, each of two products. */
typedef $real eight_t __attribute__((vector_size(8 * $bytes), aligned($bytes), may_alias));
const eight_t m = *(const eight_t *)a;
const eight_t last = {a[8]};
const eight_t minors =
    __builtin_shufflevector(m, last, 4, 1, 1, 6, 0, 3, 3, 6) * __builtin_shufflevector(m, last, 8, 8, 5, 5, 8, 2, 7, 1)
    - __builtin_shufflevector(m, last, 5, 2, 2, 8, 2, 5, 4, 7) * __builtin_shufflevector(m, last, 7, 7, 4, 3, 6, 0, 6, 0);
const $real corner = m[0] * m[4] - m[1] * m[3];
const $real determinant = m[0] * minors[0] - m[3] * minors[1] + m[6] * minors[2];
if (determinant == $zero) {
    return false;
}
const eight_t signs = {$one, -$one, $one, $one, $one, $one, $one, $one};
*(eight_t *)a = minors * signs / determinant;
a[8] = corner / determinant;
return true;
";

const THREE: &str = "\
if (determinant == $zero) {
    return false;
}
a[0] = minor_11 / determinant;
a[1] = -minor_12 / determinant;
a[2] = minor_13 / determinant;
a[3] = (m13 * m32 - m33 * m12) / determinant;
a[4] = (m11 * m33 - m31 * m13) / determinant;
a[5] = (m12 * m31 - m32 * m11) / determinant;
a[6] = (m12 * m23 - m22 * m13) / determinant;
a[7] = (m13 * m21 - m23 * m11) / determinant;
a[8] = (m11 * m22 - m21 * m12) / determinant;
return true;
";

/// Returns the condition that the target has these vectors and that the compiler can shuffle them.
pub(super) fn vectors(needed: &str) -> String {
    vectors_if(&format!("defined({needed})"))
}

pub(super) fn by_cofactors(kernel: &Kernel, size: u32) -> Source {
    let of_two = match kernel.element {
        Float::F64 => "__AVX__",
        Float::F32 => "__SSE2__",
    };
    let template = match size {
        1 => ONE.to_owned(),
        2 => format!("#if {}\n{TWO}#else\n{TWO_NUMBERS}#endif\n", vectors(of_two)),
        3 if kernel.element == Float::F32 => format!(
            "#if {}\n{EIGHT_OF_THREE}#else\n{MINORS}{THREE}#endif\n",
            vectors("__AVX512VL__")
        ),
        3 => format!("{MINORS}{THREE}"),
        _ => four(kernel.element),
    };
    let mut values = values(kernel.element, &[]);
    values.push(("bytes", bytes(kernel.element).to_string()));
    Source { body: fill(&template, &values), ..Source::default() }
}

pub(super) fn determinant(kernel: &Kernel, size: u32) -> Source {
    let template = match size {
        1 => "return a[0];\n".to_owned(),
        2 => "return a[0] * a[3] - a[1] * a[2];\n".to_owned(),
        _ => format!("{MINORS}return determinant;\n"),
    };
    Source { body: fill(&template, &values(kernel.element, &[])), ..Source::default() }
}
