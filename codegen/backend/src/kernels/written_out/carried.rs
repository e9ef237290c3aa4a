//! A solve for one right-hand side that is eliminated together with the matrix. No part of L is kept, and the rows of a
//! step are exchanged as its columns are processed.

use std::fmt::Write as _;

use bessemer_ir::{Float, Kernel, KernelRoutine};

use super::super::text::{fill, values};
use super::super::{Buffer, Source, declarations};
use super::{COPY, FIND_PIVOT, PIVOTS_WRITTEN_OUT, buffers, compare};

/// Returns true if a kernel is such a solve and faster so; for smaller sizes, recorded exchanges need fewer steps.
pub(super) fn fits(kernel: &Kernel) -> bool {
    kernel.routine == KernelRoutine::Solve && kernel.dims[0] >= 7 && kernel.dims[1] == 1
}

/// Returns true if it fits into the code size, possibly with loops for the back substitution.
pub(super) fn has_room(kernel: &Kernel, code_bytes: u32) -> bool {
    let loops = !kernel.dims[0].is_multiple_of(4);
    bytes(kernel) <= code_bytes || loops && bytes(kernel) - way_back(kernel.dims[0]) <= code_bytes
}

/// Returns the code size, four bytes an instruction. A multiplier and its step take five and a half instructions, and
/// two in the back substitution; an unrolled comparison takes six. `f32` takes a few more moves.
fn bytes(kernel: &Kernel) -> u32 {
    let size = kernel.dims[0];
    let instructions = if size <= PIVOTS_WRITTEN_OUT { 27 } else { 15 };
    // More than any budget: nothing of that size is written out.
    let size = size.min(1000);
    let all = instructions * size * (size - 1) + 125 * size + 100;
    if kernel.element == Float::F32 { all + all / 11 } else { all }
}

/// Returns the code size of the back substitution, less the size of loops for it.
fn way_back(size: u32) -> u32 {
    let size = size.min(1000);
    (4 * size * (size - 1)).saturating_sub(100)
}

const LOOPS: &str = "\
/* Solves upwards by U. */
static void substitute(const $real *a, const $real *b, $real *x)
{
    for (uint32_t row = $n; row-- > 0U;) {
        $real sum = b[row];
        for (uint32_t k = $n - 1U; k > row; k--) {
            sum -= a[row + $n * k] * x[k];
        }
        x[row] = sum / a[row + $n * row];
    }
}
";

/// Returns the buffer for the matrix and the right-hand side.
pub(super) fn buffer(factors: Buffer) -> Buffer {
    let n = factors.len.isqrt();
    Buffer { len: n * (n + 1), holds: "The matrix and the right-hand side.", ..factors }
}

const BODY: &str = "\
(void)memcpy(&factors[$all], b, $n * sizeof(*factors));
if (!eliminate(factors)) {
    for (uint32_t index = 0U; index < $n; index++) {
        b[index] = $nan;
    }
    return false;
}
substitute(factors, &factors[$all], b);
return true;
";

/// Returns the C of the kernel.
pub(super) fn source(kernel: &Kernel, code_bytes: u32) -> Source {
    let n = kernel.dims[0];
    let values = values(kernel.element, &[("n", n), ("all", n * n)]);
    let back = if bytes(kernel) <= code_bytes { substitute(n) } else { LOOPS.to_owned() };
    let shared = if n > PIVOTS_WRITTEN_OUT { FIND_PIVOT } else { "" };
    let before = [shared, &eliminate(n), &back].join("\n");
    Source {
        before: fill(&before, &values).trim().to_owned(),
        body: fill(&(declarations(&buffers(kernel)) + COPY + BODY), &values),
        math: true,
        string: true,
        ..Source::default()
    }
}

/// Returns every step of the elimination.
fn eliminate(n: u32) -> String {
    let mut text = String::from(
        "/* Eliminates below the diagonal, step by step, the right-hand side, the last column, along with it: U stays. The\n   \
         pivot is the first of the largest magnitudes. False if it is zero. */\n\
         static bool eliminate($real *a)\n{\n",
    );
    for k in 0..n - 1 {
        step(&mut text, n, k);
    }
    let _ = writeln!(text, "    return a[{}] != $zero;\n}}", n * n - 1);
    text
}

/// Writes a step: the pivot, the multipliers, and the columns on the right.
fn step(text: &mut String, n: u32, k: u32) {
    let (column, diagonal) = (n * k, n * k + k);
    // Writing to a string cannot fail.
    let mut put = |line: String| {
        let _ = writeln!(text, "{line}");
    };
    put("    {".into());
    match n > PIVOTS_WRITTEN_OUT {
        true => put(format!("        const uint32_t pivot = find_pivot(&a[{column}], {k}U);")),
        false => compare(&mut put, n, k),
    }
    put(format!("        const $real number = a[{column}U + pivot];"));
    put("        if (number == $zero) {\n            return false;\n        }".into());
    put(format!("        a[{column}U + pivot] = a[{diagonal}];"));
    put(format!("        a[{diagonal}] = number;"));
    put("        const $real reciprocal = $one / number;".into());
    for row in k + 1..n {
        put(format!("        const $real l{row} = a[{}] * reciprocal;", column + row));
    }
    let (first, end) = (n * (k + 1), n * (n + 1));
    put(format!("        for (uint32_t at = {first}U; at < {end}U; at += $n) {{"));
    put("            $real *const column = &a[at];".into());
    put("            const $real u = column[pivot];".into());
    put(format!("            column[pivot] = column[{k}];"));
    put(format!("            column[{k}] = u;"));
    for row in k + 1..n {
        put(format!("            column[{row}] -= l{row} * u;"));
    }
    put("        }\n    }".into());
}

/// Returns the back substitution by U, in registers.
fn substitute(n: u32) -> String {
    let mut text = String::from(
        "/* Solves upwards by U. */\nstatic void substitute(const $real *a, const $real *b, $real *x)\n{\n",
    );
    for row in (0..n).rev() {
        let _ = writeln!(text, "    $real x{row} = b[{row}];");
        for k in (row + 1..n).rev() {
            let _ = writeln!(text, "    x{row} -= a[{}] * x{k};", n * k + row);
        }
        let _ = writeln!(text, "    x{row} /= a[{}];\n    x[{row}] = x{row};", n * row + row);
    }
    text + "}\n"
}
