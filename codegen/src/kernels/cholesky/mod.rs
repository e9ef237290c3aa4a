//! Cholesky's factorisation and the solves with it.
//!
//! Each element sees nalgebra's operations in nalgebra's order: the columns on its left ascending, each as
//! `a_ij - l_jk * l_ik`, then the division by the root of its column's diagonal.
//!
//! Small matrices are written out ([`written_out`]), larger ones go in tiles of four by four ([`tiles`]).

mod tiles;
mod written_out;

use bessemer_ir::Kernel;

use super::Source;

/// From this size on, a factorisation goes in tiles.
const TILES: u32 = 10;

/// Up to this size, the substitutions are written out: two kilobytes and a half of code.
pub(super) const SUBSTITUTIONS: u32 = 20;

/// The C of a factorisation.
pub(super) fn factor(kernel: &Kernel, size: u32) -> Source {
    match size {
        TILES.. => tiles::factor(kernel, size),
        _ => written_out::factor(kernel, size),
    }
}

/// The C of the solves with its factor, where they are written out.
pub(super) fn solve(kernel: &Kernel, size: u32, columns: u32) -> Source {
    written_out::solve(kernel, size, columns)
}
