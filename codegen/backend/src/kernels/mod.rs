//! The C of kernels: routines of linear algebra, each in a file of its own, named by routine, type and
//! shape.
//!
//! The interface: [`source`] gives the body of a kernel's function and what precedes it;
//! [`buffers`] gives the memory that it needs. The head follows from [`Kernel::function`] and is the
//! back end's, as are file, header and includes. The parameters keep their names: `a`, `b`, `result`.
//!
//! Bodies are text, not C trees: what makes a kernel fast (vector types, intrinsics, pragmas, the
//! preprocessor) is not in the C tree, and what the C tree brings (precedence, conversions, names)
//! a kernel has no need of. [`text`] fills templates that look like the C they become; a generator of
//! tiles prints lines.
//!
//! Invariants:
//! * **Order.** In the exact mode each element sees the operations that `bessemer_ir::KernelRoutine` and nalgebra give it, in
//!   that order, each rounded by itself; how elements are interleaved is free. Any NaN is as good as
//!   another; everything else, ±0 and subnormals included, is the same bits.
//! * **No fault.** For any input, singular, infinite or NaN, no index leaves its array and every loop ends.
//! * **Memory.** Buffers of more than [`LARGEST`] bytes in all are the caller's, in the kernel's `…_work_t`;
//!   what they hold means nothing between calls. Smaller ones are locals. Nothing else takes more than a
//!   few hundred bytes of the stack.
//! * **Stable.** The text of a kernel depends on the kernel alone.
//!
//! Absent: IR, names, files; any knowledge of who calls.

mod cholesky;
pub mod fast;
mod loops;
pub mod plain;
mod processors;
mod product;
pub mod replace;
mod rows;
pub mod text;
mod threads;
mod tiled;
mod written_out;

use bessemer_ir::{Float, Int, Kernel, KernelRoutine, Scalar};

pub use processors::Processors;

/// Bytes of buffers that a kernel may put on the stack.
pub const LARGEST: u64 = 256;

/// The C of a kernel.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Source {
    /// Static functions and macros before the kernel's function.
    pub before: String,
    /// The lines of its body, indented from 0.
    pub body: String,
    /// True if it needs `math.h`.
    pub math: bool,
    /// True if it needs `string.h`.
    pub string: bool,
    /// True if it calls the scalar product of columns, `dot_f64(x, y, rows, 1U)`.
    pub dot: bool,
}

/// An array that a kernel works with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Buffer {
    /// Its name.
    pub name: &'static str,
    /// The type of its elements.
    pub element: Scalar,
    /// Number of elements.
    pub len: u32,
    /// Contents, for the comment.
    pub holds: &'static str,
}

/// Rounding of kernels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// As the Rust does, bit for bit.
    #[default]
    Exact,
    /// Multiplications fuse with additions, and sums go in any order, where that is faster.
    Fast,
    /// As the Rust does, in one way that is C99 alone: loops, for who reads or certifies them.
    Plain,
}

/// Options of a project for all of its kernels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tuning {
    /// Bytes of code that a kernel may take, by an estimate of four bytes an instruction without vectors.
    pub code_bytes: u32,
    /// Rounding mode.
    pub mode: Mode,
    /// Whose ways their files have.
    pub processors: Processors,
}

impl Default for Tuning {
    fn default() -> Tuning {
        Tuning { code_bytes: 8 * 1024, mode: Mode::Exact, processors: Processors::Every }
    }
}

/// Variants of a kernel, the fastest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    /// Every operation by itself.
    WrittenOut,
    /// Loops over tiles.
    Tiles,
    /// Loops over elements.
    Loops,
}

/// The fastest way that has room.
fn way(kernel: &Kernel, tuning: &Tuning) -> Way {
    if tuning.mode == Mode::Plain {
        Way::Loops
    } else if written_out::fits(kernel) && written_out::has_room(kernel, tuning.code_bytes) {
        Way::WrittenOut
    } else if tiled::fits(kernel) && tiled::BYTES <= tuning.code_bytes {
        Way::Tiles
    } else {
        Way::Loops
    }
}

