//! Tiles of scalars, in plain C99: for targets with 32 registers, such as ARM's VFPv3, and for those with 16.

use std::fmt::Write as _;

use bessemer_ir::Float;

use super::Sizes;

/// Number of registers of a target for scalars.
#[derive(Clone, Copy)]
enum Registers {
    ThirtyTwo,
    Sixteen,
}

impl Registers {
    /// Returns the tried shapes of tiles, rows by columns, whose sums and operands stay in registers.
    fn shapes(self) -> &'static [(u32, u32)] {
        match self {
            Registers::ThirtyTwo => &[(4, 4), (3, 6), (6, 3), (4, 5), (5, 4)],
            Registers::Sixteen => &[(4, 3), (3, 4), (3, 3)],
        }
    }

    /// Returns the size of an instruction: of ARM, or an average of x86-64, where a multiplication overwrites an
    /// operand, bytes.
    fn bytes(self) -> u32 {
        match self {
            Registers::ThirtyTwo => 4,
            Registers::Sixteen => 10,
        }
    }
}

/// Returns the condition of targets with 16 registers: x86, and with `double` a Cortex-M.
fn has_sixteen(element: Float) -> &'static str {
    match element {
        Float::F64 => {
            "defined(__x86_64__) || (defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M')"
        }
        Float::F32 => "defined(__x86_64__)",
    }
}

/// Largest code size for which the loop over k is unrolled, bytes, at four bytes per instruction.
const BUDGET: u32 = 2048;

/// Returns the functions of the tiles and the calls of them, for all columns or a thread's share.
pub(super) fn source(
    element: Float,
    sizes: Sizes,
    code_bytes: u32,
    shares: bool,
) -> Option<(String, String)> {
    let of = |registers| plan(sizes, code_bytes, registers);
    let (many, few) = (of(Registers::ThirtyTwo)?, of(Registers::Sixteen));
    let text = |plan: &Plan| tiles_of(element, sizes, plan, shares);
    let (tiles, calls) = text(&many);
    // The sums of a tile, its rows, a number of the right factor, and a product.
    let has_room = |&(height, width): &(u32, u32)| height * width + height + 2 <= 16;
    let roomy = shapes(sizes, many.shape).iter().all(has_room);
    let Some(few) = few.filter(|few| !roomy && *few != many) else { return Some((tiles, calls)) };
    let (few_tiles, few_calls) = text(&few);
    let condition = has_sixteen(element);
    Some((
        format!(
            "#if {condition}\n/* Tiles for 16 registers. */\n#define SIXTEEN\n{few_tiles}\n#else\n{tiles}\n#endif"
        ),
        format!("#if defined(SIXTEEN)\n{few_calls}#else\n{calls}#endif\n"),
    ))
}

fn tiles_of(element: Float, sizes: Sizes, plan: &Plan, shares: bool) -> (String, String) {
    let real = super::real(element);
    let mut body = String::new();
    // Whole tiles in loops, then what is left below and on the right.
    for (column, width, columns_many) in parts(sizes.columns, plan.shape.1) {
        let inset = if columns_many || shares { "    " } else { "" };
        let _ = match (columns_many, shares) {
            (true, false) => writeln!(
                body,
                "for (uint32_t column = 0U; column < {column}U; column += {width}U) {{"
            ),
            (true, true) => writeln!(
                body,
                "for (uint32_t column = {width}U * from; column < {column}U; column += {width}U * apart) {{"
            ),
            (false, true) => writeln!(body, "if (from == 0U) {{"),
            (false, false) => Ok(()),
        };
        for (row, height, rows_many) in parts(sizes.rows, plan.shape.0) {
            let a = place(&[(sizes.left.0, row, rows_many.then_some("row"))]);
            let b = place(&[(sizes.right.1, column, columns_many.then_some("column"))]);
            let to = place(&[
                (1, row, rows_many.then_some("row")),
                (sizes.rows, column, columns_many.then_some("column")),
            ]);
            let call = format!("tile_{height}x{width}(&a[{a}], &b[{b}], &result[{to}]);");
            if rows_many {
                let _ = writeln!(
                    body,
                    "{inset}for (uint32_t row = 0U; row < {row}U; row += {height}U) {{\n{inset}    {call}\n{inset}}}"
                );
            } else {
                let _ = writeln!(body, "{inset}{call}");
            }
        }
        body += if columns_many || shares { "}\n" } else { "" };
    }
    let tile = |shape: &(u32, u32)| tile(real, *shape, sizes, plan.unrolled);
    let tiles: Vec<String> = shapes(sizes, plan.shape).iter().map(tile).collect();
    (tiles.join("\n").trim_end().to_owned(), body)
}

