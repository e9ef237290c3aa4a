//! Elimination with row pivots in tiles: solve and inverse.

use bessemer_ir::{Float, Int, Kernel, KernelRoutine, Scalar};

use super::{lanes, ordered, rows};
use crate::kernels::rows as by_rows;
use crate::kernels::text::{fill, indented, values, without};
use crate::kernels::threads::{Own, Work};
use crate::kernels::{Buffer, Mode, Source, declarations, fast};

/// Smallest matrix that is faster in tiles.
pub const SMALLEST: u32 = 5;

const SQUARES: &str = include_str!("squares.c");
const TILE: &str = include_str!("tile.c");
const SUBTRACT: &str = include_str!("subtract.c");
const SUBTRACT_FAST: &str = include_str!("subtract_fast.c");
const ELIMINATION: &str = include_str!("elimination.c");
const SOLVE: &str = include_str!("solve.c");
const PANELS: &str = include_str!("panels.c");
const LU_SOLVE: &str = include_str!("lu_solve.c");
const ONE_SIDE: &str = include_str!("one_side.c");
const MANY_SIDES: &str = include_str!("many_sides.c");
const INVERSE: &str = include_str!("inverse.c");
const INVERT_PANELS: &str = include_str!("invert_panels.c");
const SHARE_SIDES: &str = include_str!("share_sides.c");

/// Smallest size for which threads are used.
const THREADED: u32 = 48;
/// Smallest number of right-hand sides for which threads are used.
const THREADED_SIDES: u32 = 8;

const ONE_THREAD: &str = "invert_panels(tiles, a, order, finite, panel, 0U, 1U);\n";

/// Private panel of a thread.
const OWN_PANEL: Own<'static> = Own {
    ty: "$real *",
    name: "panel",
    memory: "$real panel_memory[$panel];",
    value: "aligned(panel_memory)",
};

const INVERT: Work<'static> = Work {
    name: "invert_panels",
    shared: &[
        ("const $real *", "tiles"),
        ("$real *", "a"),
        ("const uint32_t *", "order"),
        ("bool", "finite"),
    ],
    own: Some(OWN_PANEL),
};

const SIDES: Work<'static> = Work {
    name: "solve_sides",
    shared: &[("const $real *", "tiles"), ("$real *", "b"), ("const uint32_t *", "pivots")],
    own: Some(OWN_PANEL),
};

/// Templates for sizes that are multiples of four, and for sizes whose last tiles are padded.
const GIVE_BACK: [&str; 2] = [include_str!("give_back.c"), include_str!("give_back_edges.c")];
const GIVE_COLUMNS: [&str; 2] =
    [include_str!("give_columns.c"), include_str!("give_columns_edges.c")];

const FILL: &str = "\
    for (uint32_t row = 0U; row < ROWS; row += 4U) {
        to_rows(&columns[row], &four[WIDTH * row]);
    }
";

const FILL_EDGES: &str = "\
    uint32_t row = 0U;
    for (; row + 4U <= SIZE && first + 4U <= SIZE; row += 4U) {
        to_rows(&columns[row], &four[WIDTH * row]);
    }
    for (; row < ROWS; row++) {
        for (uint32_t lane = 0U; lane < 4U; lane++) {
            const bool there = row < SIZE && first + lane < SIZE;
            four[WIDTH * row + lane] = there ? columns[row + SIZE * lane] : $zero;
        }
    }
";

const TAIL: &str = "\
    for (uint32_t lane = 0U; lane < $edge && row < SIZE - $edge; lane++) {
        if (rank(four[lane]) >= highest) {
            highest = consider(&best, &four[lane]);
        }
    }
";

const PAD: &str = "\
    /* What fills the last tiles up: rows of zeros, columns of the identity. */
    for (uint32_t column = 0U; column < ROWS; column++) {
        for (uint32_t row = (column < SIZE) ? SIZE : 0U; row < ROWS; row++) {
            tiles[place(row - row % 4U, column) + row % 4U] = (row == column) ? $one : $zero;
        }
    }
";

const PAD_X: &str = "\
for (uint32_t row = SIZE; row < ROWS; row++) {
    x[row] = $zero;
}";

const PAD_ROWS: &str = "\
    for (uint32_t index = WIDTH * SIZE; index < WIDTH * ROWS; index++) {
        panel[index] = $zero;
    }
";

const SPOIL: &str = "    for (uint32_t index = 0U; index < SIZE * SIZE; index++) {
        a[index] = $nan;
    }
