//! Elimination written out, for small sizes: the multipliers of a step stay in registers.
//!
//! Each step subtracts its multipliers times an element from every column on its right. So an element is loaded and
//! stored once per step, the multipliers never, and a right-hand side is solved in registers. Each element has
//! nalgebra's order: steps ascending, then back from the last.
//!
//! No vectors: at these sizes their preparation costs more than they save.

mod carried;

use std::fmt::Write as _;

use bessemer_ir::{Int, Kernel, KernelRoutine, Scalar};

use super::text::{fill, values};
use super::{Buffer, Source, declarations};

/// Largest size for which the search of a pivot and the exchange of rows are written out too.
const PIVOTS_WRITTEN_OUT: u32 = 9;

/// Returns true if a kernel is faster written out.
pub(super) fn fits(kernel: &Kernel) -> bool {
    match (kernel.routine, kernel.dims.as_slice()) {
        (KernelRoutine::LuSolve | KernelRoutine::Solve, &[size, _]) => size > 1,
        // From here on tiles of the right-hand sides take fewer instructions.
        (KernelRoutine::Inverse, &[size]) => size > 4 && (size < 12 || (13..16).contains(&size)),
        _ => false,
    }
}

/// Returns true if a kernel fits into the code size: with its substitutions written out, or with loops for one
/// right-hand side.
pub(super) fn has_room(kernel: &Kernel, code_bytes: u32) -> bool {
    let size = kernel.dims[0];
    if carried::fits(kernel) {
        return carried::has_room(kernel, code_bytes);
    }
    let loops = kernel.routine != KernelRoutine::Inverse && !size.is_multiple_of(4);
    bytes(size) <= code_bytes || loops && bytes(size) - substitution_bytes(size) <= code_bytes
}

/// Returns the code size of elimination and of one right-hand side, four bytes per instruction. The estimate is some
/// per cent too high.
fn bytes(size: u32) -> u32 {
    /// Instructions for a multiplier and its step including both substitutions; the second also finds the pivot and
    /// exchanges rows, written out.
    const INSTRUCTIONS: [u32; 2] = [16, 28];
    let written_out = usize::from(size <= PIVOTS_WRITTEN_OUT);
    // More than any budget: nothing of that size is written out.
    let size = size.min(1000);
    2 * INSTRUCTIONS[written_out] * size * (size - 1) + 400
}

/// Returns the code size of the substitutions, less the size of loops for them.
fn substitution_bytes(size: u32) -> u32 {
    let size = size.min(1000);
    (8 * size * (size - 1)).saturating_sub(200)
}

/// Largest size at which gcc must not vectorise. Its vectors would load numbers that single stores have just written,
/// and wait for them. Measured: 2.6 to 3.7 times as long.
const SCALAR: u32 = 4;
const NO_VECTORS: &str = "\
/* Vectors would wait for the single numbers that have just been stored. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#pragma GCC optimize(\"no-tree-vectorize\", \"no-tree-slp-vectorize\")
#endif
";

/// Size of the matrix, bytes, from which its copy is aligned to a cache line; larger sizes use rows of vectors.
const LINE: u64 = 64;
const IN_ONE_LINE: &str = "\
/* A copy in vectors of 64 bytes: where these crossed a line of the cache, what is read of them would wait for it. */
#if defined(__GNUC__) && defined(__AVX512F__)
#define IN_ONE_LINE __attribute__((aligned(64)))
#else
#define IN_ONE_LINE
#endif
";

const FIND_PIVOT: &str = "\
/* On ARM, functions for themselves take fewer instructions; on x86-64 less time where they stand. */
#if defined(__GNUC__) && defined(__arm__)
#define APART __attribute__((noinline))
#else
#define APART
#endif

/* The row of the first of the largest magnitudes in a column, from row k down. */
APART static uint32_t find_pivot(const $real *column, uint32_t k)
{
    uint32_t pivot = k;
    $real largest = $abs(column[k]);
    for (uint32_t row = k + 1U; row < $n; row++) {
        const $real magnitude = $abs(column[row]);
        if (magnitude > largest) {
            largest = magnitude;
            pivot = row;
        }
    }
    return pivot;
}
";

const EXCHANGE: &str = "
/* Exchanges two rows. */
APART static void exchange_rows($real *row, $real *other)
{
#if defined(__GNUC__) && defined(__arm__)
#pragma GCC unroll 32
#endif
    for (uint32_t at = 0U; at < $all; at += $n) {
        const $real number = row[at];
        row[at] = other[at];
        other[at] = number;
    }
}
";

