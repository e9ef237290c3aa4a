//! Products of matrices in tiles: up to four rows by four columns of the result stay in registers.
//!
//! Each element of the result starts as its first product and takes the others in the order of k, as
//! nalgebra's does; a tile only decides which elements go side by side.
//!
//! The four rows of a whole tile are a vector where gcc or clang have one.

use std::fmt::Write as _;

use bessemer_ir::{Float, Kernel};

use super::Source;

/// The C of a product; the columns of `b` are the result's.
pub(super) fn source(kernel: &Kernel, rows: u32, inner: u32, columns: u32) -> Source {
    let real = match kernel.element {
        Float::F64 => "double",
        Float::F32 => "float",
    };
    let mut shapes = Vec::new();
    let mut body = String::new();
    // Whole tiles in loops, then what is left below and on the right.
    for (column, width, columns_many) in parts(columns) {
        let inset = if columns_many { "    " } else { "" };
        if columns_many {
            let _ =
                writeln!(body, "for (uint32_t column = 0U; column < {column}U; column += 4U) {{");
        }
        for (row, height, rows_many) in parts(rows) {
            if !shapes.contains(&(height, width)) {
                shapes.push((height, width));
            }
            let a = place([(1, row, rows_many.then_some("row"))].as_slice());
            let b = place([(inner, column, columns_many.then_some("column"))].as_slice());
            let to = place(&[
                (1, row, rows_many.then_some("row")),
                (rows, column, columns_many.then_some("column")),
            ]);
            let call = format!("tile_{height}x{width}(&a[{a}], &b[{b}], &result[{to}]);");
            if rows_many {
                let _ = writeln!(
                    body,
                    "{inset}for (uint32_t row = 0U; row < {row}U; row += 4U) {{\n{inset}    {call}\n{inset}}}"
                );
            } else {
                let _ = writeln!(body, "{inset}{call}");
            }
        }
        body += if columns_many { "}\n" } else { "" };
    }
    let tiles: Vec<String> =
        shapes.into_iter().map(|shape| tile(real, shape, [rows, inner])).collect();
    let vectors = if rows >= 4 { vectors(real, kernel.element) } else { String::new() };
    let before = vectors + &tiles.join("\n");
    Source { before: before.trim_end().to_owned(), body, ..Source::default() }
}

/// An index: the known parts as one number, then each loop's counter times its stride.
fn place(parts: &[(u32, u32, Option<&str>)]) -> String {
    let known = |&(stride, start, counter): &(u32, u32, Option<&str>)| match counter {
        Some(_) => 0,
        None => stride * start,
    };
    let known: u32 = parts.iter().map(known).sum();
    let mut terms: Vec<String> = Vec::new();
    for (stride, _, counter) in parts {
        match (stride, counter) {
            (1, Some(counter)) => terms.push((*counter).to_owned()),
            (_, Some(counter)) => terms.push(format!("{stride}U * {counter}")),
            (_, None) => {}
        }
    }
    if known > 0 || terms.is_empty() {
        terms.push(format!("{known}U"));
    }
    terms.join(" + ")
}

/// The whole fours, if there are any: where they end, four, and whether they are many; then the rest.
fn parts(count: u32) -> Vec<(u32, u32, bool)> {
    let whole = count - count % 4;
    let mut parts = Vec::new();
    if whole > 4 {
        parts.push((whole, 4, true));
    } else if whole == 4 {
        parts.push((0, 4, false));
    }
    if count > whole {
        parts.push((whole, count - whole, false));
    }
    parts
}

/// A tile of the result: so many rows by so many columns.
fn tile(real: &str, (height, width): (u32, u32), [rows, inner]: [u32; 2]) -> String {
    let shape = Shape { height, width, rows, inner };
    let head = format!(
        "/* A tile of {height} by {width} elements: the first products, then the others in order. */\n\
         static void tile_{height}x{width}(const {real} *a, const {real} *b, {real} *result)\n{{\n"
    );
    match height {
        4 => format!(
            "{head}#if defined(VECTORS)\n{}#else\n{}#endif\n}}\n",
            shape.by_vectors(),
            shape.by_numbers(real)
        ),
        _ => format!("{head}{}}}\n", shape.by_numbers(real)),
    }
}

/// Four numbers as a vector.
fn vectors(real: &str, element: Float) -> String {
    let (bytes, aligned) = match element {
        Float::F64 => (32, 8),
        Float::F32 => (16, 4),
    };
    format!(
        "#if defined(__GNUC__) && defined(__SSE2__) && !defined(BESSEMER_PLAIN)\n#define VECTORS\n\
         typedef {real} four_t __attribute__((vector_size({bytes}), aligned({aligned}), may_alias));\n#endif\n\n"
    )
}

/// A tile: its size, the rows of `a`, and the columns of `a`.
struct Shape {
    height: u32,
    width: u32,
    rows: u32,
    inner: u32,
}

impl Shape {
    fn by_vectors(&self) -> String {
        let Shape { width, rows, inner, .. } = self;
        let mut text = String::from("    four_t column = *(const four_t *)a;\n");
        // Writing to a string cannot fail.
        for j in 0..*width {
            let _ = writeln!(text, "    four_t y{j} = column * b[{}];", inner * j);
        }
        if *inner > 1 {
            let _ = writeln!(
                text,
                "    for (uint32_t k = 1U; k < {inner}U; k++) {{\n        a += {rows};\n        column = *(const four_t *)a;"
            );
            for j in 0..*width {
                let _ = writeln!(text, "        y{j} += column * b[k + {}U];", inner * j);
            }
            text.push_str("    }\n");
        }
        for j in 0..*width {
            let _ = writeln!(text, "    *(four_t *)&result[{}] = y{j};", rows * j);
        }
        text
    }

    fn by_numbers(&self, real: &str) -> String {
        let Shape { height, width, rows, inner } = self;
        let mut text = String::new();
        // Writing to a string cannot fail.
        for column in 0..*width {
            for row in 0..*height {
                let first = inner * column;
                let _ = writeln!(text, "    {real} y{row}{column} = a[{row}] * b[{first}];");
            }
        }
        if *inner > 1 {
            let _ = writeln!(
                text,
                "    for (uint32_t k = 1U; k < {inner}U; k++) {{\n        a += {rows};"
            );
            for row in 0..*height {
                let _ = writeln!(text, "        const {real} a{row} = a[{row}];");
            }
            for column in 0..*width {
                let first = inner * column;
                let _ = writeln!(text, "        const {real} b{column} = b[k + {first}U];");
            }
            for column in 0..*width {
                for row in 0..*height {
                    let _ = writeln!(text, "        y{row}{column} += a{row} * b{column};");
                }
            }
            text.push_str("    }\n");
        }
        for column in 0..*width {
            for row in 0..*height {
                let _ = writeln!(text, "    result[{}] = y{row}{column};", row + rows * column);
            }
        }
        text
    }
}
