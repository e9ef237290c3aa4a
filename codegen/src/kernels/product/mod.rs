//! Products of matrices in blocks: a part of the result stays in registers.
//!
//! Each element of the result starts as its first product and takes the others in the order of k, as
//! nalgebra's does; a block only decides which elements go side by side.
//!
//! [`vectors`] has the blocks of targets with vectors, [`numbers`] those of all others.

mod numbers;
mod vectors;

use bessemer_ir::{Float, Kernel, KernelRoutine};

use super::{Mode, NOTE, Source, Tuning};

/// Rows of the result, terms of an element, columns of the result; and how far apart what follows lies.
#[derive(Clone, Copy)]
struct Sizes {
    rows: u32,
    inner: u32,
    columns: u32,
    /// From a row of the left factor to the next, and from a term to the next.
    left: (u32, u32),
    /// From a term to the next in the right factor, and from a column to the next.
    right: (u32, u32),
}

impl Sizes {
    /// The sizes of a product of these dimensions, of factors as they lie in memory.
    fn new(routine: KernelRoutine, rows: u32, inner: u32, columns: u32) -> Sizes {
        let left = match routine {
            KernelRoutine::TrProduct => (inner, 1),
            _ => (1, rows),
        };
        let right = match routine {
            KernelRoutine::ProductTr => (columns, 1),
            _ => (1, inner),
        };
        Sizes { rows, inner, columns, left, right }
    }
}

/// An index: what lies so far apart times its counter.
fn times(stride: u32, counter: &str) -> String {
    match stride {
        1 => counter.to_owned(),
        _ => format!("{stride}U * {counter}"),
    }
}

/// The C of a product in so many bytes of code, if they are enough for blocks.
pub(super) fn source(
    kernel: &Kernel,
    (rows, inner, columns): (u32, u32, u32),
    tuning: &Tuning,
) -> Option<Source> {
    let sizes = Sizes::new(kernel.routine, rows, inner, columns);
    let real = match kernel.element {
        Float::F64 => "double",
        Float::F32 => "float",
    };
    let plain = numbers::source(real, sizes, tuning.code_bytes)?;
    let Some((targets, block, loops)) = vectors::source(kernel.element, sizes, tuning.mode) else {
        return Some(Source { before: plain.0, body: plain.1, ..Source::default() });
    };
    let note = if tuning.mode == Mode::Fast { NOTE } else { "" };
    let before = format!("{note}{targets}\n#if defined(LANES)\n{block}#else\n{}\n#endif", plain.0);
    let body = format!("#if defined(LANES)\n{loops}#else\n{}#endif\n", plain.1);
    Some(Source { before, body, ..Source::default() })
}