const LOOPS: &str = "\
/* Solves for one right-hand side: down by L, then up by U. */
static void substitute(const $real *a, $real *x)
{
    for (uint32_t k = 0U; k < $n; k++) {
        const $real value = x[k];
        for (uint32_t row = k + 1U; row < $n; row++) {
            x[row] -= a[row + $n * k] * value;
        }
    }
    for (uint32_t k = $n; k-- > 0U;) {
        const $real value = x[k] / a[k + $n * k];
        x[k] = value;
        for (uint32_t row = 0U; row < k; row++) {
            x[row] -= a[row + $n * k] * value;
        }
    }
}
";

const COPY: &str = "(void)memcpy(factors, a, $all * sizeof(*factors));\n";

/// Code that fills the factors' memory with NaN if there are none.
const SPOIL: &str = "    for (uint32_t index = 0U; index < $all; index++) {
        a[index] = $nan;
    }
";

const SOLVE: &str = "\
if (!factor($factors, pivots)) {
$spoil    for (uint32_t index = 0U; index < $known; index++) {
        b[index] = $nan;
    }
    return false;
}
for (uint32_t column = 0U; column < $columns; column++) {
    $real *const x = &b[$n * column];
    for (uint32_t k = 0U; k < $n; k++) {
        const $real number = x[k];
        x[k] = x[pivots[k]];
        x[pivots[k]] = number;
    }
    substitute($factors, x);
}
return true;
";

const INVERSE: &str = "\
if (!factor(factors, pivots)) {
    return false;
}
/* The right-hand side with its one in row k is the column order[k] of the identity. */
for (uint32_t k = 0U; k < $n; k++) {
    order[k] = k;
}
for (uint32_t k = 0U; k < $n; k++) {
    const uint32_t column = order[k];
    order[k] = order[pivots[k]];
    order[pivots[k]] = column;
}
for (uint32_t index = 0U; index < $all; index++) {
    a[index] = $zero;
}
for (uint32_t k = 0U; k < $n; k++) {
    $real *const x = &a[$n * order[k]];
    x[k] = $one;
    substitute(factors, x);
}
return true;
";

/// Returns the working memory.
pub(super) fn buffers(kernel: &Kernel) -> Vec<Buffer> {
    let size = kernel.dims[0];
    let pivots = Buffer {
        name: "pivots",
        element: Scalar::Int(Int::U32),
        len: size,
        holds: "The row that each step exchanges with its own.",
    };
    let factors = Buffer {
        name: "factors",
        element: Scalar::Float(kernel.element),
        len: size * size,
        holds: "The matrix, then its factors.",
    };
    let order = Buffer {
        name: "order",
        element: Scalar::Int(Int::U32),
        len: size,
        holds: "The column of the inverse that each pivot gives.",
    };
    match kernel.routine {
        KernelRoutine::Inverse => vec![factors, pivots, order],
        KernelRoutine::Solve if carried::fits(kernel) => vec![carried::buffer(factors)],
        KernelRoutine::Solve => vec![factors, pivots],
        _ => vec![pivots],
    }
}

/// Returns the C of a kernel.
pub(super) fn source(kernel: &Kernel, code_bytes: u32) -> Source {
    if carried::fits(kernel) {
        return carried::source(kernel, code_bytes);
    }
    let size = kernel.dims[0];
    let substitute = if bytes(size) <= code_bytes { substitute(size) } else { LOOPS.to_owned() };
    let solve =
        |factors: &str, spoil: &str| SOLVE.replace("$factors", factors).replace("$spoil", spoil);
    let body = match kernel.routine {
        KernelRoutine::Inverse => [COPY, INVERSE].concat(),
        KernelRoutine::Solve => COPY.to_owned() + &solve("factors", ""),
        _ => solve("a", SPOIL),
    };
    let columns = kernel.dims.get(1).copied().unwrap_or(size);
    let sizes =
        [("n", size), ("columns", columns), ("all", size * size), ("known", size * columns)];
    let values = values(kernel.element, &sizes);
    let mut declared = declarations(&buffers(kernel));
    let copied = kernel.routine == KernelRoutine::Solve && size <= SCALAR;
    let in_one_line = copied && buffers(kernel).iter().any(|buffer| buffer.bytes() >= LINE);
    if in_one_line {
        declared.insert_str(0, "IN_ONE_LINE ");
    }
    let shared = match size {
        0..=SCALAR if in_one_line => [NO_VECTORS, IN_ONE_LINE].join("\n"),
        0..=SCALAR => NO_VECTORS.to_owned(),
        _ if size <= PIVOTS_WRITTEN_OUT => String::new(),
        _ => [FIND_PIVOT, EXCHANGE].concat(),
    };
    let before = [shared, factor(size), substitute].join(
        "
",
    );
    Source {
        before: fill(&before, &values).trim().to_owned(),
        body: fill(&(declared + &body), &values),
        math: true,
        string: kernel.routine != KernelRoutine::LuSolve,
        ..Source::default()
    }
}

