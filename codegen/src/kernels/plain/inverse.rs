//! Inverse and determinant of the smallest matrices: written out, by minors.

use bessemer_ir::kernel::{COFACTORS, Products};
use bessemer_ir::{Float, Kernel};

use crate::kernels::Source;
use crate::kernels::text::{bytes, fill, values};

const ONE: &str = "\
if (a[0] == $zero) {
    return false;
}
a[0] = $one / a[0];
return true;
";

/// All four elements in one vector, where there is one so wide.
const TWO: &str = "\
#if defined(__GNUC__) && (defined(__clang__) || (__GNUC__ >= 12)) && defined($vectors) && !defined(BESSEMER_PLAIN)
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
#else
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
#endif
";

const FOUR_IN_VECTORS: &str = include_str!("inverse_of_four.c");

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

const REST_OF_FOUR: &str = "\
const $real determinant =
    m0 * cofactor_0 + m1 * cofactor_4 + m2 * cofactor_8 + m3 * cofactor_12;
if (determinant == $zero) {
    return false;
}
const $real reciprocal = $one / determinant;
";

pub(super) fn by_cofactors(kernel: &Kernel, size: u32) -> Source {
    let template = match size {
        1 => ONE.to_owned(),
        2 => TWO.to_owned(),
        3 => format!("{MINORS}{THREE}"),
        _ => four(),
    };
    let mut values = values(kernel.element, &[]);
    let vectors = match kernel.element {
        Float::F64 => "__AVX__",
        Float::F32 => "__SSE2__",
    };
    values.push(("vectors", vectors.to_owned()));
    values.push(("bytes", bytes(kernel.element).to_string()));
    Source { body: fill(&template, &values), ..Source::default() }
}

fn four() -> String {
    let mut text: String =
        (0..16).map(|index| format!("const $real m{index} = a[{index}];\n")).collect();
    let (first, rest) = COFACTORS.split_at(4);
    for (element, products) in first {
        text.push_str(&format!("const $real cofactor_{element} = {};\n", sum(products)));
    }
    text.push_str(REST_OF_FOUR);
    for (element, _) in first {
        text.push_str(&format!("a[{element}] = cofactor_{element} * reciprocal;\n"));
    }
    for (element, products) in rest {
        text.push_str(&format!("a[{element}] = ({}) * reciprocal;\n", sum(products)));
    }
    FOUR_IN_VECTORS.to_owned() + &text + "return true;\n#endif\n"
}

/// Six products, two on each line.
fn sum(products: &Products) -> String {
    let mut text = String::new();
    for (index, (sign, [x, y, z])) in products.iter().enumerate() {
        text.push_str(match (index, sign) {
            (0, 1) => "",
            (0, _) => "-",
            (2 | 4, 1) => "\n    + ",
            (2 | 4, _) => "\n    - ",
            (_, 1) => " + ",
            _ => " - ",
        });
        text.push_str(&format!("m{x} * m{y} * m{z}"));
    }
    text
}

pub(super) fn determinant(kernel: &Kernel, size: u32) -> Source {
    let template = match size {
        1 => "return a[0];\n".to_owned(),
        2 => "return a[0] * a[3] - a[1] * a[2];\n".to_owned(),
        _ => format!("{MINORS}return determinant;\n"),
    };
    Source { body: fill(&template, &values(kernel.element, &[])), ..Source::default() }
}
