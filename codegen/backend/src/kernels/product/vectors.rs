//! Products in blocks of vectors of rows by columns, for gcc and clang targets with vectors.
//!
//! The last vector, and the last band of rows, may overlap the one before; elements are then computed twice, to the
//! same bits. [`bands`](super::bands) plans the blocks.

use bessemer_ir::Float;

use super::bands::{self, Bands};
use super::blocks::Blocks;
use super::target::{TARGETS, Target};
use super::{Sizes, beside, times};
use crate::kernels::text::{FUSED, bytes, fill, fused, numbers, vectors_if};
use crate::kernels::{Mode, Tuning};

const TIMES: &str = "#define TIMES(rows, number) ((rows) * (number))\n";
const PLUS: &str = "#define PLUS(sum, rows, number) ((sum) + (rows) * (number))\n";
const HOLD: &str = "#define IN_ITS_REGISTER(value) __asm__(\"\" : \"+v\"(value))\n";

/// Variants of a product for a target.
#[derive(Clone, Copy, PartialEq)]
enum Form {
    /// Left factor held in registers.
    Held,
    /// One part of a column, or this number of columns side by side, with numbers broadcast from vectors.
    Columns(u32),
    /// Blocks.
    Blocks(Bands),
}

impl Form {
    fn bands(self) -> Option<Bands> {
        match self {
            Form::Blocks(bands) => Some(bands),
            _ => None,
        }
    }
}

/// Plan of a product for a target.
#[derive(Clone, Copy, PartialEq)]
struct Plan {
    /// Number of lanes of a vector.
    lanes: u32,
    /// Number of vectors one below another.
    down: u32,
    form: Form,
}

const COMMON: &str = include_str!("common.c");

/// Code that defines the rows of a band.
const HEIGHT: &str = "\
/* The rows of a band. */
#define HEIGHT ((LANES * VECTORS < $rows) ? LANES * VECTORS : $rows)
";

/// Definitions of the words that describe the targets' variants.
const WORDS: [(&str, &str); 9] = [
    (
        "LANES",
        "/* LANES: numbers in a vector.\n   VECTORS: vectors below one another, which hold the rows of a column.",
    ),
    (
        "A_IN_REGISTERS",
        "\n   A_IN_REGISTERS: there are registers for all of a, which is loaded once.",
    ),
    ("NUMBERS_AT_ONCE", "\n   NUMBERS_AT_ONCE: numbers of b that one load brings."),
    (
        "COLUMNS",
        "\n   COLUMNS: columns of the result side by side, whose sums are in registers together.",
    ),
    ("LAST_VECTORS", "\n   LAST_VECTORS: VECTORS, for the rows that are left."),
    ("LAST_COLUMNS", "\n   LAST_COLUMNS: COLUMNS, for them."),
    (
        "LAST_ROW_COLUMNS",
        "\n   LAST_ROW_COLUMNS: columns at a time of a last row that fills no vector.",
    ),
    ("TERMS", "\n   TERMS: terms of the sums in a turn of the loop over them."),
    (
        "FIRST_TERMS",
        "\n   FIRST_TERMS: so many, with the first products, come before the first turn.",
    ),
];

const GATHER: &str = include_str!("gather.c");
const COLUMN: &str = include_str!("column.c");
const STEP: &str = include_str!("step.c");
const COLUMNS: &str = include_str!("columns.c");
const IN_ITS_REGISTER: &str = include_str!("in_its_register.c");
const HELD: &str = include_str!("held.c");

/// Largest number of terms for which a column's loop over them is unrolled.
const COLUMN_UNROLLED: u32 = 20;

/// Smallest number of terms for which an unrolled column orders its loads. Compilers would load so many rows ahead
/// that registers run out.
const IN_TURN_FROM: u32 = 12;

/// Code that hides the equality of an address with the previous terms' from the compiler. So no row is loaded before
/// its term.
const IN_TURN: &str = r#"        /* Rows wait for their terms: loaded ahead, they would take registers from the sums. */
        __asm__("" : "+r"(a));
"#;

/// Largest number of elements of the right factor for which the loop over the columns is unrolled, with the left
/// factor in registers.
const HELD_UNROLLED: u32 = 64;

/// Largest number of vectors one below another in a part of a column.
const COLUMN_DOWN: u32 = 10;

/// Code that adds a term to the last row of a column, which has fewer elements than a vector.
const ADD_LAST: &str = "\
/* A term of the last row, which fills no vector. The number is needed no more: its register takes the sum. */
static inline $real add_last(const $real sum, const $real *row, const lanes_t number)
{
    $real value = number[0];
    IN_ITS_REGISTER(value);
    value *= *row;
    IN_ITS_REGISTER(value);
    value += sum;
    IN_ITS_REGISTER(value);
    return value;
}

