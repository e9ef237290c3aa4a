//! C of a product in blocks, with only the parts that its targets' bands need.

use super::Sizes;
use super::bands::{self, Band, Bands};
use crate::kernels::text::without;

const BLOCK: &str = include_str!("block.c");
const BLOCKS: &str = include_str!("blocks.c");
const LAST_ROW: &str = include_str!("last_row.c");

/// Template for a result of one column.
const ROWS: &str = include_str!("rows.c");
const LAST_NUMBER: &str = include_str!("last_number.c");

/// Code of a block's terms, all written out.
const TERMS: &str = "\
#pragma GCC unroll 32
    for (uint32_t k = 1U; k < $inner; k++) {
        add_term(a, b, k, sums, columns, vectors);
    }
";

/// Code of a loop over a constant number of terms, and of the remaining terms before it.
const TURNS: &str = "    \
    for (uint32_t k = FIRST_TERMS; k < $inner; k += TERMS) {
#pragma GCC unroll 32
        for (uint32_t next = 0U; next < TERMS; next++) {
            add_term(a, b, k + next, sums, columns, vectors);
        }
    }
";
const FIRST_TERMS: &str = "\
#pragma GCC unroll 32
    for (uint32_t k = 1U; k < FIRST_TERMS; k++) {
        add_term(a, b, k, sums, columns, vectors);
    }
";

/// Code that computes all blocks if a single band contains all rows.
const ONE_BAND: &str = "band(a, b, result, COLUMNS, VECTORS$share);\n";

/// Code that computes the last row without vectors.
const GIVE_LAST_ROW: &str = "\
for (uint32_t column = $begin_alone; column < $columns; column += $apart_alone) {
    const uint32_t first = (column + LAST_ROW_COLUMNS <= $columns) ? column : $columns - LAST_ROW_COLUMNS;
    last_row(&a[$bottom], &b[$at_first], &result[$rows - 1U + $rows * first]);
}
";
const GIVE_LAST_NUMBER: &str = "result[$rows - 1U] = last_number(&a[$bottom], b);\n";

/// Code of the columns that remain after the blocks of a band.
const LEFT: &str = "    \
    const uint32_t left = $columns % columns;
    const uint32_t whole = $columns - left;
";
const BESIDE: &str = "    \
    if ($if_left) {
        block(a, &b[$at_whole], &result[$rows * whole], left, vectors);
    }
";

/// Requirements of the bands of a product's targets.
#[derive(Clone, Copy)]
pub(super) struct Blocks {
    sizes: Sizes,
    /// True if a last band differs.
    last: bool,
    /// True if a last row uses scalars.
    alone: bool,
    /// True if the terms of a sum are a loop, which some first terms may precede.
    turns: bool,
    first_terms: bool,
    /// True if columns remain after the blocks.
    left: bool,
    /// Columns of the widest block.
    widest: u32,
    /// True if a single band contains all rows.
    one_band: bool,
    /// Number of terms that a pass may have written out.
    terms: u32,
}

impl Blocks {
    /// Returns the requirements of these bands, for vectors of these numbers of lanes.
    pub fn new(sizes: Sizes, plans: &[(u32, Bands)]) -> Blocks {
        let bands: Vec<Bands> = plans.iter().map(|(_, bands)| *bands).collect();
        let any = |wanted: fn(Sizes, &Bands) -> bool| bands.iter().any(|it| wanted(sizes, it));
        let all = || bands.iter().flat_map(|it| std::iter::once(it.first).chain(it.last));
        Blocks {
            sizes,
            last: any(|_, bands| bands.last.is_some()),
            alone: any(|_, bands| bands.alone.is_some()),
            turns: any(|sizes, bands| 1 + bands.terms < sizes.inner),
            first_terms: any(|sizes, bands| first_terms(sizes, bands) > 1),
            left: any(|sizes, bands| {
                let mut all = std::iter::once(bands.first).chain(bands.last);
                all.any(|band| !sizes.columns.is_multiple_of(band.across))
            }),
            widest: all().map(|band| band.across).max().unwrap_or(1),
            one_band: plans.iter().all(|(lanes, bands)| {
                bands.last.is_none()
                    && bands.alone.is_none()
                    && lanes * bands.first.down >= sizes.rows
            }),
            terms: bands.iter().map(|bands| bands.terms).min().unwrap_or(1),
        }
    }

    /// Returns true if the result is one column.
    fn is_column(&self) -> bool {
        self.sizes.columns == 1
    }

