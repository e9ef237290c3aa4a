//! Products with up to four rows, terms and columns, written out and inline in their header, so that they need no
//! call.
//!
//! The left factor stays in registers, as vectors of rows. If a vector of the target has room for two columns of the
//! result, it holds both. The last vector of rows may overlap the one before; elements are then computed twice, to
//! the same bits.

use std::fmt::Write as _;

use bessemer_ir::Float;

use super::{Sizes, real};
use crate::kernels::loops::IN_SOFTWARE;
use crate::kernels::text::{bytes, vectors_if};

/// Largest size.
pub(super) const LARGEST: u32 = 4;

/// Vectors of x86-64, the widest first: condition and bytes. Vectors of 64 bytes took 1.7 times as long.
const TARGETS: [(&str, u32); 2] = [("defined(__AVX__)", 32), ("defined(__SSE2__)", 16)];

/// Contents of a vector.
#[derive(Clone, Copy, PartialEq)]
enum Plan {
    /// A number of rows of one column.
    Rows(u32),
    /// A whole column and the next one.
    TwoColumns,
}

/// Number of products from which loops are much shorter than what is written out.
const MANY: u32 = 9;

/// Reason of the loops where `double` is in software.
const IN_LOOPS: &str = "\
/* Where double is computed in software, its functions take the time: loops are about as fast, and much shorter. */";

/// Returns the body of a product; `loops` are its plain loops.
pub(super) fn source(element: Float, sizes: Sizes, loops: &str) -> String {
    let mut text = String::new();
    let mut kept: Vec<(&str, Plan)> = Vec::new();
    for (condition, width) in TARGETS.into_iter().rev() {
        let Some(plan) = plan(element, sizes, width) else { continue };
        // The same as with narrower vectors: no case of its own.
        if kept.last().is_none_or(|(_, narrower)| *narrower != plan) {
            kept.push((condition, plan));
        }
    }
    for (index, (condition, plan)) in kept.iter().rev().enumerate() {
        let word = if index == 0 { "if" } else { "elif" };
        let _ = writeln!(text, "#{word} {}", vectors_if(condition));
        text += &match plan {
            Plan::Rows(lanes) => rows(element, sizes, *lanes),
            Plan::TwoColumns => two_columns(element, sizes),
        };
    }
    if element == Float::F64 && sizes.rows * sizes.inner * sizes.columns >= MANY {
        let word = if kept.is_empty() { "if" } else { "elif" };
        let _ = writeln!(text, "#{word} {IN_SOFTWARE}\n{IN_LOOPS}");
        text += loops;
    }
    match text.is_empty() {
        true => plain(element, sizes),
        false => format!("{text}#else\n{}#endif\n", plain(element, sizes)),
    }
}

fn plan(element: Float, sizes: Sizes, width: u32) -> Option<Plan> {
    let lanes = width / bytes(element);
    let lies_in_columns = sizes.left.0 == 1 && sizes.right.0 == 1;
    let halves = 2 * sizes.rows <= lanes && sizes.rows == 4;
    // Each half of the vector takes its numbers from a column of four.
    if halves && lies_in_columns && sizes.inner == sizes.rows && sizes.columns.is_multiple_of(2) {
        return Some(Plan::TwoColumns);
    }
    let fits = |lanes: &u32| *lanes <= sizes.rows && lanes * bytes(element) >= 16;
    [4, 2].into_iter().filter(|it| *it <= lanes).find(fits).map(Plan::Rows)
}

fn vector(element: Float, name: &str, lanes: u32) -> String {
    let (real, size) = (real(element), bytes(element));
    format!(
        "typedef {real} {name} __attribute__((vector_size({}), aligned({size}), may_alias));\n",
        lanes * size
    )
}

/// Returns the sum of terms in order, added one by one.
fn sum(terms: u32, term: impl Fn(u32) -> String) -> String {
    let terms: Vec<String> = (0..terms).map(term).collect();
    let together = terms.iter().map(String::len).sum::<usize>() < 80;
    terms.join(if together { " + " } else { "\n    + " })
}