";
const LAST_TERM: &str =
    "        last = add_last(last, &a[$rows * (k + $next) + $bottom], number);\n";
const LAST_FIRST: &str = "    $real last = a[$bottom] * number[0];\n";
const LAST_STORED: &str = "    result[$bottom] = last;\n";

/// Code of a column in one part.
const WHOLE_COLUMNS: &str = "\
for (uint32_t column = $first_column; column < $columns; $next_column) {
    column_part(a, &b[$inner * column], &result[$rows * column]);
}
";

/// Returns the code before the function, and its body; none if there are too few rows.
pub(super) fn source(
    element: Float,
    sizes: Sizes,
    tuning: &Tuning,
    shares: bool,
) -> Option<(String, String)> {
    let mode = tuning.mode;
    let mut plans: Vec<(&Target, Plan)> = Vec::new();
    let mut last = None;
    for target in TARGETS.iter().rev() {
        if target.single && element != Float::F32 {
            continue;
        }
        let Some(plan) = plan(target, element, sizes, tuning) else { continue };
        // The same as with narrower vectors: no case of its own.
        if last == Some(plan) {
            continue;
        }
        last = (!target.single).then_some(plan);
        plans.push((target, plan));
    }
    if plans.is_empty() {
        return None;
    }
    let bands = plans.iter().filter_map(|(_, plan)| Some((plan.lanes, plan.form.bands()?)));
    let bands: Vec<(u32, Bands)> = bands.collect();
    let blocks = Blocks::new(sizes, &bands);
    let branches = plans.iter().rev();
    let branches: Vec<String> =
        branches.map(|(target, plan)| branch(target, element, *plan, mode, &blocks)).collect();
    let targets = format!("#{}#endif\n", branches.join("#el"));
    let gather = if sizes.left.0 == 1 { "" } else { GATHER };
    let mut before = String::new();
    let mut body = String::new();
    let mut word = "if";
    let uses = |wanted: fn(Form) -> bool| plans.iter().any(|(_, plan)| wanted(plan.form));
    if uses(|form| form == Form::Held) {
        body += &format!("#{word} defined(A_IN_REGISTERS)\n{HELD}");
        word = "elif";
    }
    let beside = plans.iter().find_map(|(_, plan)| match plan.form {
        Form::Columns(beside) => Some((beside, plan.lanes * plan.down + 1 == sizes.rows)),
        _ => None,
    });
    if let Some((beside, last)) = beside {
        let (functions, calls) = match (beside, last) {
            (1, false) => (column(element, sizes.inner, last), COLUMNS.to_owned()),
            (1, true) => (column(element, sizes.inner, last), WHOLE_COLUMNS.to_owned()),
            _ => beside::source(element, sizes, beside),
        };
        before += &format!("\n#if defined(NUMBERS_AT_ONCE)\n{functions}#endif\n");
        body += &format!("#{word} defined(NUMBERS_AT_ONCE)\n{calls}");
        word = "elif";
    }
    if uses(|form| matches!(form, Form::Blocks(_))) {
        before += &blocks.before();
        body += &format!("#{word} defined({})\n{}", blocks.condition(), blocks.body());
    }
    let height = if before.contains("HEIGHT") || body.contains("HEIGHT") { HEIGHT } else { "" };
    // A guard stands where a target may have a definition of its own.
    let guarded = |name: &str, text: String| match targets.contains(&format!("#define {name}(")) {
        true => format!("#if !defined({name})\n{text}#endif\n"),
        false => text,
    };
    let sum = guarded("PLUS", format!("{TIMES}{PLUS}"));
    let common = COMMON.replace("$height", height).replace("$sum", &sum);
    let held = IN_ITS_REGISTER.replace("$held", &guarded("IN_ITS_REGISTER", HOLD.to_owned()));
    let words = words(&targets);
    before = format!("{words}{targets}\n#if defined(LANES)\n{common}{gather}\n{held}{before}");
    let mut values = values(element, sizes, shares);
    values.extend(blocks.values());
    Some((fill(&before, &values), fill(&body, &values)))
}

/// Returns a comment on the macros that the targets define.
fn words(targets: &str) -> String {
    let used = WORDS.iter().filter(|(word, _)| targets.contains(&format!("#define {word}")));
    format!("{} */\n", used.map(|(_, meaning)| *meaning).collect::<String>())
}

