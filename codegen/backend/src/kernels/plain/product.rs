//! Products of matrices.

use bessemer_ir::{Kernel, KernelRoutine};

use crate::kernels::Source;
use crate::kernels::text::{fill, values};

const PRODUCT: &str = "\
for (uint32_t column = 0U; column < $columns; column++) {
    for (uint32_t row = 0U; row < $rows; row++) {
        $real sum = a[$first_left] * b[$first_right];
        for (uint32_t k = 1U; k < $inner; k++) {
            sum += a[$left] * b[$right];
        }
        result[row + $rows * column] = sum;
    }
}
";

pub(super) fn product(kernel: &Kernel, rows: u32, inner: u32, columns: u32) -> Source {
    let mut values =
        values(kernel.element, &[("rows", rows), ("inner", inner), ("columns", columns)]);
    let left = match kernel.routine {
        KernelRoutine::TrProduct => [format!("{inner}U * row"), format!("k + {inner}U * row")],
        _ => ["row".to_owned(), format!("row + {rows}U * k")],
    };
    let right = match kernel.routine {
        KernelRoutine::ProductTr => ["column".to_owned(), format!("column + {columns}U * k")],
        _ => [format!("{inner}U * column"), format!("k + {inner}U * column")],
    };
    let names = ["first_left", "left", "first_right", "right"];
    values.extend(names.into_iter().zip(left.into_iter().chain(right)));
    Source { body: fill(PRODUCT, &values), ..Source::default() }
}