";

/// Returns the columns that a panel of vectors may have: none if the matrix is processed by rows where there are
/// vectors.
fn room(kernel: &Kernel) -> u32 {
    if by_rows::fits(kernel) { 0 } else { rows(kernel.dims[0]) }
}

/// Returns the numbers for the alignment to a cache line, where there are vectors.
fn spare(kernel: &Kernel) -> u32 {
    if by_rows::fits(kernel) { 0 } else { lanes::line(kernel.element) }
}

/// Returns the columns in whole panels, for the target with the widest.
fn columns(kernel: &Kernel) -> u32 {
    rows(kernel.dims[0]).next_multiple_of(lanes::widest(kernel.element, room(kernel)))
}

/// Returns the numbers of a panel, and of the rows beside it.
fn panel(kernel: &Kernel) -> u32 {
    let numbers = (rows(kernel.dims[0]) + 4) * lanes::widest(kernel.element, room(kernel));
    match ordered::fits(kernel) {
        true => numbers.max(ordered::numbers(kernel)) + spare(kernel),
        false => numbers + spare(kernel),
    }
}

/// Returns the memory of a kernel; with `sides`, right-hand sides have a panel too.
pub(super) fn buffers(kernel: &Kernel, size: u32, sides: bool) -> Vec<Buffer> {
    let element = Scalar::Float(kernel.element);
    let number = Scalar::Int(Int::U32);
    let mut buffers = vec![
        Buffer {
            name: "tile_memory",
            element,
            len: rows(size) * columns(kernel) + spare(kernel),
            holds: "The factors, in tiles.",
        },
        Buffer { name: "panel_memory", element, len: panel(kernel), holds: "The panel at work." },
        match ordered::fits(kernel) {
            true => Buffer {
                name: "pivots",
                element: number,
                len: ordered::orders(size),
                holds: "The order of the rows by their pivots.",
            },
            false => Buffer {
                name: "pivots",
                element: number,
                len: rows(size),
                holds: "The row that each step exchanges with its own.",
            },
        },
    ];
    if sides {
        buffers.push(Buffer {
            name: "order",
            element: number,
            len: rows(size),
            holds: "The column of the inverse that each pivot gives.",
        });
    }
    buffers
}

/// Returns the C of a solve for one right-hand side, or for panels of them; if `a` is working memory, it becomes the
/// factors.
pub(super) fn solve(kernel: &Kernel, size: u32, sides: u32, mode: Mode) -> Source {
    let edges = usize::from(!size.is_multiple_of(4));
    let (parts, substitute) = match sides {
        1 => (SOLVE, ONE_SIDE),
        _ => (PANELS, MANY_SIDES),
    };
    let threads = SIDES.text();
    let (share, whole);
    let (mut parts, mut spoil, mut give_back) = (vec![parts], "", "");
    if size >= THREADED && sides >= THREADED_SIDES {
        let apart = [("begin", "from * WIDTH"), ("apart", "apart * WIDTH")];
        share = SHARE_SIDES.replace("$sides", &indented(&with(substitute, apart)));
        whole = SIDES.call();
        parts.extend([share.as_str(), threads.as_str()]);
    } else {
        whole = with(substitute, [("begin", "0U"), ("apart", "WIDTH")]);
    }
    if kernel.routine == KernelRoutine::LuSolve {
        parts.push(GIVE_BACK[edges]);
        (spoil, give_back) = (SPOIL, "give_back(a, tiles);\n");
    }
    let body = LU_SOLVE
        .replace("$substitute\n", &whole)
        .replace("$spoil", spoil)
        .replace("$give_back", give_back);
    assemble(kernel, (size, sides), &parts, &body, mode)
}

/// Returns a template with two of its names replaced.
fn with(template: &str, values: [(&str, &str); 2]) -> String {
    let values = values.map(|(name, value)| (name, value.to_owned()));
    fill(template, &values)
}

/// Returns the C of an inverse: right-hand sides in the order of the pivots.
pub(super) fn inverse(kernel: &Kernel, size: u32, mode: Mode) -> Source {
    let edges = usize::from(!size.is_multiple_of(4));
    let mut parts = vec![PANELS, GIVE_COLUMNS[edges], INVERT_PANELS];
    let (threads, mut panels) = (INVERT.text(), ONE_THREAD.to_owned());
    if size >= THREADED {
        parts.push(&threads);
        panels = INVERT.call();
    }
    let body = INVERSE.replace("$panels\n", &panels);
    assemble(kernel, (size, size), &parts, &body, mode)
}

