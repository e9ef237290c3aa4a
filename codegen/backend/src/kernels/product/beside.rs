//! Products of several columns side by side, for SSE2, where a multiplication overwrites an operand and broadcasts
//! are expensive.
//!
//! Each vector of rows is loaded once for all columns, so the last column may overwrite it. For v vectors of rows and
//! c columns a term takes 3 v c + 1 instructions and the loads of its numbers; one column at a time takes 3 v + 1 for
//! each. Registers suffice for three vectors of rows, or for four and two columns.

use bessemer_ir::Float;

use super::Sizes;
use crate::kernels::text::{bytes, fill};

const FUNCTIONS: &str = include_str!("beside.c");

const CALLS: &str = "\
for (uint32_t column = 0U; column < $whole; column += $beside) {
    columns_beside(a, &b[$inner * column], &result[$rows * column], $beside);
}
";

/// Code for the remaining columns.
const LEFT: &str = "columns_beside(a, &b[$inner * $whole], &result[$rows * $whole], $left);\n";

/// Code for the remaining terms, whose numbers fill no vector.
const REST: &str = "\
#pragma GCC unroll 4
    for (uint32_t k = $inner - $inner % NUMBERS_AT_ONCE; k < $inner; k++) {
#pragma GCC unroll 4
        for (uint32_t column = 0U; column < beside; column++) {
            const $real number = b[k + $inner * column];
            numbers[column] = (words_t)(lanes_t)$alike;
        }
        add_beside(&a[$rows * k], numbers, 0U, sums, beside);
    }
";

/// Code that adds a product to its sum. For `f64`, gcc copies less if the product has its own register.
const PRODUCTS: [&str; 2] = [
    "            lanes_t product = rows[vector] * number;
            IN_ITS_REGISTER(product);
            sums[column][vector] += product;
",
    "            sums[column][vector] += rows[vector] * number;
",
];

/// Largest number of columns side by side.
const MOST: u32 = 3;

/// Largest number of elements of the right factor for which the loop over columns is unrolled.
const UNROLLED: u32 = 64;

/// Returns the number of columns that fit into registers beside `down` vectors of rows.
pub(super) fn most(element: Float, down: u32, columns: u32, registers: u32) -> u32 {
    // Beside the sums: the rows of a term, numbers of each column, a product.
    let fits = |beside: &u32| down * beside + down + beside < registers;
    let most = match (element, down) {
        // Copies of numbers took what was gained.
        (Float::F64, 4..) => 1,
        _ => MOST.min(columns),
    };
    (2..=most).rev().find(fits).unwrap_or(1)
}

/// Returns the functions and the calls of them.
pub(super) fn source(element: Float, sizes: Sizes, beside: u32) -> (String, String) {
    let together = 16 / bytes(element);
    let left = sizes.columns % beside;
    let unrolled = match sizes.inner * sizes.columns <= UNROLLED {
        true => format!("#pragma GCC unroll {}\n", sizes.columns / beside),
        false => String::new(),
    };
    let rest = if sizes.inner.is_multiple_of(together) { "" } else { REST };
    let alike = vec!["number"; together as usize].join(", ");
    let functions = [
        ("cases", cases(element)),
        ("rest", rest.replace("$alike", &format!("{{{alike}}}"))),
        ("product", PRODUCTS[usize::from(element == Float::F32)].to_owned()),
        ("beside", format!("{beside}U")),
    ];
    let calls = [
        ("whole", format!("{}U", sizes.columns - left)),
        ("left", format!("{left}U")),
        ("beside", format!("{beside}U")),
    ];
    let text = if left == 0 { CALLS.to_owned() } else { CALLS.to_owned() + LEFT };
    (fill(FUNCTIONS, &functions), unrolled + &fill(&text, &calls))
}

/// Returns the cases that select which element of a vector is broadcast.
fn cases(element: Float) -> String {
    let cases: &[&str] = match element {
        Float::F64 => &["0, 1, 0, 1", "2, 3, 2, 3"],
        Float::F32 => &["0, 0, 0, 0", "1, 1, 1, 1", "2, 2, 2, 2", "3, 3, 3, 3"],
    };
    let case = |(index, places): (usize, &&str)| {
        let label = match index + 1 == cases.len() {
            true => "default".to_owned(),
            false => format!("case {index}U"),
        };
        format!(
            "    {label}:\n        return (lanes_t)__builtin_shufflevector(numbers, numbers, {places});\n"
        )
    };
    cases.iter().enumerate().map(case).collect()
}
