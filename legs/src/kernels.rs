//! Kernels alone: their C as a program that gets its numbers from this process.

use std::fmt::Write as _;

use bessemer_backend::c::{self, CFile, Options};
use bessemer_backend::kernels::{self, Tuning};
use bessemer_backend::passes;
use bessemer_ir::{Float, Kernel, KernelRoutine, Mode, Module, Type};

use crate::process::Process;
use crate::toolchain::Toolchain;

/// Some kernels as a running program.
pub struct Program {
    kernels: Vec<Kernel>,
    process: Process,
}

impl Program {
    /// Compiles the C of these kernels with a toolchain and starts it.
    ///
    /// # Panics
    ///
    /// If it does not compile.
    pub fn start(kernels: &[Kernel], tuning: Tuning, toolchain: &Toolchain) -> Program {
        let files = files(kernels, &Options { kernels: tuning, ..Options::default() });
        let process = Process::run_files(&files, &main(kernels, &tuning), toolchain, &[])
            .unwrap_or_else(|error| panic!("{}: {error}", toolchain.name()));
        Program { kernels: kernels.to_vec(), process }
    }

    /// Calls a kernel; returns the words of its result and of the arguments that it changes, `count` in all.
    ///
    /// # Panics
    ///
    /// If the program ends, or the kernel is not in it.
    pub fn call(&mut self, kernel: &Kernel, arguments: &[&[f64]], count: usize) -> Vec<u64> {
        let at = self.kernels.iter().position(|it| it == kernel).expect("it is in the program");
        let numbers = arguments.iter().flat_map(|list| list.iter());
        let mut words = vec![at as u64];
        words.extend(numbers.map(|number| word(*number, kernel.element)));
        self.process.send(&words).expect("it lives");
        self.process.receive(count).expect("it lives")
    }

    /// Calls a solve or an inverse; returns the arguments that it changes, `count` numbers in all.
    ///
    /// # Panics
    ///
    /// If it finds the matrix singular.
    pub fn solve(&mut self, kernel: &Kernel, arguments: &[&[f64]], count: usize) -> Vec<f64> {
        let found = self.call(kernel, arguments, 1 + count);
        assert_eq!(found[0], 1, "{} found no solution", kernel.name());
        found[1..].iter().map(|word| number(*word, kernel.element)).collect()
    }
}

/// The C of some kernels.
pub fn files(kernels: &[Kernel], options: &Options) -> Vec<CFile> {
    let functions = kernels.iter().map(Kernel::function).collect();
    let module = Module { name: "kernels".into(), functions, ..Module::default() };
    let flat = options.layout != c::Layout::Array;
    c::emit(&passes::lend(module, &options.kernels, flat), options)
}

/// C functions that read and write arrays of words.
const WORDS: &str = "
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static inline uint64_t get(void)
{
    uint64_t word;
    if (fread(&word, sizeof word, 1, stdin) != 1U) {
        exit(0);
    }
    return word;
}

static inline void put(uint64_t word)
{
    (void)fwrite(&word, sizeof word, 1, stdout);
}
";

/// Returns the C functions that read and write numbers of a type.
fn numbers(element: Float) -> String {
    let (real, suffix) = real(element);
    let (word, read) = match element {
        Float::F64 => ("uint64_t", "get()"),
        Float::F32 => ("uint32_t", "(uint32_t)get()"),
    };
    format!(
        "
static inline void get_{suffix}({real} *numbers, uint32_t count)
{{
    for (uint32_t index = 0U; index < count; index++) {{
        const {word} word = {read};
        memcpy(&numbers[index], &word, sizeof word);
    }}
}}

static inline void put_{suffix}(const {real} *numbers, uint32_t count)
{{
    for (uint32_t index = 0U; index < count; index++) {{
        {word} word;
        memcpy(&word, &numbers[index], sizeof word);
        put(word);
    }}
}}
"
    )
}

