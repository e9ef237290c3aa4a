//! Inverse of a 4×4 matrix: sixteen cofactors, each a sum of six products in nalgebra's order.
//!
//! With vectors, the cofactors of several columns are computed at once, as many as a vector has lanes. Each lane is a
//! cofactor, and takes its three elements of each of the three other rows. The sign of the first factor in each
//! product makes all of them one formula: `-p + q` has the same order as `q - p`.

use std::fmt::Write as _;

use bessemer_ir::Float;
use bessemer_ir::kernel::{COFACTORS, Products};

/// Code for rows in vectors of four, and for the cofactors from them.
const OF_FOUR: &str = include_str!("rows_of_four.c");
const IN_FOURS: &str = include_str!("inverse_of_four.c");

/// Other three rows for the cofactors of each column.
const ROWS: [(&str, [usize; 4]); 3] =
    [("top", [1, 0, 0, 0]), ("mid", [2, 2, 1, 1]), ("low", [3, 3, 3, 2])];

/// Elements of a row that the lanes of a column use.
const ELEMENTS: [(&str, [usize; 4]); 3] =
    [("a", [1, 0, 0, 0]), ("b", [2, 2, 1, 1]), ("c", [3, 3, 3, 2])];

const REST_OF_FOUR: &str = "\
const $real determinant =
    m0 * cofactor_0 + m1 * cofactor_4 + m2 * cofactor_8 + m3 * cofactor_12;
if (determinant == $zero) {
    return false;
}
const $real reciprocal = $one / determinant;
";

/// Returns the template of the body; each variant follows the macro of the target that it needs.
pub(super) fn four(element: Float) -> String {
    let fours = || format!("{OF_FOUR}{IN_FOURS}");
    let forms = match element {
        Float::F64 => vec![("__AVX512F__", wide(8)), ("__SSE2__", fours())],
        Float::F32 => {
            vec![("__AVX512F__", wide(16)), ("__AVX2__", in_pairs()), ("__SSE2__", fours())]
        }
    };
    let mut text = String::new();
    for (index, (needed, form)) in forms.iter().enumerate() {
        let word = if index == 0 { "if" } else { "elif" };
        let _ = write!(text, "#{word} {}\n/* {HOW} */\n{form}", super::inverse::vectors(needed));
    }
    text + "#else\n" + &by_numbers() + "#endif\n"
}

/// Returns the variant with the whole matrix in one or two vectors.
fn wide(lanes: usize) -> String {
    let mut text = lanes_type(lanes);
    text += &loads(lanes);
    text += &signs(lanes);
    let sources = sources(lanes);
    for block in 0..16 / lanes {
        for (row, rows) in ROWS {
            for (letter, elements) in ELEMENTS {
                let from = columns(block, lanes)
                    .flat_map(|column| elements.map(|it| 4 * it + rows[column]));
                let picked = shuffle(sources, from);
                let _ =
                    writeln!(text, "const lanes_t {letter}_{row}{block} = {picked}{};", sign(row));
            }
        }
        text += &cofactors(block);
        let first = shuffle([sources[0]; 2], columns(block, lanes).flat_map(|column| [column; 4]));
        let _ = writeln!(text, "const lanes_t terms{block} = {first} * cofactors{block};");
    }
    let term = |column: usize| format!("terms{}[{}]", 4 * column / lanes, 4 * column % lanes);
    text + &end(lanes, term)
}

/// Returns the variant with two columns in each vector of eight, for AVX2. It first places rows side by side, so that
/// later shuffles stay within halves.
fn in_pairs() -> String {
    const LANES: usize = 8;
    let mut text = lanes_type(LANES) + &loads(LANES) + &signs(LANES);
    for block in 0..2 {
        for (row, rows) in ROWS {
            let both =
                columns(block, LANES).flat_map(|column| [0, 4, 8, 12].map(|it| it + rows[column]));
            let name = format!("{row}{block}");
            let _ = writeln!(text, "const lanes_t {name} = {};", shuffle(["left", "right"], both));
            for (letter, elements) in ELEMENTS {
                let from = elements.into_iter().chain(elements.map(|it| 4 + it));
                let picked = shuffle([name.as_str(); 2], from);
                let _ = writeln!(text, "const lanes_t {letter}_{name} = {picked}{};", sign(row));
            }
        }
        text += &cofactors(block);
    }
    text + &end(LANES, |column| {
        format!("left[{column}] * cofactors{}[{}]", column / 2, 4 * (column % 2))
    })
}