/// Returns the complete source: sizes, the rows of the targets, elimination, the rest, and the body.
fn assemble(
    kernel: &Kernel,
    (size, sides): (u32, u32),
    rest: &[&str],
    body: &str,
    mode: Mode,
) -> Source {
    let values = all_values(kernel, size, sides);
    let twice = |text: &str| fill(&fill(text, &values), &values);
    let head = format!(
        "#define SIZE {size}U\n/* Rows in whole tiles. */\n#define ROWS {}U\n\n",
        rows(size)
    );
    let note = if mode == Mode::Fast { fast::note(kernel) } else { String::new() };
    let ordered = ordered::fits(kernel);
    let mut before = note + &head + &lanes::text(kernel.element, room(kernel), mode, ordered);
    let subtract = match mode {
        Mode::Exact | Mode::Plain => SUBTRACT.to_owned(),
        Mode::Fast => {
            format!("#if defined(SPLIT)\n{SUBTRACT_FAST}#else\n{SUBTRACT}#endif\n")
        }
    };
    if ordered {
        let text = ordered::text(kernel, mode, OWN_PANEL);
        before += &format!("\n#if defined(ORDERED)\n{}#else", twice(&text));
    }
    let tile = registers(TILE, kernel.element);
    for part in [SQUARES, &tile, &subtract, ELIMINATION].iter().chain(rest) {
        before += "\n";
        before += &twice(part);
    }
    let mut body = body.to_owned();
    if ordered {
        before += "#endif\n";
        let other = ordered::body(kernel, mode, OWN_PANEL);
        body = format!("#if defined(ORDERED)\n{other}#else\n{body}#endif\n");
    }
    let buffers = buffers(kernel, size, kernel.routine == KernelRoutine::Inverse);
    let body = twice(&(declarations(&buffers) + &body)).replace("\n\n", "\n");
    // What ARM loads many numbers with differs between the types.
    let before = match kernel.element {
        Float::F64 => without(&before, "SINGLES"),
        Float::F32 => without(&before, "WORDS"),
    };
    let before = before.trim_end().to_owned();
    Source { before, body, math: true, string: true, ..Source::default() }
}

/// Returns the template with names for the registers of a tile, `$r0_` to `$r15_`; a function need not save these for
/// its caller.
fn registers(template: &str, element: Float) -> String {
    let (bank, first, constraint) = match element {
        Float::F64 => ("d", 16, "w"),
        Float::F32 => ("s", 0, "t"),
    };
    let text = template.replace("$w", constraint);
    (0..16).fold(text, |text, number| {
        text.replace(&format!("$r{number}_"), &format!("{bank}{}", first + number))
    })
}

fn all_values(kernel: &Kernel, size: u32, sides: u32) -> Vec<(&'static str, String)> {
    let element = kernel.element;
    let edge = size % 4;
    let mut all = values(element, &[("columns", sides), ("edge", edge)]);
    all.push(("panel", format!("{}U", panel(kernel))));
    let (maximum, x86_vector) = match element {
        Float::F64 => ("_mm256_max_pd", "__m256d"),
        Float::F32 => ("_mm256_max_ps", "__m256"),
    };
    let (bits, rank, infinite, magnitude_bits) = match element {
        Float::F64 => ("uint64_t", "(uint32_t)(bits >> 32)", "0xFFE00000U", "INT64_MAX"),
        Float::F32 => ("uint32_t", "bits", "0xFF000000U", "INT32_MAX"),
    };
    let edges = |text: &str| if edge == 0 { String::new() } else { text.to_owned() };
    all.extend([
        ("maximum", maximum.to_owned()),
        ("x86_vector", x86_vector.to_owned()),
        ("bits", bits.to_owned()),
        ("rank", rank.to_owned()),
        ("infinite", infinite.to_owned()),
        ("fill", if edge == 0 { FILL } else { FILL_EDGES }.to_owned()),
        ("tail", edges(TAIL)),
        ("pad", edges(PAD)),
        ("magnitude_bits", magnitude_bits.to_owned()),
        ("pad_x", edges(PAD_X)),
        ("pad_rows", edges(PAD_ROWS)),
        ("fewer", edges(", (SIZE - k < 4U) ? SIZE - k : 4U")),
    ]);
    all
}
