//! Products of matrices in blocks: a part of the result stays in registers.
//!
//! Each element of the result starts as its first product and adds the others in the order of k, as in nalgebra; a
//! block only decides which elements are computed together.
//!
//! [`vectors`] has the blocks for targets with vectors, as [`bands`] plans them, and [`numbers`] those for all
//! others. [`small`] has the products that are inline in their header.

mod bands;
mod beside;
mod blocks;
mod numbers;
mod small;
mod target;
mod vectors;

use bessemer_ir::{Float, Kernel, KernelRoutine};

use super::plain;
use super::text::indented;
use super::threads::Work;
use super::{Mode, Source, Tuning, fast};

/// Smallest size, in each dimension, for which threads are used.
const THREADED: u32 = 64;

/// Rows of the result, terms of an element, columns of the result, and strides of the factors.
#[derive(Clone, Copy)]
struct Sizes {
    rows: u32,
    inner: u32,
    columns: u32,
    /// Strides of the left factor: from a row to the next, and from a term to the next.
    left: (u32, u32),
    /// Strides of the right factor: from a term to the next, and from a column to the next.
    right: (u32, u32),
}

impl Sizes {
    /// Returns the sizes of a product of these dimensions, with the factors' layout.
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

/// Returns true if a product is written out and inline in its header.
pub(super) fn is_small(kernel: &Kernel) -> bool {
    use KernelRoutine::{Product, ProductTr, TrProduct};
    matches!(kernel.routine, Product | ProductTr | TrProduct)
        && kernel.dims.iter().all(|dim| (2..=small::LARGEST).contains(dim))
}

/// Returns the C type of an element.
fn real(element: Float) -> &'static str {
    match element {
        Float::F64 => "double",
        Float::F32 => "float",
    }
}

/// Returns an index: a stride times its counter.
fn times(stride: u32, counter: &str) -> String {
    match stride {
        1 => counter.to_owned(),
        _ => format!("{stride}U * {counter}"),
    }
}

/// Returns the C of a product in blocks; none if `tuning` has too little code size.
pub(super) fn source(
    kernel: &Kernel,
    (rows, inner, columns): (u32, u32, u32),
    tuning: &Tuning,
) -> Option<Source> {
    let sizes = Sizes::new(kernel.routine, rows, inner, columns);
    if is_small(kernel) {
        let loops = plain::source(kernel).body;
        let body = small::source(kernel.element, sizes, &loops);
        return Some(Source { body, ..Source::default() });
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
