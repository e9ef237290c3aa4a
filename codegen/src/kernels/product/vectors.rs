//! Blocks of vectors of rows by columns, where gcc or clang have vectors.
//!
//! The last vector of a block, and the last block, may overlap the one before: elements are then computed
//! twice, to the same bits.

use bessemer_ir::Float;

use super::{Sizes, times};
use crate::kernels::Mode;
use crate::kernels::text::{FUSED, bytes, fill, fused, numbers};

/// A kind of vectors.
struct Target {
    /// What says that they are there.
    condition: &'static str,
    /// What else to say about them.
    text: &'static str,
    /// Whether they are for `f32` alone.
    single: bool,
    /// Bytes of the widest.
    widest: u32,
    /// How many registers.
    registers: u32,
    /// Instructions to multiply and add.
    step: u32,
    /// Quarters of an instruction to have a number in each lane.
    spread: u32,
}

/// The widest first. NEON flushes subnormals to zero, so it is there for those only who say that they do
/// not mind; its multiplication with addition rounds twice, as C's.
const TARGETS: [Target; 4] = [
    Target {
        condition: "defined(__AVX512F__)",
        text: "",
        single: false,
        widest: 64,
        registers: 32,
        step: 2,
        spread: 2,
    },
    Target {
        condition: "defined(__AVX__)",
        text: "",
        single: false,
        widest: 32,
        registers: 16,
        step: 2,
        spread: 4,
    },
    Target {
        condition: "defined(__SSE2__)",
        text: "",
        single: false,
        widest: 16,
        registers: 16,
        step: 3,
        spread: 8,
    },
    Target {
        condition: "defined(__ARM_NEON) && defined(BESSEMER_NEON_F32)",
        text: NEON,
        single: true,
        widest: 16,
        registers: 16,
        step: 1,
        spread: 4,
    },
];

const TIMES: &str = "#define TIMES(rows, number) ((rows) * (number))\n";

const NEON: &str = "\
#include <arm_neon.h>
#define TIMES(rows, number) vmulq_n_f32((float32x4_t)(rows), (number))
#define PLUS(sum, rows, number) vmlaq_n_f32((float32x4_t)(sum), (float32x4_t)(rows), (number))
";

/// A block of the result.
#[derive(Clone, Copy, PartialEq)]
struct Block {
    /// Numbers of a vector.
    lanes: u32,
    /// Vectors below one another.
    down: u32,
    /// Columns.
    across: u32,
}

const BLOCK: &str = include_str!("block.c");
/// From more terms than these on the loop over them stays one: gcc, having unrolled it, would load all numbers at
/// once and spill them.
const ROLLED: u32 = 4;
const KEEP_ROLLED: &str = "#pragma GCC unroll 1\n";

const GATHER: &str = include_str!("gather.c");
const LOOPS: &str = include_str!("blocks.c");