/// Returns the macros of a target.
fn branch(target: &Target, element: Float, plan: Plan, mode: Mode, blocks: &Blocks) -> String {
    let Plan { lanes, down, form } = plan;
    let mut condition = target.condition.to_owned();
    let mut text = target.text.to_owned();
    if mode == Mode::Fast && target.single {
        condition = condition.replace(" && defined(BESSEMER_NEON_F32)", "");
    } else if mode == Mode::Fast && !matches!(form, Form::Columns(_)) {
        let plus = fused(element, lanes * bytes(element), "fmadd", ["number", "rows", "sum"]);
        text +=
            &format!("{FUSED}{TIMES}#define PLUS(sum, rows, number) ((lanes_t){plus})\n#endif\n");
    }
    let form = match form {
        Form::Held => "#define A_IN_REGISTERS\n".to_owned(),
        Form::Columns(_) => format!("#define NUMBERS_AT_ONCE {lanes}U\n"),
        Form::Blocks(bands) => blocks.defines(&bands),
    };
    format!(
        "if {}\n{text}#define LANES {lanes}U\n#define VECTORS {down}U\n{form}",
        vectors_if(&condition),
    )
}

/// Returns a vector with a number of the right factor in each lane.
fn alike(k: u32, lanes: u32) -> String {
    format!("(lanes_t){{{}}}", vec![format!("b[{k}]"); lanes as usize].join(", "))
}

/// Returns the code of a part of a column, with groups of terms; with `last_row` in scalars if it fills no vector.
fn column(element: Float, inner: u32, last_row: bool) -> String {
    let spread = |k: u32| {
        let places = match element {
            Float::F64 => [2 * k, 2 * k + 1, 2 * k, 2 * k + 1],
            Float::F32 => [k; 4],
        };
        let [w, x, y, z] = places;
        format!("(lanes_t)__builtin_shufflevector(numbers, numbers, {w}, {x}, {y}, {z})")
    };
    let last_row = |text: &str| if last_row { text.to_owned() } else { String::new() };
    let step = STEP.replace("$last_term", &last_row(LAST_TERM));
    let step = |number: &str, at: &str| step.replace("$spread", number).replace("(k + $next)", at);
    let together = 16 / bytes(element);
    let outdented = |text: String| -> String {
        text.lines()
            .map(|line| format!("{}\n", line.strip_prefix("    ").unwrap_or(line)))
            .collect()
    };
    let first = (1..together).map(|k| step(&spread(k), &format!("{k}U"))).collect();
    let group: String = (0..together)
        .map(|k| step(&spread(k), &if k == 0 { "k".to_owned() } else { format!("(k + {k}U)") }))
        .collect();
    let last = (inner - inner % together..inner)
        .map(|k| step(&alike(k, together), &format!("{k}U")))
        .collect();
    COLUMN
        .replace("$spread_0", &spread(0))
        .replace("$first_group", &outdented(first))
        .replace("$last_row", &last_row(ADD_LAST))
        .replace("$last_first", &last_row(LAST_FIRST))
        .replace("$last_stored", &last_row(LAST_STORED))
        .replace("$last", &outdented(last))
        .replace("$group", &group)
}

fn values(element: Float, sizes: Sizes, shares: bool) -> Vec<(&'static str, String)> {
    let right = |k: &str, column: &str| {
        let parts = [times(sizes.right.0, k), times(sizes.right.1, column)];
        parts.join(" + ")
    };
    let unrolled = match sizes.inner * sizes.columns <= HELD_UNROLLED {
        true => sizes.columns,
        false => 1,
    };
    let terms = if sizes.inner <= COLUMN_UNROLLED { sizes.inner } else { 1 };
    let in_turn = match (IN_TURN_FROM..=COLUMN_UNROLLED).contains(&sizes.inner) {
        true => IN_TURN,
        false => "",
    };
    let mut values = numbers(element);
    values.extend([
        ("rows", format!("{}U", sizes.rows)),
        ("inner", format!("{}U", sizes.inner)),
        ("columns", format!("{}U", sizes.columns)),
        ("first_rows", rows_of(sizes, None)),
        ("next_rows", rows_of(sizes, Some("k"))),
        ("first_number", times(sizes.right.1, "column")),
        ("next_number", right("k", "column")),
        ("next_a", times(sizes.left.1, "k")),
        ("next_b", times(sizes.right.0, "k")),
        ("held_first", times(sizes.right.1, "column")),
        ("held_next", right("k", "column")),
        ("top", times(sizes.left.0, "top")),
        ("at_end", times(sizes.left.0, "END")),
        ("bottom", format!("{}U", sizes.left.0 * (sizes.rows - 1))),
        ("at_column", times(sizes.right.1, "column")),
        ("at_whole", times(sizes.right.1, "whole")),
        ("at_first", times(sizes.right.1, "first")),
        ("unrolled", unrolled.to_string()),
        ("terms", terms.to_string()),
        ("in_turn", in_turn.to_owned()),
        ("apart", format!("{}U", sizes.left.0)),
        ("bytes", bytes(element).to_string()),
        ("begin", if shares { "from * columns" } else { "0U" }.to_owned()),
        ("apart_columns", if shares { "apart * columns" } else { "columns" }.to_owned()),
        ("if_left", if shares { "(left > 0U) && (from == 0U)" } else { "left > 0U" }.to_owned()),
        ("begin_alone", if shares { "from * LAST_ROW_COLUMNS" } else { "0U" }.to_owned()),
        (
            "apart_alone",
            if shares { "apart * LAST_ROW_COLUMNS" } else { "LAST_ROW_COLUMNS" }.to_owned(),
        ),
        (
            "shared",
            if shares { ", const uint32_t from, const uint32_t apart" } else { "" }.to_owned(),
        ),
        ("share", if shares { ", from, apart" } else { "" }.to_owned()),
        ("first_column", if shares { "from" } else { "0U" }.to_owned()),
        ("next_column", if shares { "column += apart" } else { "column++" }.to_owned()),
    ]);
    values
}

