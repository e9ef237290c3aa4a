//! Cholesky factors in tiles of four by four, in place or on a copy. The columns that remain after division by four
//! come first.

use std::fmt::Write as _;

use bessemer_ir::{Float, Kernel};

use super::super::Source;
use super::super::text::{bytes, fill, values};
use super::{is_beside, spoil};

const VECTORS: &str = include_str!("vectors.c");
const BODY: &str = include_str!("factor.c");

const COPY: &str = "(void)memcpy(result, a, $all * sizeof(*result));\n";

/// Code for the first columns, one by one.
const FIRST: &str = "\
for (uint32_t column = 0U; column < $first; column++) {
    $real *const below = &$l[$n * column];
    for (uint32_t k = 0U; k < column; k++) {
        const $real factor = $l[column + $n * k];
        for (uint32_t row = column; row < $n; row++) {
            below[row] -= factor * $l[row + $n * k];
        }
    }
    if (!(below[column] > $zero)) {
        $none
    }
    const $real root = $sqrt(below[column]);
    below[column] = root;
    for (uint32_t row = column + 1U; row < $n; row++) {
        below[row] /= root;
    }
}
";

/// Returns the definitions by which four rows of a column are one vector, two vectors, or four numbers.
fn targets(element: Float) -> String {
    let target = |macro_name: &str, lanes: u32| {
        format!(
            "if defined(__GNUC__) && defined(__x86_64__) && defined({macro_name}) && !defined(BESSEMER_PLAIN)\n#define LANES {lanes}U\n"
        )
    };
    match element {
        Float::F64 => format!("#{}#el{}#endif\n", target("__AVX__", 4), target("__SSE2__", 2)),
        Float::F32 => format!("#{}#endif\n", target("__SSE2__", 4)),
    }
}

/// Returns the C of a factorisation.
pub(super) fn factor(kernel: &Kernel, n: u32) -> Source {
    let before = format!("#if defined(LANES)\n{VECTORS}#else\n{}#endif\n\n{}", numbers(n), top(n));
    source(kernel, n, &before, &body(kernel, n))
}

/// Returns the factorisation with vectors where available, else `other`.
pub(super) fn factor_with_vectors(kernel: &Kernel, n: u32, other: &str) -> Source {
    let before = format!("#if defined(LANES)\n{VECTORS}\n{}#endif\n", top(n));
    source(
        kernel,
        n,
        &before,
        &format!("#if defined(LANES)\n{}#else\n{other}#endif\n", body(kernel, n)),
    )
}

fn source(kernel: &Kernel, n: u32, before: &str, body: &str) -> Source {
    let values = all_values(kernel, n, n % 4);
    let before = format!("{}\n{}\n{before}", targets(kernel.element), spoil(kernel));
    Source {
        before: fill(&before, &values).trim_end().to_owned(),
        body: fill(body, &values),
        math: true,
        string: is_beside(kernel),
        ..Source::default()
    }
}

/// Returns the template's values: the destination of the factor, the returns on failure and at the end, and the first
/// columns.
fn all_values(kernel: &Kernel, n: u32, first: u32) -> Vec<(&'static str, String)> {
    let mut values = values(kernel.element, &[("n", n), ("first", first), ("all", n * n)]);
    let (l, none, done) = match is_beside(kernel) {
        true => ("result", "spoil(result);\n        return;", ""),
        false => ("a", "return spoil(a);", "return true;\n"),
    };
    values
        .extend([("l", l), ("none", none), ("done", done)].map(|(name, it)| (name, it.to_owned())));
    values.push(("bytes", bytes(kernel.element).to_string()));
    values
}

fn body(kernel: &Kernel, n: u32) -> String {
    let copy = if is_beside(kernel) { COPY } else { "" };
    let first = if n.is_multiple_of(4) { "" } else { FIRST };
    [copy, first, BODY].concat()
}

/// Returns the factorisation in loops: every column is processed like the first ones.
pub(super) fn loops(kernel: &Kernel, n: u32) -> Source {
    let values = all_values(kernel, n, n);
    let copy = if is_beside(kernel) { COPY } else { "" };
    Source {
        before: fill(&spoil(kernel), &values).trim_end().to_owned(),
        body: fill(&[copy, FIRST, "$done"].concat(), &values),
        math: true,
        string: is_beside(kernel),
        ..Source::default()
    }
}

/// Returns the code of a tile below the diagonal in scalars.
fn numbers(n: u32) -> String {
    let mut text = String::from(HEAD);
    for column in 0..4 {
        for row in 0..4 {
            let _ = writeln!(text, "    $real y{row}{column} = tile[{}];", row + n * column);
        }
    }
    text += "    for (; known > 0U; known--) {\n";
    for column in 0..4 {
        let _ = writeln!(text, "        const $real l{column} = columns[{column}];");
    }
    for row in 0..4 {
        let _ = writeln!(text, "        const $real r{row} = rows[{row}];");
        for column in 0..4 {
            let _ = writeln!(text, "        y{row}{column} -= r{row} * l{column};");
        }
    }
    text += "        rows = &rows[$n];\n        columns = &columns[$n];\n    }\n    if (top != tile) {\n";
    for column in 0..4 {
        for k in 0..column {
            let _ = writeln!(text, "        const $real l{column}{k} = top[{}];", column + n * k);
            for row in 0..4 {
                let _ = writeln!(text, "        y{row}{column} -= y{row}{k} * l{column}{k};");
            }
        }
        let _ = writeln!(text, "        const $real root{column} = top[{}];", column + n * column);
        for row in 0..4 {
            let _ = writeln!(text, "        y{row}{column} /= root{column};");
        }
    }
    text += "    }\n";
    for column in 0..4 {
        for row in 0..4 {
            let _ = writeln!(text, "    tile[{}] = y{row}{column};", row + n * column);
        }
    }
    text + "}\n"
}

const HEAD: &str = "\
/* Takes the known columns on the left from a tile. Then, unless it is the one of the diagonal, solves
   by that. */
static void take($real *tile, const $real *rows, const $real *columns, uint32_t known, const $real *top)
{
";

/// Returns the code of a tile on the diagonal, of which the lower triangle is used.
fn top(n: u32) -> String {
    let mut text = String::from(
        "/* Factors a tile of the diagonal. */\nstatic inline bool factor_top($real *top)\n{\n",
    );
    for column in 0..4 {
        for row in column..4 {
            let _ = writeln!(text, "    $real l{row}{column} = top[{}];", row + n * column);
            for k in 0..column {
                let _ = writeln!(text, "    l{row}{column} -= l{column}{k} * l{row}{k};");
            }
        }
        let _ = writeln!(
            text,
            "    if (!(l{column}{column} > $zero)) {{\n        return false;\n    }}"
        );
        let _ = writeln!(text, "    l{column}{column} = $sqrt(l{column}{column});");
        for row in column + 1..4 {
            let _ = writeln!(text, "    l{row}{column} /= l{column}{column};");
        }
    }
    for column in 0..4 {
        for row in column..4 {
            let _ = writeln!(text, "    top[{}] = l{row}{column};", row + n * column);
        }
    }
    text + "    return true;\n}\n"
}
