//! Products of matrices in blocks: a part of the result stays in registers.
//!
//! Each element of the result starts as its first product and takes the others in the order of k, as
//! nalgebra's does; a block only decides which elements go side by side.
//!
//! [`vectors`] has the blocks of targets with vectors, [`numbers`] those of all others.

mod numbers;
mod vectors;

use bessemer_ir::{Float, Kernel};

use super::Source;

/// Rows of `a`, columns of `a`, columns of `b`.
#[derive(Clone, Copy)]
struct Sizes {
    rows: u32,
    inner: u32,
    columns: u32,
}

/// The C of a product; the columns of `b` are the result's.
pub(super) fn source(kernel: &Kernel, rows: u32, inner: u32, columns: u32) -> Source {
    let sizes = Sizes { rows, inner, columns };
    let real = match kernel.element {
        Float::F64 => "double",
        Float::F32 => "float",
    };
    let plain = numbers::source(real, sizes);
    let Some((targets, block, loops)) = vectors::source(kernel.element, sizes) else {
        return Source { before: plain.0, body: plain.1, ..Source::default() };
    };
    let before = format!("{targets}\n#if defined(LANES)\n{block}#else\n{}\n#endif", plain.0);
    let body = format!("#if defined(LANES)\n{loops}#else\n{}#endif\n", plain.1);
    Source { before, body, ..Source::default() }
}