/// Returns the type in C, and the suffix of function names for it.
fn real(element: Float) -> (&'static str, &'static str) {
    match element {
        Float::F64 => ("double", "f64"),
        Float::F32 => ("float", "f32"),
    }
}

/// Returns the main function: it reads the index of a kernel and the words of its arguments.
fn main(kernels: &[Kernel], tuning: &Tuning) -> String {
    let (mut functions, mut cases) = (String::new(), String::new());
    for (at, kernel) in kernels.iter().enumerate() {
        let _ =
            write!(functions, "\nstatic void call_{at}(void)\n{{\n{}}}\n", call(kernel, tuning));
        let _ = writeln!(cases, "        case {at}: call_{at}(); break;");
    }
    let include = |kernel: &Kernel| format!("#include \"{}.h\"\n", kernel.name());
    let includes: String = kernels.iter().map(include).collect();
    // A turn's kernels may all be of one type: clang refuses functions that nobody calls.
    let is_used = |element: &Float| kernels.iter().any(|kernel| kernel.element == *element);
    let numbers: String =
        [Float::F64, Float::F32].into_iter().filter(is_used).map(numbers).collect();
    format!(
        "{includes}#include <stdint.h>\n{WORDS}{numbers}{functions}\nint main(void)\n{{\n    for (;;) {{\n        switch (get()) \
         {{\n{cases}        default: break;\n        }}\n        (void)fflush(stdout);\n    }}\n}}\n"
    )
}

/// Returns the body of a call: reads the arguments, calls, writes the results.
fn call(kernel: &Kernel, tuning: &Tuning) -> String {
    let name = kernel.name();
    let (real, suffix) = real(kernel.element);
    let function = kernel.function();
    let mut body = String::new();
    let (mut reads, mut writes, mut arguments) = (String::new(), String::new(), Vec::new());
    for local in function.parameters() {
        let Type::Matrix { rows, cols, .. } = local.ty else { continue };
        let (name, count) = (&local.name, rows * cols);
        let _ = writeln!(body, "    static {real} {name}[{count}];");
        let _ = writeln!(reads, "    get_{suffix}({name}, {count}U);");
        if local.mode == Mode::RefMut {
            let _ = writeln!(writes, "    put_{suffix}({name}, {count}U);");
        }
        arguments.push(name.clone());
    }
    if let Type::Matrix { rows, cols, .. } = function.result {
        let _ = writeln!(body, "    static {real} result[{}];", rows * cols);
        let _ = writeln!(writes, "    put_{suffix}(result, {}U);", rows * cols);
        arguments.push("result".into());
    }
    if !kernels::lent(kernel, tuning).is_empty() {
        let _ = writeln!(body, "    static {name}_work_t work;");
        arguments.push("&work".into());
    }
    let call = format!("{name}({})", arguments.join(", "));
    match function.result {
        Type::Scalar(_) => format!("{body}{reads}    put({call} ? 1U : 0U);\n{writes}"),
        _ => format!("{body}{reads}    {call};\n{writes}"),
    }
}

/// Builds a kernel of these dimensions.
///
/// # Panics
///
/// If the routine has another number of dimensions.
pub fn kernel(routine: KernelRoutine, element: Float, dims: &[usize]) -> Kernel {
    let dims: Vec<u32> = dims.iter().map(|dim| *dim as u32).collect();
    Kernel::new(routine, element, &dims).expect("as many as it has")
}

/// Converts a number to a word, rounded to the type.
pub fn word(number: f64, element: Float) -> u64 {
    match element {
        Float::F64 => number.to_bits(),
        Float::F32 => u64::from((number as f32).to_bits()),
    }
}

/// Converts a word of the type to a number.
pub fn number(word: u64, element: Float) -> f64 {
    match element {
        Float::F64 => f64::from_bits(word),
        Float::F32 => f64::from(f32::from_bits(word as u32)),
    }
}