    /// Returns the preprocessor condition of targets with blocks.
    pub fn condition(&self) -> &'static str {
        // A column goes by nothing else.
        if self.is_column() { "LANES" } else { "COLUMNS" }
    }

    /// Returns the macros that a target defines.
    pub fn defines(&self, bands: &Bands) -> String {
        let Bands { first, last, alone, terms } = bands;
        let column = self.is_column();
        let mut text = String::new();
        if !column {
            text += &format!("#define COLUMNS {}U\n", first.across);
        }
        if let Some(Band { down, across }) = last {
            text += &format!("#define LAST_VECTORS {down}U\n");
            text +=
                &if column { String::new() } else { format!("#define LAST_COLUMNS {across}U\n") };
        }
        if let Some(alone) = alone {
            text += &format!("#define LAST_ROW_COLUMNS {alone}U\n");
        }
        if column {
            return text;
        }
        if self.turns {
            text += &format!("#define TERMS {terms}U\n");
        }
        if self.turns && self.first_terms {
            text += &format!("#define FIRST_TERMS {}U\n", first_terms(self.sizes, bands));
        }
        text
    }

    /// Returns the code before the function.
    pub fn before(&self) -> String {
        let unrolled = match self.sizes.inner <= bands::WRITTEN_OUT {
            true => "#pragma GCC unroll 32\n",
            false => "",
        };
        let alone = |text: &str| match self.alone {
            true => format!(
                "\n#if defined(LAST_ROW_COLUMNS)\n{}#endif\n",
                text.replace("$alone_unrolled", unrolled)
            ),
            false => String::new(),
        };
        if self.is_column() {
            return format!("\n{ROWS}{}", alone(LAST_NUMBER));
        }
        let terms = match (self.turns, self.first_terms) {
            (false, _) => TERMS.to_owned(),
            (true, false) => TURNS.replace("FIRST_TERMS", "1U"),
            (true, true) => format!("{FIRST_TERMS}{TURNS}"),
        };
        let mut text = BLOCK.replace("$terms_in_order", &terms);
        text = match self.left {
            true => text.replace("$left_columns", LEFT).replace("$beside", BESIDE),
            false => {
                let text = text.replace("$left_columns", "").replace("$beside", "");
                text.replace("column < whole", "column < $columns")
                    .replace(", and one of those that are left", "")
            }
        };
        text += &alone(LAST_ROW);
        format!("\n#if defined(COLUMNS)\n{text}#endif\n")
    }

    /// Returns the body of the function.
    pub fn body(&self) -> String {
        let alone = if self.is_column() { GIVE_LAST_NUMBER } else { GIVE_LAST_ROW };
        let mut body = match self.one_band {
            true => ONE_BAND.to_owned(),
            false => BLOCKS.replace("$last_alone", alone),
        };
        if self.is_column() {
            body = body.replace("LAST_COLUMNS, ", "").replace("COLUMNS, ", "");
        }
        for (name, used) in [("LAST_VECTORS", self.last), ("LAST_ROW_COLUMNS", self.alone)] {
            if !used {
                body = without(&body, name);
            }
        }
        body
    }

    /// Returns the template's values: the ends of bands, as numbers, or as macros if targets differ.
    pub fn values(&self) -> [(&'static str, String); 5] {
        let rows = format!("{}U", self.sizes.rows);
        let banded = if self.alone { "BANDED".to_owned() } else { rows.clone() };
        let end = if self.last { "END".to_owned() } else { banded.clone() };
        let mut text = String::new();
        if self.alone {
            text += &format!(
                "/* The rows of all bands. */\n#if defined(LAST_ROW_COLUMNS)\n#define BANDED {}U\n#else\n\
                 #define BANDED {rows}\n#endif\n\n",
                self.sizes.rows - 1
            );
        }
        if self.last {
            text += &format!(
                "/* Where the last band begins, if it is another. */\n#if defined(LAST_VECTORS)\n\
                 #define END ({banded} - LANES * LAST_VECTORS)\n#else\n#define END {banded}\n#endif\n\n"
            );
        }
        let widest = format!("{}U", self.widest);
        let terms = match self.terms {
            1 => String::new(),
            terms => format!("#pragma GCC unroll {terms}\n"),
        };
        [
            ("banded", banded),
            ("end", end),
            ("ends", text),
            ("widest", widest),
            ("unrolled_terms", terms),
        ]
    }
}

/// Returns the number of terms before the loop, including the first.
fn first_terms(sizes: Sizes, bands: &Bands) -> u32 {
    1 + sizes.inner.saturating_sub(1) % bands.terms
}