fn rows(element: Float, sizes: Sizes, lanes: u32) -> String {
    let Sizes { rows, inner, columns, left, right } = sizes;
    let mut text = vector(element, "rows_t", lanes);
    let mut tops: Vec<u32> = (0..rows / lanes).map(|vector| vector * lanes).collect();
    if !rows.is_multiple_of(lanes) {
        tops.push(rows - lanes);
    }
    for k in 0..inner {
        for top in &tops {
            let at = |row: u32| left.0 * row + left.1 * k;
            let value = match left.0 {
                1 => format!("*(const rows_t *)&a[{}]", at(*top)),
                _ => {
                    let list: Vec<String> =
                        (0..lanes).map(|lane| format!("a[{}]", at(top + lane))).collect();
                    format!("{{{}}}", list.join(", "))
                }
            };
            let _ = writeln!(text, "const rows_t a{top}{k} = {value};");
        }
    }
    // Numbers that fill a vector are loaded once and spread from there: as integers, whose shuffle copies nothing.
    let quarter = 16 / bytes(element);
    let spread = lanes == quarter && right.0 == 1 && inner == quarter;
    if spread {
        text +=
            "typedef int32_t words_t __attribute__((vector_size(16), aligned(4), may_alias));\n";
    }
    for column in 0..columns {
        let at = right.1 * column;
        if spread {
            let _ = writeln!(text, "const words_t b{column} = *(const words_t *)&b[{at}];");
        }
        let number = |k: u32| match (spread, element) {
            (false, _) => format!("b[{}]", at + right.0 * k),
            (true, Float::F32) => shuffle("rows_t", column, [k, k, k, k]),
            (true, Float::F64) => shuffle("rows_t", column, [2 * k, 2 * k + 1, 2 * k, 2 * k + 1]),
        };
        for top in &tops {
            let value = sum(inner, |k| format!("a{top}{k} * {}", number(k)));
            let _ = writeln!(text, "const rows_t y{top}{column} = {value};");
        }
        for top in &tops {
            let _ = writeln!(text, "*(rows_t *)&result[{}] = y{top}{column};", rows * column + top);
        }
    }
    text
}

fn shuffle(ty: &str, column: u32, [w, x, y, z]: [u32; 4]) -> String {
    format!("({ty})__builtin_shufflevector(b{column}, b{column}, {w}, {x}, {y}, {z})")
}

/// Returns the variant for four rows, with two columns of the result in a vector.
fn two_columns(element: Float, sizes: Sizes) -> String {
    let mut text = vector(element, "column_t", 4) + &vector(element, "columns_t", 8);
    text += "/* A column of the left factor, once for each of the two. */\n";
    for k in 0..4 {
        let _ = writeln!(
            text,
            "const column_t once{k} = *(const column_t *)&a[{}];\n\
             const columns_t a{k} = __builtin_shufflevector(once{k}, once{k}, 0, 1, 2, 3, 0, 1, 2, 3);",
            4 * k
        );
    }
    for column in (0..sizes.columns).step_by(2) {
        let at = 4 * column;
        let _ = writeln!(text, "const columns_t b{column} = *(const columns_t *)&b[{at}];");
        let number = |k: u32| {
            let (low, high) = (k.to_string(), (k + 4).to_string());
            let list = [low.as_str(), &low, &low, &low, &high, &high, &high, &high].join(", ");
            format!("__builtin_shufflevector(b{column}, b{column}, {list})")
        };
        let value = sum(4, |k| format!("a{k} * {}", number(k)));
        let _ = writeln!(text, "*(columns_t *)&result[{at}] = {value};");
    }
    text
}

/// Returns the variant with scalars: the first products, then the others in order; the result is stored when no
/// operand is needed any more.
///
/// A sum in one expression would be shorter, but compilers then load operands again when registers run out. Products
/// of four by four took a tenth more instructions on a Cortex-A9, and a quarter more on a Cortex-M4F, where doubles
/// are in software.
fn plain(element: Float, sizes: Sizes) -> String {
    let Sizes { rows, inner, columns, left, right } = sizes;
    let real = real(element);
    let mut text = String::from(
        "/* y<row><column> starts as its first product and takes the others in order: each k gives all sums a term, so\n\
         \x20  that an element that is loaded is used at once. Stored when nothing is read any more. */\n",
    );
    for k in 0..inner {
        for row in 0..rows {
            let _ = writeln!(text, "const {real} a{row}{k} = a[{}];", left.0 * row + left.1 * k);
        }
        for column in 0..columns {
            let at = right.0 * k + right.1 * column;
            let _ = writeln!(text, "const {real} b{k}{column} = b[{at}];");
            for row in 0..rows {
                let (head, step) = match k {
                    0 => (format!("{real} "), "="),
                    _ => (String::new(), "+="),
                };
                let _ = writeln!(text, "{head}y{row}{column} {step} a{row}{k} * b{k}{column};");
            }
        }
    }
    for column in 0..columns {
        for row in 0..rows {
            let _ = writeln!(text, "result[{}] = y{row}{column};", row + rows * column);
        }
    }
    text
}