/// The C of a kernel.
pub fn source(kernel: &Kernel, tuning: &Tuning) -> Source {
    use KernelRoutine::{Inverse, LuSolve, Solve};
    if tuning.mode == Mode::Plain {
        return plain::alone(match kernel.routine {
            KernelRoutine::Cholesky | KernelRoutine::CholeskyLower => cholesky::loops(kernel),
            _ => plain::source(kernel),
        });
    }
    let mut source = of_routine(kernel, tuning);
    if tuning.mode == Mode::Exact && has_loops(kernel) {
        source = loops::before(kernel, source, &buffers(kernel, tuning));
    }
    // What is in a header is compiled as its callers are; tiles are stored as they are loaded.
    let tiled =
        matches!(kernel.routine, LuSolve | Solve | Inverse) && way(kernel, tuning) == Way::Tiles;
    if kernel.element == Float::F32 && !stands_in_header(kernel) && !tiled {
        source.before = format!("{SINGLE_STORES}\n{}", source.before).trim_end().to_owned();
    }
    of_processors(source, tuning.processors)
}

/// A line of no C between what precedes a kernel's function and its body, which decide together what is left of both.
const BODY: &str = "\u{1}\n";

fn of_processors(source: Source, processors: Processors) -> Source {
    if processors == Processors::Every {
        return source;
    }
    let text = processors.alone(&format!("{}\n{BODY}{}", source.before, source.body));
    let (before, body) = text.split_once(BODY).unwrap_or_default();
    let end = |text: &str, like: &str| {
        let text = text.trim_end();
        if like.ends_with('\n') { format!("{text}\n") } else { text.to_owned() }
    };
    // What stood around what is gone leaves one empty line.
    let mut before = before.trim_start().to_owned();
    while before.contains("\n\n\n") {
        before = before.replace("\n\n\n", "\n\n");
    }
    Source { before: end(&before, &source.before), body: end(body, &source.body), ..source }
}

/// Code against combined stores of `f32`: gcc would assemble four numbers on the stack and load them as one vector.
/// That takes up to a fifth more instructions, and the vector waits for four stores.
const SINGLE_STORES: &str = "\
/* Numbers are stored as they come: gathered for stores of NEON, they would go through the stack. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__ARM_NEON)
#pragma GCC optimize(\"no-tree-slp-vectorize\")
#endif
";

fn of_routine(kernel: &Kernel, tuning: &Tuning) -> Source {
    match (kernel.routine, kernel.dims.as_slice()) {
        (
            KernelRoutine::Product | KernelRoutine::ProductTr | KernelRoutine::TrProduct,
            &[rows, inner, columns],
        ) => product::source(kernel, (rows, inner, columns), tuning)
            .unwrap_or_else(|| plain::source(kernel)),
        (KernelRoutine::Cholesky | KernelRoutine::CholeskyLower, &[size]) => {
            cholesky::factor(kernel, size, tuning.code_bytes)
        }
        (KernelRoutine::CholeskySolve, &[size @ ..=cholesky::SUBSTITUTIONS, columns])
            if cholesky::solve_bytes(size) <= tuning.code_bytes =>
        {
            cholesky::solve(kernel, size, columns)
        }
        _ => {
            let by_rows = by_rows(kernel, tuning);
            // Rows are exact, and so is what is beside them.
            let mode = if by_rows { Mode::Exact } else { tuning.mode };
            let source = match way(kernel, tuning) {
                Way::WrittenOut => written_out::source(kernel, tuning.code_bytes),
                Way::Tiles => tiled::source(kernel, mode),
                Way::Loops => plain::source(kernel),
            };
            match by_rows {
                true => rows::source(kernel, source, &buffers(kernel, tuning)),
                false => source,
            }
        }
    }
}

/// Returns true if the file of a kernel opens with its loops: where other ways may follow.
fn has_loops(kernel: &Kernel) -> bool {
    use KernelRoutine::{Cholesky, CholeskyLower};
    // Of Cholesky's factor the loops are one of the ways.
    !stands_in_header(kernel) && !matches!(kernel.routine, Cholesky | CholeskyLower)
}