/// What each target has, the function of a block, and the loops over blocks; none if there are too few rows.
pub(super) fn source(
    element: Float,
    sizes: Sizes,
    mode: Mode,
    shares: bool,
) -> Option<(String, String, String)> {
    let mut branches: Vec<String> = Vec::new();
    let mut last = None;
    for target in TARGETS.iter().rev() {
        if target.single && element != Float::F32 {
            continue;
        }
        let Some(block) = best(target, element, sizes) else { continue };
        // The same as with narrower vectors: no case of its own.
        if last == Some(block) {
            continue;
        }
        last = (!target.single).then_some(block);
        let Block { lanes, down, across } = block;
        let mut condition = target.condition.to_owned();
        let mut text = target.text.to_owned();
        if mode == Mode::Fast && target.single {
            condition = condition.replace(" && defined(BESSEMER_NEON_F32)", "");
        } else if mode == Mode::Fast {
            let plus = fused(element, lanes * bytes(element), "fmadd", ["number", "rows", "sum"]);
            text += &format!(
                "{FUSED}{TIMES}#define PLUS(sum, rows, number) ((lanes_t){plus})\n#endif\n"
            );
        }
        branches.push(format!(
            "if defined(__GNUC__) && {condition} && !defined(BESSEMER_PLAIN)\n{text}\
             #define LANES {lanes}U\n#define DOWN {down}U\n#define ACROSS {across}U\n",
        ));
    }
    if branches.is_empty() {
        return None;
    }
    branches.reverse();
    let targets = format!("#{}#endif\n", branches.join("#el"));
    let mut values = numbers(element);
    values.extend([
        ("rows", format!("{}U", sizes.rows)),
        ("inner", format!("{}U", sizes.inner)),
        ("columns", format!("{}U", sizes.columns)),
        ("first_rows", rows_of(sizes, None)),
        ("next_rows", rows_of(sizes, Some("k"))),
        ("first_number", times(sizes.right.1, "across")),
        (
            "next_number",
            format!("{} + {}", times(sizes.right.0, "k"), times(sizes.right.1, "across")),
        ),
        ("top", times(sizes.left.0, "top")),
        ("left", times(sizes.right.1, "left")),
        ("rolled", if sizes.inner > ROLLED { KEEP_ROLLED } else { "" }.to_owned()),
        ("apart", format!("{}U", sizes.left.0)),
        ("bytes", bytes(element).to_string()),
        ("begin", if shares { "from * ACROSS" } else { "0U" }.to_owned()),
        ("apart_columns", if shares { "apart * ACROSS" } else { "ACROSS" }.to_owned()),
    ]);
    let block = BLOCK.replace("$gather", if sizes.left.0 == 1 { "" } else { GATHER });
    Some((targets, fill(&block, &values), fill(LOOPS, &values)))
}

/// A vector of rows of the left factor, of a term.
fn rows_of(sizes: Sizes, term: Option<&str>) -> String {
    let at = times(sizes.left.0, "OFFSET(down)");
    let at = match term {
        Some(term) => format!("{} + {at}", times(sizes.left.1, term)),
        None => at,
    };
    match sizes.left.0 {
        1 => format!("*(const lanes_t *)&a[{at}]"),
        _ => format!("gather(&a[{at}])"),
    }
}

/// The block that takes the fewest instructions.
fn best(target: &Target, element: Float, sizes: Sizes) -> Option<Block> {
    let mut found: Option<(u32, Block)> = None;
    let mut bytes_of_vector = target.widest;
    while bytes_of_vector >= 16 {
        let lanes = bytes_of_vector / bytes(element);
        for down in 1..=8 {
            for across in 1..=sizes.columns.min(8) {
                let block = Block { lanes, down, across };
                if block.fits(target, sizes) {
                    let cost = block.cost(target, sizes);
                    if found.is_none_or(|(least, _)| cost < least) {
                        found = Some((cost, block));
                    }
                }
            }
        }
        bytes_of_vector /= 2;
    }
    found.map(|(_, block)| block)
}

impl Block {
    /// Whether it stays in registers, and within the result.
    fn fits(&self, target: &Target, sizes: Sizes) -> bool {
        // Beside the sums: a vector of `a`, a product, and the numbers of `b`.
        let spread = if self.down > 1 { self.across } else { 1 };
        let registers = self.down * self.across + spread + 2;
        self.lanes <= sizes.rows
            && (self.down - 1) * self.lanes < sizes.rows
            && registers <= target.registers
    }

    /// Quarters of instructions, for each k.
    fn cost(&self, target: &Target, sizes: Sizes) -> u32 {
        let blocks =
            sizes.rows.div_ceil(self.lanes * self.down) * sizes.columns.div_ceil(self.across);
        let step = 4 * target.step * self.down * self.across;
        // A vector of numbers that lie apart: a load for each.
        let load = if sizes.left.0 == 1 { 4 } else { 4 * self.lanes };
        blocks * (load * self.down + target.spread * self.across + step + 12)
    }
}
