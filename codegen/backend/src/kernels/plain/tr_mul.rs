//! Products with a transpose.

use bessemer_ir::{Float, Kernel};

use crate::kernels::Source;
use crate::kernels::text::{fill, values};

const TR_MUL: &str = "\
for (uint32_t column = 0U; column < $columns; column++) {
    for (uint32_t row = 0U; row < $left; row++) {
        const $real *const x = &a[$rows * row];
        const $real *const y = &b[$rows * column];
        result[row + $left * column] = $dot;
    }
}
";

pub(super) fn tr_mul(kernel: &Kernel, rows: u32, left: u32, columns: u32) -> Source {
    let sizes = [("rows", rows), ("left", left), ("columns", columns)];
    let mut values = values(kernel.element, &sizes);
    // nalgebra has an order of its own for two, three and four terms.
    let dot = match (rows, kernel.element) {
        (2, _) => "x[0] * y[0] + x[1] * y[1]".to_owned(),
        (3, _) => "x[0] * y[0] + x[1] * y[1] + x[2] * y[2]".to_owned(),
        (4, _) => "(x[0] * y[0] + x[2] * y[2]) + (x[1] * y[1] + x[3] * y[3])".to_owned(),
        (_, Float::F64) => format!("dot_f64(x, y, {rows}U, 1U)"),
        (_, Float::F32) => format!("dot_f32(x, y, {rows}U, 1U)"),
    };
    values.push(("dot", dot));
    let body = fill(TR_MUL, &values);
    Source { body, dot: !(2..=4).contains(&rows), ..Source::default() }
}
