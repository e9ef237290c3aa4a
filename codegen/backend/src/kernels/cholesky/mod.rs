//! Cholesky's factorisation and the solves with it.
//!
//! Each element undergoes nalgebra's operations in nalgebra's order: the columns on its left in ascending order, each
//! as `a_ij - l_jk * l_ik`, then the division by the root of its column's diagonal.
//!
//! The factor replaces the matrix, or is written beside it. A small factor beside it is read from the matrix and
//! written once: a copy by wide vectors would stall the narrow loads that read it.
//!
//! Small matrices are written out ([`written_out`]). Larger ones use tiles of four by four ([`tiles`]), which are
//! faster from eight rows on with vectors and from ten on without. If neither fits the code size, loops are used.

mod tiles;
mod written_out;

use bessemer_ir::{Kernel, KernelRoutine};

use super::Source;

/// Smallest size for which a factorisation uses tiles; the second is with vectors.
const TILES: u32 = 10;
const TILES_OF_VECTORS: u32 = 8;

/// Code size of a factorisation in tiles, bytes.
const TILED_BYTES: u32 = 1536;

/// Largest size for which the substitutions are written out.
pub(super) const SUBSTITUTIONS: u32 = 20;

/// Returns the C of a factorisation that fits into `code_bytes`.
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

/// Returns the C of a factorisation in loops.
pub(super) fn loops(kernel: &Kernel) -> Source {
    tiles::loops(kernel, kernel.dims[0])
}

/// Returns true if the factor is the result and the matrix is unchanged.
fn is_beside(kernel: &Kernel) -> bool {
    kernel.routine == KernelRoutine::CholeskyLower
}

/// Code that fills the result with NaN if there is no factor.
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

/// Returns the function for a matrix without a factor. If the factor is the result, it returns nothing.
fn spoil(kernel: &Kernel) -> String {
    match is_beside(kernel) {
        true => SPOIL.replace("bool", "void").replace("    return false;\n", ""),
        false => SPOIL.to_owned(),
    }
}

/// Returns the C of the solves with a factor, written out.
pub(super) fn solve(kernel: &Kernel, size: u32, columns: u32) -> Source {
    written_out::solve(kernel, size, columns)
}

/// Returns the code size of an unrolled factorisation, four bytes an instruction. A multiplication takes three
/// instructions; an element takes its load, its store and a share of its division.
fn factor_bytes(size: u32) -> u32 {
    2 * size * size * size + 22 * size * size
}

/// Returns the code size of the substitutions, bytes: a load and a multiplication per element and direction.
pub(super) fn solve_bytes(size: u32) -> u32 {
    12 * size * size + 80
}
