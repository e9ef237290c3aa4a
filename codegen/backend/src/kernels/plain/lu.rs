//! Elimination with row pivots: solve, inverse, determinant.

use bessemer_ir::Kernel;

use crate::kernels::text::{fill, indented, values};
use crate::kernels::{Source, declarations};

use super::buffers;

/// Code that finds the pivot of step `k` in `$a`.
const PIVOT: &str = "\
uint32_t pivot = k;
$real largest = $abs($a[k + $n * k]);
for (uint32_t row = k + 1U; row < $n; row++) {
    const $real magnitude = $abs($a[row + $n * k]);
    if (magnitude > largest) {
        largest = magnitude;
        pivot = row;
    }
}
const $real diagonal = $a[pivot + $n * k];
";

/// Code that exchanges the rows `k` and `pivot` of `$matrix`.
const SWAP: &str = "\
for (uint32_t column = 0U; column < $columns; column++) {
    const $real moved = $matrix[k + $n * column];
    $matrix[k + $n * column] = $matrix[pivot + $n * column];
    $matrix[pivot + $n * column] = moved;
}
";

/// Code that subtracts multiples of row `k` from the rows below.
const ELIMINATE: &str = "\
const $real reciprocal = $one / diagonal;
for (uint32_t row = k + 1U; row < $n; row++) {
    $a[row + $n * k] *= reciprocal;
}
for (uint32_t column = k + 1U; column < $n; column++) {
    const $real factor = -$a[k + $n * column];
    for (uint32_t row = k + 1U; row < $n; row++) {
        $a[row + $n * column] += factor * $a[row + $n * k];
    }
}
";

/// Code that subtracts the known values of step `k` from `$b`, downwards.
const FORWARD: &str = "\
for (uint32_t column = 0U; column < $columns; column++) {
    const $real factor = -$b[k + $n * column];
    for (uint32_t row = k + 1U; row < $n; row++) {
        $b[row + $n * column] += factor * $a[row + $n * k];
    }
}
";

/// Code that solves for `$b` by U, from the last row upwards.
const BACKWARD: &str = "\
for (uint32_t column = 0U; column < $columns; column++) {
    for (uint32_t k = $n; k-- > 0U;) {
        const $real value = $b[k + $n * column] / $a[k + $n * k];
        $b[k + $n * column] = value;
        for (uint32_t row = 0U; row < k; row++) {
            $b[row + $n * column] += -value * $a[row + $n * k];
        }
    }
}
return true;
";

const SPOIL_A: &str = "\
for (uint32_t index = 0U; index < $all; index++) {
    a[index] = $nan;
}
";

const SPOIL_B: &str = "\
for (uint32_t index = 0U; index < $known; index++) {
    b[index] = $nan;
}
";

const COPY: &str = "\
for (uint32_t index = 0U; index < $all; index++) {
    factors[index] = a[index];
}
";

const IDENTITY: &str = "\
for (uint32_t column = 0U; column < $n; column++) {
    for (uint32_t row = 0U; row < $n; row++) {
        a[row + $n * column] = (row == column) ? $one : $zero;
    }
}
";

/// Returns `head {`, the indented inner lines, and `}`.
fn block(head: &str, inner: &[&str]) -> String {
    format!("{head} {{\n{}}}\n", indented(&inner.concat()))
}

/// Returns the C of a solve, in place, or with `keeps` in a copy of `a`.
pub(super) fn solve(kernel: &Kernel, size: u32, columns: u32, keeps: bool) -> Source {
    let (factors, before, fail) = match keeps {
        true => ("factors", declarations(&buffers(kernel)) + COPY, SPOIL_B.to_owned()),
        false => ("a", String::new(), SPOIL_A.to_owned() + SPOIL_B),
    };
    let singular = block("if (diagonal == $zero)", &[&fail, "return false;\n"]);
    let of =
        |matrix: &str, columns: &str| SWAP.replace("$matrix", matrix).replace("$columns", columns);
    let exchange = block("if (pivot != k)", &[&of(factors, "$n"), &of("b", "$columns")]);
    let step = [PIVOT, &singular, &exchange, ELIMINATE, FORWARD];
    let body = before + &block("for (uint32_t k = 0U; k < $n; k++)", &step) + BACKWARD;
    let sizes =
        [("n", size), ("columns", columns), ("all", size * size), ("known", size * columns)];
    let mut values = values(kernel.element, &sizes);
    values.extend([("a", factors.to_owned()), ("b", "b".to_owned())]);
    Source { body: fill(&body, &values), math: true, ..Source::default() }
}

pub(super) fn inverse(kernel: &Kernel, size: u32) -> Source {
    let singular = block("if (diagonal == $zero)", &["return false;\n"]);
    let of = |matrix: &str| SWAP.replace("$matrix", matrix).replace("$columns", "$n");
    let exchange = block("if (pivot != k)", &[&of("factors")]);
    let step = [PIVOT, &singular, "pivots[k] = pivot;\n", &exchange, ELIMINATE];
    let again = block("if (pivot != k)", &[&of("a")]);
    let body = [
        declarations(&buffers(kernel)),
        COPY.to_owned(),
        block("for (uint32_t k = 0U; k < $n; k++)", &step),
        IDENTITY.to_owned(),
        block(
            "for (uint32_t k = 0U; k < $n; k++)",
            &["const uint32_t pivot = pivots[k];\n", &again],
        ),
        block("for (uint32_t k = 0U; k < $n; k++)", &[FORWARD]),
        BACKWARD.to_owned(),
    ];
    let sizes = [("n", size), ("columns", size), ("all", size * size)];
    let mut values = values(kernel.element, &sizes);
    values.extend([("a", "factors".to_owned()), ("b", "a".to_owned())]);
    Source { body: fill(&body.concat(), &values), math: true, ..Source::default() }
}

pub(super) fn determinant(kernel: &Kernel, size: u32) -> Source {
    let of = SWAP.replace("$matrix", "factors").replace("$columns", "$n");
    let exchange = block("if (pivot != k)", &["sign = -sign;\n", &of]);
    let step = [PIVOT, &block("if (diagonal != $zero)", &[&exchange, ELIMINATE])];
    let body = [
        declarations(&buffers(kernel)),
        COPY.to_owned(),
        "$real sign = $one;\n".to_owned(),
        block("for (uint32_t k = 0U; k < $n; k++)", &step),
        "$real product = $one;\n".to_owned(),
        block("for (uint32_t k = 0U; k < $n; k++)", &["product *= factors[k + $n * k];\n"]),
        "return product * sign;\n".to_owned(),
    ];
    let sizes = [("n", size), ("all", size * size)];
    let mut values = values(kernel.element, &sizes);
    values.push(("a", "factors".to_owned()));
    Source { body: fill(&body.concat(), &values), math: true, ..Source::default() }
}