/// Returns true if a kernel goes by rows where there are vectors.
fn by_rows(kernel: &Kernel, tuning: &Tuning) -> bool {
    rows::fits(kernel) && way(kernel, tuning) != Way::Loops && rows::BUDGET <= tuning.code_bytes
}

/// Returns true if a kernel is in its header as an inline function. At these sizes, the call and its copies would be a
/// large part of its cost.
pub fn stands_in_header(kernel: &Kernel) -> bool {
    match (kernel.routine, kernel.dims.as_slice()) {
        (KernelRoutine::Inverse, &[size]) => size <= 4,
        (KernelRoutine::Cholesky | KernelRoutine::CholeskyLower, &[size])
        | (KernelRoutine::CholeskySolve, &[size, 1]) => size <= 3,
        _ => product::is_small(kernel),
    }
}

/// The memory that a kernel works with.
pub fn buffers(kernel: &Kernel, tuning: &Tuning) -> Vec<Buffer> {
    let mut buffers = match way(kernel, tuning) {
        Way::WrittenOut => written_out::buffers(kernel),
        Way::Tiles => tiled::buffers(kernel),
        Way::Loops => plain::buffers(kernel),
    };
    // The rows are where the factors are.
    if by_rows(kernel, tuning) && are_lent(&buffers) {
        buffers[0].len = buffers[0].len.max(rows::numbers(kernel));
    }
    buffers
}

/// The memory that a kernel's caller lends it: all its buffers, or none if they are small.
pub fn lent(kernel: &Kernel, tuning: &Tuning) -> Vec<Buffer> {
    let buffers = buffers(kernel, tuning);
    if are_lent(&buffers) { buffers } else { Vec::new() }
}

fn are_lent(buffers: &[Buffer]) -> bool {
    buffers.iter().map(Buffer::bytes).sum::<u64>() > LARGEST
}

/// The declarations of buffers: locals, or names for what the caller lends.
fn declarations(buffers: &[Buffer]) -> String {
    let lent = are_lent(buffers);
    let declare = |buffer: &Buffer| {
        let (ty, name, len) = (scalar(buffer.element), buffer.name, buffer.len);
        match lent {
            true => format!("{ty} *const {name} = work->{name};\n"),
            false => format!("{ty} {name}[{len}];\n"),
        }
    };
    buffers.iter().map(declare).collect()
}

/// Returns true if the bits of a kernel may differ from the Rust's, as it is made.
pub fn is_fast(kernel: &Kernel, tuning: &Tuning) -> bool {
    tuning.mode == Mode::Fast
        && source(kernel, tuning) != source(kernel, &Tuning { mode: Mode::Exact, ..*tuning })
}

/// Bytes of the buffers that are locals of the kernel.
pub fn stack_bytes(kernel: &Kernel, tuning: &Tuning) -> u64 {
    let buffers = buffers(kernel, tuning);
    let all: u64 = buffers.iter().map(Buffer::bytes).sum();
    match (are_lent(&buffers), by_rows(kernel, tuning)) {
        (true, _) => 0,
        (false, true) => all + rows::local_bytes(kernel),
        (false, false) => all,
    }
}

impl Buffer {
    /// Its size.
    pub fn bytes(&self) -> u64 {
        let element = match self.element {
            Scalar::Float(Float::F64) | Scalar::Int(Int::U64 | Int::I64) => 8,
            Scalar::Float(Float::F32) => 4,
            Scalar::Int(int) => u64::from(int.bits() / 8),
            Scalar::Bool => 1,
        };
        element * u64::from(self.len)
    }
}

/// The C type of a buffer's element.
fn scalar(scalar: Scalar) -> &'static str {
    match scalar {
        Scalar::Float(Float::F64) => "double",
        Scalar::Float(Float::F32) => "float",
        _ => "uint32_t",
    }
}
