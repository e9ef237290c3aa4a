//! Cholesky's factorisation and the solves with it.
//!
//! Each element sees nalgebra's operations in nalgebra's order: the columns on its left ascending, each as
//! `a_ij - l_jk * l_ik`, then the division by the root of its column's diagonal.
//!
//! A factor in place of the matrix, or beside it: a small one is then read from where the matrix lies and written once, since a
//! copy in wide vectors that is read by narrow ones is waited for.
//!
//! Small matrices are written out ([`written_out`]), larger ones go in tiles of four by four ([`tiles`]), which take less from
//! eight rows on where there are vectors and from ten on where there are none; in loops where there is no room for either.

mod tiles;
mod written_out;

use bessemer_ir::{Kernel, KernelRoutine};

use super::Source;

/// From this size on, a factorisation goes in tiles; and where there are vectors, from the other one.
const TILES: u32 = 10;
const TILES_OF_VECTORS: u32 = 8;

/// Bytes of code of a factorisation in tiles.
const TILED_BYTES: u32 = 1536;

/// Up to this size, the substitutions gain by being written out.
pub(super) const SUBSTITUTIONS: u32 = 20;

/// The C of a factorisation in so many bytes of code.
pub(super) fn factor(kernel: &Kernel, size: u32, code_bytes: u32) -> Source {
    match size {
        TILES_OF_VECTORS..TILES if factor_bytes(size) <= code_bytes => {
            tiles::factor_with_vectors(kernel, size, &written_out::factor(kernel, size).body)
        }
        ..TILES if factor_bytes(size) <= code_bytes => written_out::factor(kernel, size),
        4.. if TILED_BYTES <= code_bytes => tiles::factor(kernel, size),
        _ => tiles::loops(kernel, size),
    }
}

/// The C of a factorisation in loops.
pub(super) fn loops(kernel: &Kernel) -> Source {
    tiles::loops(kernel, kernel.dims[0])
}

/// Returns true if the matrix stays, and the factor is the result.
fn is_beside(kernel: &Kernel) -> bool {
    kernel.routine == KernelRoutine::CholeskyLower
}

/// Code that fills the result if there is no factor.
const SPOIL: &str = "\
/* There is no factor: NaN in the lower triangle. */
static bool spoil($real *a)
{
    for (uint32_t column = 0U; column < $n; column++) {
        for (uint32_t row = column; row < $n; row++) {
            a[row + $n * column] = $nan;
        }
    }
    return false;
}
";

/// The function that leaves it; of a factor beside the matrix nothing more is said.
fn spoil(kernel: &Kernel) -> String {
    match is_beside(kernel) {
        true => SPOIL.replace("bool", "void").replace("    return false;\n", ""),
        false => SPOIL.to_owned(),
    }
}

/// The C of the solves with its factor, written out.
pub(super) fn solve(kernel: &Kernel, size: u32, columns: u32) -> Source {
    written_out::solve(kernel, size, columns)
}

/// Returns the code size of an unrolled factorisation, four bytes an instruction. A multiplication takes three
/// instructions; an element takes its load, its store and a share of its division.
fn factor_bytes(size: u32) -> u32 {
    2 * size * size * size + 22 * size * size
}

/// The code of the substitutions: a load and a multiplication each way for an element.
pub(super) fn solve_bytes(size: u32) -> u32 {
    12 * size * size + 80
}
