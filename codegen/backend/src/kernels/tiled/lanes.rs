//! Representation of a panel's row on each target.

use bessemer_ir::Float;

use crate::kernels::Mode;
use crate::kernels::text::{FUSED, bytes, fill, fused, numbers, vectors_if};

/// Vectors of x86-64, the widest first: macro and bytes.
const VECTORS: [(&str, u32); 3] = [("__AVX512F__", 64), ("__AVX__", 32), ("__SSE2__", 16)];

const LANES: &str = include_str!("lanes.c");

/// Code for targets without fused multiply-add.
const MINUS: &str = "\
#if defined(HALF) && !defined(MINUS)
#define MINUS(row, factor, other) ((row) - (factor) * (other))
#endif
";

/// Returns the usable vectors: a panel has two of them, and is not wider than the matrix.
fn vectors(element: Float, columns: u32) -> impl Iterator<Item = (&'static str, u32)> {
    let fits = move |&(_, vector): &(&str, u32)| 2 * vector / bytes(element) <= columns;
    VECTORS.into_iter().filter(fits)
}

/// Returns the columns of the widest panel on any target.
pub fn widest(element: Float, columns: u32) -> u32 {
    vectors(element, columns)
        .map(|(_, vector)| 2 * vector / bytes(element))
        .max()
        .unwrap_or(4)
        .max(4)
}

/// Returns the numbers in a cache line.
pub fn line(element: Float) -> u32 {
    64 / bytes(element)
}

/// Width of the vectors for which rows in place are faster, bytes: AVX's.
const ORDERED: u32 = 32;

/// Returns the columns of a panel with rows in place.
pub fn ordered_width(element: Float) -> u32 {
    2 * ORDERED / bytes(element)
}

/// Returns the rows that are processed together in a column with rows in place: four vectors.
pub fn ordered_group(element: Float) -> u32 {
    4 * ORDERED / bytes(element)
}

/// Returns types and operations of rows, for every target; `ordered` is true if the kernel has a variant with rows in
/// place.
pub fn text(element: Float, columns: u32, mode: Mode, ordered: bool) -> String {
    let mut values = numbers(element);
    let targets = targets(element, columns, mode, ordered);
    let (targets, step) = match mode {
        Mode::Exact | Mode::Plain => (
            targets,
            [
                ("low", "row.low - factor * other.low"),
                ("high", "row.high - factor * other.high"),
                ("hold", "IN_REGISTERS"),
            ],
        ),
        Mode::Fast => (
            targets + MINUS,
            [
                ("low", "MINUS(row.low, factor, other.low)"),
                ("high", "MINUS(row.high, factor, other.high)"),
                // Else compilers load it again for each fused step, whatever room there is.
                ("hold", "HOLD"),
            ],
        ),
    };
    values.push(("targets", targets));
    values.extend(step.map(|(name, text)| (name, text.to_owned())));
    fill(&fill(LANES, &values), &numbers(element))
}

/// Returns the `#if` for each target, with its definitions.
fn targets(element: Float, columns: u32, mode: Mode, ordered: bool) -> String {
    let mut branches: Vec<(String, String)> = Vec::new();
    for (macro_name, vector) in vectors(element, columns) {
        let lanes = vector / bytes(element);
        let half = vector_type("half_t", vector, bytes(element));
        let mut text = format!("#define WIDTH {}U\n#define HALF {lanes}U\n{half}", 2 * lanes);
        // Sixteen, which a tile fills; AVX-512 has thirty-two, and a fused step needs none for the product.
        text += if vector < 64 && mode == Mode::Exact { "#define FEW_REGISTERS\n" } else { "" };
        if ordered && vector == ORDERED {
            let word = 8 * bytes(element);
            text += &format!(
                "#include <immintrin.h>\n#define ORDERED\ntypedef int{word}_t half_bits_t __attribute__((vector_size({vector})));\n"
            );
        }
        let four = 4 * bytes(element);
        if four <= vector {
            text += &format!("#define QUAD\n{}", vector_type("quad_lanes_t", four, bytes(element)));
        }
        if mode == Mode::Fast {
            let minus = fused(element, vector, "fnmadd", ["factor", "other", "row"]);
            text += &format!("{FUSED}#define MINUS(row, factor, other) ((half_t){minus})\n");
            if ordered && vector == ORDERED {
                let plus = fused(element, vector, "fmadd", ["factor", "other", "row"]);
                text += &format!("#define PLUS(row, factor, other) ((half_t){plus})\n");
            }
            text += "#endif\n";
            // As many sums again as a tile has elements, where there are registers for them.
            text += if vector == 64 { "#define SPLIT\n" } else { "" };
        }
        branches.push((format!("defined({macro_name})"), text));
    }
    // Loads of many numbers at once; arithmetic stays on the VFP, which rounds as C does. clang moves what is in chosen
    // registers out of them and back: its plain form takes less.
    let text = match element {
        Float::F64 => {
            "#include <arm_neon.h>\n#define WIDTH 4U\n#define LOAD_MULTIPLE\n#define WORDS\n\
             typedef int64_t word_t __attribute__((may_alias));\n"
        }
        Float::F32 => "#define WIDTH 4U\n#define LOAD_MULTIPLE\n#define SINGLES\n",
    };
    branches.push(("defined(__ARM_NEON) && !defined(__clang__)".to_owned(), text.to_owned()));
    let mut all = String::new();
    for (index, (condition, text)) in branches.iter().enumerate() {
        let word = if index == 0 { "#if" } else { "#elif" };
        all += &format!("{word} {}\n{text}", vectors_if(condition));
    }
    match branches.is_empty() {
        true => "#define WIDTH 4U\n".to_owned(),
        false => all + "#else\n#define WIDTH 4U\n#endif\n",
    }
}

fn vector_type(name: &str, vector: u32, aligned: u32) -> String {
    format!(
        "typedef $real {name} __attribute__((vector_size({vector}), aligned({aligned}), may_alias));\n"
    )
}