/// Returns every step of the elimination.
fn factor(n: u32) -> String {
    let mut text = String::from(
        "/* Eliminates below the diagonal, step by step: U stays above, the multipliers below. The pivot is the\n   \
         first of the largest magnitudes. False if it is zero. */\n\
         static bool factor($real *a, uint32_t *pivots)\n{\n",
    );
    for k in 0..n {
        step(&mut text, n, k);
    }
    text + "    return true;\n}\n"
}

/// Writes a step: the pivot, the exchange, the multipliers, and the columns on the right.
fn step(text: &mut String, n: u32, k: u32) {
    let diagonal = n * k + k;
    let column = n * k;
    // Writing to a string cannot fail.
    let mut put = |line: String| {
        let _ = writeln!(text, "{line}");
    };
    put("    {".into());
    let last = k + 1 == n;
    if last {
        put(format!("        pivots[{k}] = {k}U;"));
        put(format!(
            "        if (a[{diagonal}] == $zero) {{\n            return false;\n        }}"
        ));
    } else {
        find_pivot(&mut put, n, k);
        put(format!("        const $real reciprocal = $one / a[{diagonal}];"));
        for row in k + 1..n {
            put(format!("        const $real l{row} = a[{}] * reciprocal;", column + row));
        }
        for row in k + 1..n {
            put(format!("        a[{}] = l{row};", column + row));
        }
        let (first, end) = (n * (k + 1), n * n);
        put(format!("        for (uint32_t at = {first}U; at < {end}U; at += $n) {{"));
        put("            $real *const column = &a[at];".into());
        put(format!("            const $real u = column[{k}];"));
        for row in k + 1..n {
            put(format!("            column[{row}] -= l{row} * u;"));
        }
        put("        }".into());
    }
    put("    }".into());
}

/// Writes the search of a step's pivot, and the exchange of its row.
fn find_pivot(put: &mut impl FnMut(String), n: u32, k: u32) {
    let column = n * k;
    if n > PIVOTS_WRITTEN_OUT {
        put(format!("        const uint32_t pivot = find_pivot(&a[{column}], {k}U);"));
        put(format!("        pivots[{k}] = pivot;"));
        put(format!(
            "        if (a[{column}U + pivot] == $zero) {{\n            return false;\n        }}"
        ));
        put(format!(
            "        if (pivot != {k}U) {{\n            exchange_rows(&a[{k}], &a[pivot]);\n        }}"
        ));
        return;
    }
    compare(put, n, k);
    put(format!("        pivots[{k}] = pivot;"));
    put("        if (largest == $zero) {\n            return false;\n        }".into());
    put(format!("        if (pivot != {k}U) {{\n            $real *const row = &a[pivot];"));
    for column in 0..n {
        let (own, other) = (n * column + k, n * column);
        put(format!("            const $real number{column} = a[{own}];"));
        put(format!(
            "            a[{own}] = row[{other}];\n            row[{other}] = number{column};"
        ));
    }
    put("        }".into());
}

/// Writes the search of a pivot with a comparison for each row.
fn compare(put: &mut impl FnMut(String), n: u32, k: u32) {
    let (diagonal, column) = (n * k + k, n * k);
    put(format!("        uint32_t pivot = {k}U;"));
    put(format!("        $real largest = $abs(a[{diagonal}]);"));
    for row in k + 1..n {
        let place = column + row;
        put(format!("        if ($abs(a[{place}]) > largest) {{"));
        put(format!(
            "            largest = $abs(a[{place}]);\n            pivot = {row}U;\n        }}"
        ));
    }
}

/// Returns both substitutions of one right-hand side, in registers.
fn substitute(n: u32) -> String {
    let mut text = String::from(
        "/* Solves for one right-hand side: down by L, then up by U. */\n\
         static void substitute(const $real *a, $real *x)\n{\n",
    );
    for row in 0..n {
        let _ = writeln!(text, "    $real x{row} = x[{row}];");
        for k in 0..row {
            let _ = writeln!(text, "    x{row} -= a[{}] * x{k};", n * k + row);
        }
    }
    for row in (0..n).rev() {
        for k in (row + 1..n).rev() {
            let _ = writeln!(text, "    x{row} -= a[{}] * x{k};", n * k + row);
        }
        let _ = writeln!(text, "    x{row} /= a[{}];\n    x[{row}] = x{row};", n * row + row);
    }
    text + "}\n"
}
