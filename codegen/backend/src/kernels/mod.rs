//! C of kernels: routines of linear algebra, each in its own file, named by routine, type and shape.
//!
//! [`source`] returns the body of a kernel's function and the text before it; [`buffers`] returns the memory that it
//! needs. The head follows from [`Kernel::function`]; head, file, header and includes are the back end's. The
//! parameters keep their names: `a`, `b`, `result`.
//!
//! Bodies are text, not C trees. Vector types, intrinsics, pragmas and the preprocessor make a kernel fast, and the C
//! tree has none of them. A kernel does not need the tree's precedence, conversions and names. [`text`] fills
//! templates that look like the resulting C; generators of tiles print lines.
//!
//! Invariants:
//!
//! * **Order.** In the exact mode each element undergoes the operations of `bessemer_ir::KernelRoutine` and nalgebra
//!   in their order, each rounded by itself. Their interleaving between elements is free. All NaNs are equivalent; all
//!   other results, including ±0 and subnormals, have the same bits.
//! * **No fault.** For any input, singular, infinite or NaN, each index is within its array and every loop ends.
//! * **Memory.** Buffers of more than [`LARGEST`] bytes in total are the caller's, in the kernel's `…_work_t`; their
//!   content has no meaning between calls. Smaller ones are locals. Nothing else takes more than a few hundred bytes of
//!   the stack.
//! * **Stable.** The text of a kernel depends only on the kernel.
//!
//! Must not know: IR, names, files, callers.

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

/// Largest size of buffers that a kernel keeps on the stack, bytes.
pub const LARGEST: u64 = 256;

/// C text of a kernel.
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

/// An array in a kernel's working memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Buffer {
    /// Name in C.
    pub name: &'static str,
    /// Element type.
    pub element: Scalar,
    /// Number of elements.
    pub len: u32,
    /// Content, as a comment in the C.
    pub holds: &'static str,
}

/// Rounding of kernels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Bit for bit as in Rust.
    #[default]
    Exact,
    /// With fused multiply-add and sums in any order, where that is faster.
    Fast,
    /// Bit for bit as in Rust, as plain C99 loops for reviewers and certification.
    Plain,
}

/// Options of a project for all of its kernels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tuning {
    /// Largest code size of a kernel, bytes, estimated by four bytes per instruction without vectors.
    pub code_bytes: u32,
    /// Rounding mode.
    pub mode: Mode,
    /// Processors for which the files have variants.
    pub processors: Processors,
}

/// Estimated code size of a loop whose passes run at once, bytes: eight sums of eight terms, in four instructions each.
const TILED_LOOP: u32 = 1024;

impl Tuning {
    /// Returns true if passes of an author's loop may run at once.
    pub fn tiles(&self) -> bool {
        self.mode != Mode::Plain && TILED_LOOP <= self.code_bytes
    }
}

impl Default for Tuning {
    fn default() -> Tuning {
        Tuning { code_bytes: 8 * 1024, mode: Mode::Exact, processors: Processors::Every }
    }
}

/// Variants of a kernel, the fastest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    /// Every operation written out.
    WrittenOut,
    /// Loops over tiles.
    Tiles,
    /// Loops over elements.
    Loops,
}

/// Returns the fastest variant that fits into the code size.
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

/// Returns the C of a kernel.
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
    // A header's code is compiled with its callers' options; tiles are stored as they are loaded.
    let tiled =
        matches!(kernel.routine, LuSolve | Solve | Inverse) && way(kernel, tuning) == Way::Tiles;
    if kernel.element == Float::F32 && !is_in_header(kernel) && !tiled {
        source.before = format!("{SINGLE_STORES}\n{}", source.before).trim_end().to_owned();
    }
    of_processors(source, tuning.processors)
}

/// Separator between the text before a kernel's function and its body, while conditions that span both are resolved.
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

/// Returns true if the file of a kernel begins with plain loops, before its other variants.
fn has_loops(kernel: &Kernel) -> bool {
    use KernelRoutine::{Cholesky, CholeskyLower};
    // Of Cholesky's factor the loops are one of the ways.
    !is_in_header(kernel) && !matches!(kernel.routine, Cholesky | CholeskyLower)
}

/// Returns true if a kernel has a variant by rows for targets with vectors.
fn by_rows(kernel: &Kernel, tuning: &Tuning) -> bool {
    rows::fits(kernel) && way(kernel, tuning) != Way::Loops && rows::BUDGET <= tuning.code_bytes
}

/// Returns true if a kernel is in its header as an inline function. At these sizes, the call and its copies would be a
/// large part of its cost.
pub fn is_in_header(kernel: &Kernel) -> bool {
    match (kernel.routine, kernel.dims.as_slice()) {
        (KernelRoutine::Inverse, &[size]) => size <= 4,
        (KernelRoutine::Cholesky | KernelRoutine::CholeskyLower, &[size])
        | (KernelRoutine::CholeskySolve, &[size, 1]) => size <= 3,
        _ => product::is_small(kernel),
    }
}

/// Returns the working memory of a kernel.
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

/// Returns the buffers that a kernel's caller passes: all, or none if they are small.
pub fn lent(kernel: &Kernel, tuning: &Tuning) -> Vec<Buffer> {
    let buffers = buffers(kernel, tuning);
    if are_lent(&buffers) { buffers } else { Vec::new() }
}

fn are_lent(buffers: &[Buffer]) -> bool {
    buffers.iter().map(Buffer::bytes).sum::<u64>() > LARGEST
}

/// Returns the declarations of buffers: local arrays, or names for parts of the caller's memory.
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

/// Returns true if the bits of a kernel may differ from Rust's with this tuning.
pub fn is_fast(kernel: &Kernel, tuning: &Tuning) -> bool {
    tuning.mode == Mode::Fast
        && source(kernel, tuning) != source(kernel, &Tuning { mode: Mode::Exact, ..*tuning })
}

/// Returns the size of the buffers that are local arrays, bytes.
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
    /// Returns its size, bytes.
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

/// Returns the C type of a buffer's element.
fn scalar(scalar: Scalar) -> &'static str {
    match scalar {
        Scalar::Float(Float::F64) => "double",
        Scalar::Float(Float::F32) => "float",
        _ => "uint32_t",
    }
}
