//! Products of matrices in blocks: a part of the result stays in registers.
//!
//! Each element of the result starts as its first product and takes the others in the order of k, as
//! nalgebra's does; a block only decides which elements go side by side.
//!
//! [`vectors`] has the blocks of targets with vectors, as [`bands`] plans them, [`numbers`] those of all others; [`small`]
//! the products that are in their header.

mod bands;
mod beside;
mod blocks;
mod numbers;
mod small;
mod target;
mod vectors;

use bessemer_ir::{Float, Kernel, KernelRoutine};

use super::text::indented;
use super::threads::Work;
use super::{Mode, Source, Tuning, fast};

/// From this size on, in each dimension, threads are worth their start.
const THREADED: u32 = 64;

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

/// Returns true if a product is written out, and is in its header.
pub(super) fn is_small(kernel: &Kernel) -> bool {
    use KernelRoutine::{Product, ProductTr, TrProduct};
    matches!(kernel.routine, Product | ProductTr | TrProduct)
        && kernel.dims.iter().all(|dim| (2..=small::LARGEST).contains(dim))
}

/// The C type of an element.
fn real(element: Float) -> &'static str {
    match element {
        Float::F64 => "double",
        Float::F32 => "float",
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
    if is_small(kernel) {
        return Some(Source { body: small::source(kernel.element, sizes), ..Source::default() });
    }
    let shares = [rows, inner, columns].into_iter().all(|size| size >= THREADED);
    let numbers = numbers::source(kernel.element, sizes, tuning.code_bytes, shares)?;
    let (before, body) = match vectors::source(kernel.element, sizes, tuning, shares) {
        None => numbers,
        Some((before, body)) => {
            let note = match tuning.mode {
                Mode::Exact | Mode::Plain => String::new(),
                Mode::Fast => fast::note(kernel),
            };
            let (tiles, calls) = numbers;
            (
                format!("{note}{before}#else\n{tiles}\n#endif"),
                format!("{body}#else\n{calls}#endif\n"),
            )
        }
    };
    Some(match shares {
        true => shared(real(kernel.element), &before, &body),
        false => Source { before, body, ..Source::default() },
    })
}

/// Returns the variant for threads: a function computes a share of the columns.
fn shared(real: &str, before: &str, body: &str) -> Source {
    let (lent, result) = (format!("const {real} *"), format!("{real} *"));
    let work = Work {
        name: "multiply",
        shared: &[(&lent, "a"), (&lent, "b"), (&result, "result")],
        own: None,
    };
    let text = format!(
        "{before}\n\n/* The blocks of columns from one on, every so many. */\nstatic void multiply(const {real} *a, \
         const {real} *b, {real} *result, uint32_t from,\n    uint32_t apart)\n{{\n{}}}\n\n{}",
        indented(body),
        work.text().trim_end(),
    );
    Source { before: text, body: work.call(), ..Source::default() }
}