/// Tiling of a product.
#[derive(PartialEq)]
struct Plan {
    shape: (u32, u32),
    /// True if the loop over k is unrolled.
    unrolled: bool,
}

/// Returns the tile with the fewest instructions that fits into the code size, if there is one.
fn plan(sizes: Sizes, code_bytes: u32, registers: Registers) -> Option<Plan> {
    let step = |(height, width): (u32, u32)| height * width + height + width;
    // The first products and the stores, and the call, are beside the steps.
    let bytes = |shape, steps: u32| -> u32 {
        let tile =
            |shape: (u32, u32)| registers.bytes() * (steps * step(shape) + shape.0 * shape.1 + 12);
        shapes(sizes, shape).into_iter().map(tile).sum()
    };
    let plan = |shape| {
        let budget = code_bytes.min(BUDGET * registers.bytes() / 4);
        let unrolled = bytes(shape, sizes.inner) <= budget && sizes.inner > 1;
        (unrolled || bytes(shape, 2) <= code_bytes).then_some(Plan { shape, unrolled })
    };
    // A tile: its steps, their loop, its sums from and to memory, its call.
    let cost = |plan: &Plan| {
        let mut sum = 0;
        for (column, width, columns_many) in parts(sizes.columns, plan.shape.1) {
            for (row, height, rows_many) in parts(sizes.rows, plan.shape.0) {
                let tiles = if columns_many { column / width } else { 1 }
                    * if rows_many { row / height } else { 1 };
                let turn = if plan.unrolled { 0 } else { 5 };
                sum += tiles * (sizes.inner * (step((height, width)) + turn) + height * width + 12);
            }
        }
        sum
    };
    registers.shapes().iter().copied().filter_map(plan).min_by_key(cost)
}

/// Returns the shapes that occur, without duplicates.
fn shapes(sizes: Sizes, shape: (u32, u32)) -> Vec<(u32, u32)> {
    let mut shapes = Vec::new();
    for (_, width, _) in parts(sizes.columns, shape.1) {
        for (_, height, _) in parts(sizes.rows, shape.0) {
            if !shapes.contains(&(height, width)) {
                shapes.push((height, width));
            }
        }
    }
    shapes
}

/// Returns an index: the constant parts as one number, then each loop's counter times its stride.
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

/// Returns the whole tiles, if any: their end (or the beginning of one), the lines of a tile, and true if they are
/// many. The rest follows.
fn parts(count: u32, tile: u32) -> Vec<(u32, u32, bool)> {
    let whole = count - count % tile;
    let mut parts = Vec::new();
    if whole > tile {
        parts.push((whole, tile, true));
    } else if whole == tile {
        parts.push((0, tile, false));
    }
    if count > whole {
        parts.push((whole, count - whole, false));
    }
    parts
}

/// Returns the function of a tile of the result.
fn tile(real: &str, (height, width): (u32, u32), sizes: Sizes, unrolled: bool) -> String {
    let Sizes { rows, inner, left, right, .. } = sizes;
    let mut text = format!(
        "/* A tile of {height} by {width} elements: y<row><column> is a sum in a register. The first products, then a term of\n\
         \x20  each sum for each k, in the order of k. */\n\
         static void tile_{height}x{width}(const {real} *a, const {real} *b, {real} *result)\n{{\n"
    );
    // Writing to a string cannot fail.
    for column in 0..width {
        for row in 0..height {
            let (first, second) = (left.0 * row, right.1 * column);
            let _ = writeln!(text, "    {real} y{row}{column} = a[{first}] * b[{second}];");
        }
    }
    if inner > 1 {
        if unrolled {
            let _ = writeln!(text, "#if defined(__GNUC__)\n#pragma GCC unroll {inner}\n#endif");
        }
        let _ = writeln!(text, "    for (uint32_t k = 1U; k < {inner}U; k++) {{");
        let _ = writeln!(text, "        a = &a[{}];", left.1);
        if right.0 > 1 {
            let _ = writeln!(text, "        b = &b[{}];", right.0);
        }
        for row in 0..height {
            let _ = writeln!(text, "        const {real} a{row} = a[{}];", left.0 * row);
        }
        for column in 0..width {
            let at = right.1 * column;
            let at = if right.0 > 1 { at.to_string() } else { format!("k + {at}U") };
            let _ = writeln!(text, "        const {real} b{column} = b[{at}];");
            for row in 0..height {
                let _ = writeln!(text, "        y{row}{column} += a{row} * b{column};");
            }
        }
        text.push_str("    }\n");
    }
    for column in 0..width {
        for row in 0..height {
            let _ = writeln!(text, "    result[{}] = y{row}{column};", row + rows * column);
        }
    }
    text + "}\n"
}