/// Returns a vector of rows of the left factor for a term.
fn rows_of(sizes: Sizes, term: Option<&str>) -> String {
    let at = times(sizes.left.0, "OFFSET(vector)");
    let at = match term {
        Some(term) => format!("{} + {at}", times(sizes.left.1, term)),
        None => at,
    };
    match sizes.left.0 {
        1 => format!("*(const lanes_t *)&a[{at}]"),
        _ => format!("gather(&a[{at}])"),
    }
}

/// Returns the fastest plan. If registers hold the whole left factor, it is loaded once. If broadcasts are slow,
/// columns are computed; otherwise blocks. Columns of wider vectors take fewer instructions than blocks, but up to 1.7
/// times their time, since they load the left factor again for each.
fn plan(target: &Target, element: Float, sizes: Sizes, tuning: &Tuning) -> Option<Plan> {
    let lies_in_columns = sizes.left.0 == 1;
    // The widest vectors that a column fills.
    let mut lanes = target.widest / bytes(element);
    while lanes > sizes.rows && lanes * bytes(element) > 16 {
        lanes /= 2;
    }
    let vectors = sizes.rows.div_ceil(lanes);
    let fits = lanes <= sizes.rows && lies_in_columns && sizes.columns > 1 && !target.single;
    if fits && target.spread < 8 && vectors * (sizes.inner + 1) + 2 <= target.registers {
        return Some(Plan { lanes, down: vectors, form: Form::Held });
    }
    let spreads = target.spread == 8 && sizes.right.0 == 1 && sizes.inner >= lanes;
    if fits && spreads && tuning.mode == Mode::Exact {
        let down = vectors.div_ceil(vectors.div_ceil(COLUMN_DOWN));
        let beside = beside::most(element, down, sizes.columns, target.registers);
        // Of `f32` the last row by numbers took more.
        let last_row = sizes.rows % lanes == 1 && element == Float::F64 && beside == 1;
        let down = if last_row && vectors <= COLUMN_DOWN + 1 { sizes.rows / lanes } else { down };
        return Some(Plan { lanes, down, form: Form::Columns(beside) });
    }
    best(target, element, sizes, tuning.code_bytes)
}

/// Returns the plan with the bands that need the fewest instructions.
fn best(target: &Target, element: Float, sizes: Sizes, code_bytes: u32) -> Option<Plan> {
    let widths = [64, 32, 16].into_iter().filter(|width| *width <= target.widest);
    let lanes = widths.map(|width| width / bytes(element)).filter(|lanes| *lanes <= sizes.rows);
    let plans = lanes.filter_map(|lanes| {
        let (cost, bands) = bands::best(target, lanes, sizes, code_bytes)?;
        Some((cost, Plan { lanes, down: bands.first.down, form: Form::Blocks(bands) }))
    });
    plans.min_by_key(|(cost, _)| *cost).map(|(_, plan)| plan)
}

#[cfg(test)]
pub(super) mod tests {
    use super::{TARGETS, Target};

    /// Returns the targets AVX-512 and AVX.
    pub fn avx() -> [Target; 2] {
        let [wide, avx, _, _] = TARGETS;
        [wide, avx]
    }
}