/// Comment of a variant with vectors.
const HOW: &str = "\
Cofactors at once: each is a sum of products of the three rows without an own one, and each lane takes its three
   elements of a row. The signs go to the first factors: all that follows is as it would be without.";

/// Returns the columns of the cofactors in a block.
fn columns(block: usize, lanes: usize) -> std::ops::Range<usize> {
    lanes / 4 * block..lanes / 4 * (block + 1)
}

fn lanes_type(lanes: usize) -> String {
    format!(
        "typedef $real lanes_t __attribute__((vector_size({lanes} * $bytes), aligned($bytes), may_alias));\n"
    )
}

/// Returns the names of the matrix' elements, in one vector or in two.
fn sources(lanes: usize) -> [&'static str; 2] {
    if lanes == 16 { ["m", "m"] } else { ["left", "right"] }
}

fn loads(lanes: usize) -> String {
    let load = |(index, name): (usize, &str)| {
        format!("const lanes_t {name} = *(const lanes_t *)&a[{}];\n", lanes * index)
    };
    sources(lanes).into_iter().take(16 / lanes).enumerate().map(load).collect()
}

/// Returns the sign factor of the elements that come first in their products.
fn sign(row: &str) -> &'static str {
    if row == "top" { " * signs" } else { "" }
}

/// Returns the signs of two columns, repeated.
fn signs(lanes: usize) -> String {
    let two = ["$one", "-$one", "$one", "-$one", "-$one", "$one", "-$one", "$one"];
    let signs: Vec<&str> = two.into_iter().cycle().take(lanes).collect();
    format!("const lanes_t signs = {{{}}};\n", signs.join(", "))
}

fn shuffle([one, other]: [&str; 2], from: impl Iterator<Item = usize>) -> String {
    let from: Vec<String> = from.map(|index| index.to_string()).collect();
    format!("__builtin_shufflevector({one}, {other}, {})", from.join(", "))
}

fn cofactors(block: usize) -> String {
    let product = |one: &str, mid: &str, low: &str| {
        let (x, y, z) = (&one[..1], &mid[..1], &low[..1]);
        format!("{x}_top{block} * {y}{}{block} * {z}{}{block}", &mid[1..], &low[1..])
    };
    format!(
        "const lanes_t cofactors{block} = {} - {}\n    - {} + {}\n    + {} - {};\n",
        product("a", "b_mid", "c_low"),
        product("a", "b_low", "c_mid"),
        product("b", "a_mid", "c_low"),
        product("b", "a_low", "c_mid"),
        product("c", "a_mid", "b_low"),
        product("c", "a_low", "b_mid"),
    )
}

/// Returns the determinant as a sum of these terms, and the division by it.
fn end(lanes: usize, term: impl Fn(usize) -> String) -> String {
    let terms: Vec<String> = (0..4).map(term).collect();
    let mut text = format!(
        "const $real determinant = {};\nif (determinant == $zero) {{\n    return false;\n}}\n\
         const $real reciprocal = $one / determinant;\n",
        terms.join(" + ")
    );
    for block in 0..16 / lanes {
        let _ =
            writeln!(text, "*(lanes_t *)&a[{}] = cofactors{block} * reciprocal;", lanes * block);
    }
    text + "return true;\n"
}

/// Returns the variant with scalars.
fn by_numbers() -> String {
    let mut text: String =
        (0..16).map(|index| format!("const $real m{index} = a[{index}];\n")).collect();
    let (first, rest) = COFACTORS.split_at(4);
    for (element, products) in first {
        text.push_str(&format!("const $real cofactor_{element} = {};\n", sum(products)));
    }
    text.push_str(REST_OF_FOUR);
    for (element, _) in first {
        text.push_str(&format!("a[{element}] = cofactor_{element} * reciprocal;\n"));
    }
    for (element, products) in rest {
        text.push_str(&format!("a[{element}] = ({}) * reciprocal;\n", sum(products)));
    }
    text + "return true;\n"
}

/// Returns a sum of six products, two on each line.
fn sum(products: &Products) -> String {
    let mut text = String::new();
    for (index, (sign, [x, y, z])) in products.iter().enumerate() {
        text.push_str(match (index, sign) {
            (0, 1) => "",
            (0, _) => "-",
            (2 | 4, 1) => "\n    + ",
            (2 | 4, _) => "\n    - ",
            (_, 1) => " + ",
            _ => " - ",
        });
        text.push_str(&format!("m{x} * m{y} * m{z}"));
    }
    text
}
