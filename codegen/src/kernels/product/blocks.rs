//! The C of a product that goes by blocks: as much of it as its targets' bands need.

use super::Sizes;
use super::bands::{self, Band, Bands};
use crate::kernels::text::without;

const BLOCK: &str = include_str!("block.c");
const BLOCKS: &str = include_str!("blocks.c");
const LAST_ROW: &str = include_str!("last_row.c");

/// The terms of a block, all written out.
const TERMS: &str = "\
#pragma GCC unroll 32
    for (uint32_t k = 1U; k < $inner; k++) {
        add_term(a, b, k, sums, across, down);
    }
";

/// So many at a time, and before them what is left of them.
const TURNS: &str = "    \
    for (uint32_t k = FIRST_TERMS; k < $inner; k += TERMS) {
#pragma GCC unroll 32
        for (uint32_t next = 0U; next < TERMS; next++) {
            add_term(a, b, k + next, sums, across, down);
        }
    }
";
const FIRST_TERMS: &str = "\
#pragma GCC unroll 32
    for (uint32_t k = 1U; k < FIRST_TERMS; k++) {
        add_term(a, b, k, sums, across, down);
    }
";

/// The columns that are left beside the blocks of a band.
const LEFT: &str = "    \
    const uint32_t left = $columns % across;
    const uint32_t whole = $columns - left;
";
const BESIDE: &str = "    \
    if ($if_left) {
        block(a, &b[$at_whole], &result[$rows * whole], left, down);
    }
";

/// What the bands of a product's targets need.
#[derive(Clone, Copy)]
pub(super) struct Blocks {
    sizes: Sizes,
    /// Whether a last band is another.
    last: bool,
    /// Whether a last row goes by numbers.
    alone: bool,
    /// Whether terms go in turns, and some before them.
    turns: bool,
    first_terms: bool,
    /// Whether columns are left beside the blocks.
    left: bool,
}

impl Blocks {
    /// What these bands need.
    pub fn new(sizes: Sizes, bands: &[Bands]) -> Blocks {
        let any = |wanted: fn(Sizes, &Bands) -> bool| bands.iter().any(|it| wanted(sizes, it));
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
        }
    }

    /// What a target defines.
    pub fn defines(&self, bands: &Bands) -> String {
        let Bands { first, last, alone, terms } = bands;
        let mut text = format!("#define ACROSS {}U\n", first.across);
        if let Some(Band { down, across }) = last {
            text += &format!("#define LAST_DOWN {down}U\n#define LAST_ACROSS {across}U\n");
        }
        if let Some(alone) = alone {
            text += &format!("#define ALONE {alone}U\n");
        }
        if self.turns {
            text += &format!("#define TERMS {terms}U\n");
        }
        if self.turns && self.first_terms {
            text += &format!("#define FIRST_TERMS {}U\n", first_terms(self.sizes, bands));
        }
        text
    }

    /// What stands before the function.
    pub fn before(&self) -> String {
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
        if self.alone {
            let unrolled = match self.sizes.inner <= bands::WRITTEN_OUT {
                true => "#pragma GCC unroll 32\n",
                false => "",
            };
            let row = LAST_ROW.replace("$alone_unrolled", unrolled);
            text += &format!("\n#if defined(ALONE)\n{row}#endif\n");
        }
        format!("\n#if defined(ACROSS)\n{text}#endif\n")
    }

    /// What stands in the function.
    pub fn body(&self) -> String {
        let mut body = BLOCKS.to_owned();
        for (name, used) in [("LAST_DOWN", self.last), ("ALONE", self.alone)] {
            if !used {
                body = without(&body, name);
            }
        }
        body
    }

    /// The values of the text: where bands end, as numbers, or as macros where targets differ.
    pub fn values(&self) -> [(&'static str, String); 4] {
        let rows = format!("{}U", self.sizes.rows);
        let banded = if self.alone { "BANDED".to_owned() } else { rows.clone() };
        let end = if self.last { "END".to_owned() } else { banded.clone() };
        let mut text = String::new();
        if self.alone {
            text += &format!(
                "/* The rows of all bands. */\n#if defined(ALONE)\n#define BANDED {}U\n#else\n\
                 #define BANDED {rows}\n#endif\n\n",
                self.sizes.rows - 1
            );
        }
        if self.last {
            text += &format!(
                "/* Where the last band begins, if it is another. */\n#if defined(LAST_DOWN)\n\
                 #define END ({banded} - LANES * LAST_DOWN)\n#else\n#define END {banded}\n#endif\n\n"
            );
        }
        let widest = format!("{}U", bands::MOST);
        [("banded", banded), ("end", end), ("ends", text), ("widest", widest)]
    }
}

/// The terms before the turns, the first among them.
fn first_terms(sizes: Sizes, bands: &Bands) -> u32 {
    1 + sizes.inner.saturating_sub(1) % bands.terms
}
