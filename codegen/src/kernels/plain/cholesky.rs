//! Cholesky's factorisation, column by column.

use bessemer_ir::Kernel;

use crate::kernels::Source;
use crate::kernels::text::{fill, values};

const FACTOR: &str = "\
for (uint32_t column = 0U; column < $n; column++) {
    for (uint32_t k = 0U; k < column; k++) {
        const $real factor = -a[column + $n * k];
        for (uint32_t row = column; row < $n; row++) {
            a[row + $n * column] += factor * a[row + $n * k];
        }
    }
    const $real square = a[column + $n * column];
    if (!(square > $zero)) {
        for (uint32_t left = 0U; left < $n; left++) {
            for (uint32_t row = left; row < $n; row++) {
                a[row + $n * left] = $nan;
            }
        }
        return false;
    }
    const $real root = $sqrt(square);
    a[column + $n * column] = root;
    for (uint32_t row = column + 1U; row < $n; row++) {
        a[row + $n * column] /= root;
    }
}
return true;
";

pub(super) fn factor(kernel: &Kernel, size: u32) -> Source {
    let body = fill(FACTOR, &values(kernel.element, &[("n", size)]));
    Source { body, math: true, ..Source::default() }
}
