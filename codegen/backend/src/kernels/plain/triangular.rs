//! Solves with triangular matrices.
//!
//! With the matrix itself the solve is by columns: each known value is subtracted from the remaining rows. With its
//! transpose it is by rows: one scalar product subtracts all known values.

use bessemer_ir::{Float, Kernel};

use crate::kernels::Source;
use crate::kernels::text::{fill, indented, values};

const DOWN: &str = "\
for (uint32_t k = 0U; k < $n; k++) {
    const $real value = x[k] / a[k + $n * k];
    x[k] = value;
    for (uint32_t row = k + 1U; row < $n; row++) {
        x[row] += -value * a[row + $n * k];
    }
}
";

const UP: &str = "\
for (uint32_t k = $n; k-- > 0U;) {
    const $real value = x[k] / a[k + $n * k];
    x[k] = value;
    for (uint32_t row = 0U; row < k; row++) {
        x[row] += -value * a[row + $n * k];
    }
}
";

const TR_UP: &str = "\
for (uint32_t k = $n; k-- > 0U;) {
    const $real known = $dot(&a[(k + 1U) + $n * k], &x[k + 1U], $n - 1U - k, 1U);
    x[k] = (x[k] - known) / a[k + $n * k];
}
";

const TR_DOWN: &str = "\
for (uint32_t k = 0U; k < $n; k++) {
    const $real known = $dot(&a[$n * k], x, k, 1U);
    x[k] = (x[k] - known) / a[k + $n * k];
}
";

const SINGULAR: &str = "\
for (uint32_t k = 0U; k < $n; k++) {
    if (a[k + $n * k] == $zero) {
        for (uint32_t index = 0U; index < $all; index++) {
            b[index] = $nan;
        }
        return false;
    }
}
";

/// Returns a loop of these steps over the columns of `b`.
fn of_columns(steps: &[&str]) -> String {
    let inner = format!("$real *const x = &b[$n * column];\n{}", steps.concat());
    format!("for (uint32_t column = 0U; column < $columns; column++) {{\n{}}}\n", indented(&inner))
}

fn source(kernel: &Kernel, size: u32, columns: u32, template: &str, dot: bool) -> Source {
    let sizes = [("n", size), ("columns", columns), ("all", size * columns)];
    let mut values = values(kernel.element, &sizes);
    let name = match kernel.element {
        Float::F64 => "dot_f64",
        Float::F32 => "dot_f32",
    };
    values.push(("dot", name.to_owned()));
    let math = template.contains("$nan");
    Source { body: fill(template, &values), math, dot, ..Source::default() }
}

pub(super) fn cholesky(kernel: &Kernel, size: u32, columns: u32) -> Source {
    source(kernel, size, columns, &of_columns(&[DOWN, TR_UP]), true)
}

/// Returns the solve in which every element of the diagonal divides and is checked.
fn checked(kernel: &Kernel, size: u32, columns: u32, steps: &str, dot: bool) -> Source {
    let template = format!("{SINGULAR}{}return true;\n", of_columns(&[steps]));
    source(kernel, size, columns, &template, dot)
}

pub(super) fn lower(kernel: &Kernel, size: u32, columns: u32) -> Source {
    checked(kernel, size, columns, DOWN, false)
}

pub(super) fn upper(kernel: &Kernel, size: u32, columns: u32) -> Source {
    checked(kernel, size, columns, UP, false)
}

pub(super) fn tr_lower(kernel: &Kernel, size: u32, columns: u32) -> Source {
    checked(kernel, size, columns, TR_UP, true)
}

pub(super) fn tr_upper(kernel: &Kernel, size: u32, columns: u32) -> Source {
    checked(kernel, size, columns, TR_DOWN, true)
}
