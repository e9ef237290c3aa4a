//! The generated C as a contender: kernels as the back end emits them, called as in a model. Operands that the kernel
//! changes are copied first. In the two cases of Chapter 6, a separate function copies the operands, and the kernel
//! works in place.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use bessemer_backend::kernels::{self, Tuning};
use bessemer_backend::{c, passes};
use bessemer_ir::{
    Block, Expr, ExprKind, Float, Function, Inlining, Kernel, KernelRoutine, LocalId, Module,
    Place, Routine as Node, Stmt, StmtKind,
};

use super::case::{Case, Element, Routine};
use super::contender::{put, real, table};

/// The kernels of a case.
pub fn kernels_of(case: &Case) -> Vec<Kernel> {
    let size = u32::try_from(case.size).unwrap_or_default();
    let element = match case.element {
        Element::F64 => Float::F64,
        Element::F32 => Float::F32,
    };
    let kernels = match case.routine {
        Routine::LuSolve => vec![(KernelRoutine::Solve, vec![size, 1])],
        Routine::Inverse => vec![(KernelRoutine::Inverse, vec![size])],
        Routine::Product => vec![(KernelRoutine::Product, vec![size; 3])],
        Routine::CholeskySolve => vec![
            (KernelRoutine::CholeskyLower, vec![size]),
            (KernelRoutine::CholeskySolve, vec![size, 1]),
        ],
    };
    kernels.into_iter().filter_map(|(routine, dims)| Kernel::new(routine, element, &dims)).collect()
}

/// Writes the kernels and the table of the cases; returns the sources.
pub fn write(cases: &[Case], folder: &Path, tuning: Tuning) -> Result<Vec<PathBuf>, String> {
    let known: Vec<(Case, Vec<Kernel>)> =
        cases.iter().map(|case| (*case, kernels_of(case))).collect();
    let module = Module {
        name: "bench".into(),
        functions: known.iter().flat_map(|(_, kernels)| kernels).map(function).collect(),
        ..Module::default()
    };
    let options = c::Options { kernels: tuning, ..c::Options::default() };
    let files = c::emit(
        &passes::lend(module, &options.kernels, options.layout != c::Layout::Array),
        &options,
    );
    let mut sources = Vec::new();
    for file in files {
        // The object is named by the case, whatever the kernel's file is called.
        let path = put(folder, &file.name, &file.text)?;
        if file.name.ends_with(".c") {
            sources.push(path);
        }
    }
    // Code of headers is compiled with its callers, and once alone to measure its size.
    sources.retain(|source| !source.ends_with("product.c"));
    for kernel in known.iter().flat_map(|(_, kernels)| kernels) {
        if kernel.is_function() && kernels::is_in_header(kernel) {
            sources.push(put(folder, &format!("{}.c", kernel.name()), &alone(kernel))?);
        }
    }
    let large = known.iter().any(|(case, _)| case.size > 20);
    let text = if large { loaded(&known) } else { copied(&known) };
    sources.push(put(folder, "generated_cases.c", &text)?);
    Ok(sources)
}

/// Wraps a function of a header in an ordinary function.
fn alone(kernel: &Kernel) -> String {
    let name = kernel.name();
    let real = if kernel.element == Float::F64 { "double" } else { "float" };
    let (result, parameters, arguments) = match kernel.routine {
        KernelRoutine::Product => {
            ("void", format!("const {real} *a, const {real} *b, {real} *result"), "a, b, result")
        }
        KernelRoutine::CholeskyLower => {
            ("void", format!("const {real} *a, {real} *result"), "a, result")
        }
        KernelRoutine::CholeskySolve => ("void", format!("const {real} *a, {real} *b"), "a, b"),
        _ => ("bool", format!("{real} *a"), "a"),
    };
    let keyword = if result == "void" { "" } else { "return " };
    format!(
        "#include \"{name}.h\"\n{result} {name}_alone({parameters});\n{result} {name}_alone({parameters})\n{{\n    \
         {keyword}{name}({arguments});\n}}\n"
    )
}

/// Returns the function of a kernel; for a product without a kernel, a function with a model's code.
fn function(kernel: &Kernel) -> Function {
    let mut function = kernel.function();
    if kernel.is_function() {
        return function;
    }
    let operand = |index: u32| {
        let (root, span) = (LocalId(index), function.span);
        let ty = function.local(root).ty.clone();
        let place = Place { root, steps: Vec::new(), ty: ty.clone(), span };
        Expr { kind: ExprKind::Load(place), ty, span }
    };
    let (ty, span) = (function.result.clone(), function.span);
    let kind = ExprKind::Routine(Node::Product, vec![operand(0), operand(1)]);
    let value = Some(Expr { kind, ty, span });
    let stmt = Stmt { kind: StmtKind::Return(value), span, comments: Vec::new() };
    function.body = Block(vec![stmt]);
    function.kernel = None;
    function.attributes.inlining = Inlining::Always;
    // The C name is the module's and its own: the kernel's.
    function.module = "bench::product".into();
    function.name = kernel.name().trim_start_matches("product_").into();
    function
}

/// Returns functions that call each kernel on copies of the operands that it changes.
fn copied(known: &[(Case, Vec<Kernel>)]) -> String {
    // As each emitted source begins: compilers put a kernel of a header where it is called only if both were reported the same.
    let mut before = String::from("#include <string.h>\n#include \"bessemer_target.h\"\n");
    for (case, kernels) in known {
        for kernel in kernels {
            let file = match kernel.is_function() {
                true => format!("{}.h", kernel.name()),
                // It is at its place in a model, so here too.
                false => "product.c".into(),
            };
            if !before.contains(&file) {
                let _ = writeln!(before, "#include \"{file}\"");
            }
        }
        let kernel = &kernels[0];
        let (real, name, n) = (real(case).0, kernel.name(), case.size);
        let call = Call::new(kernel);
        let _ = match case.routine {
            Routine::Product => writeln!(
                before,
                "static void copy_{case}(const {real} *a, const {real} *b, {real} *x)\n{{\n    \
                 {name}(a, b, x);\n}}",
                case = case.name()
            ),
            // What compilers put at its place needs no copy: as a model, it gives the result if there is one.
            Routine::Inverse if kernels::is_in_header(kernel) => writeln!(
                before,
                "static void copy_{case}(const {real} *a, {real} *x)\n{{\n    {real} inverse[{count}];\n    \
                 memcpy(inverse, a, sizeof inverse);\n    if ({name}(inverse)) {{\n        \
                 memcpy(x, inverse, sizeof inverse);\n    }}\n}}",
                case = case.name(),
                count = n * n,
            ),
            Routine::Inverse => writeln!(
                before,
                "{work}static void copy_{case}(const {real} *a, {real} *x)\n{{\n    \
                 memcpy(x, a, {count} * sizeof *x);\n    (void){name}(x{lent});\n}}",
                case = case.name(),
                count = n * n,
                work = call.work,
                lent = call.lent,
            ),
            Routine::CholeskySolve => writeln!(
                before,
                "static void copy_{case}(const {real} *a, const {real} *b, {real} *x)\n{{\n    \
                 {real} lower[{count}];\n    {name}(a, lower);\n    \
                 memcpy(x, b, {n} * sizeof *x);\n    {solve}(lower, x);\n}}",
                case = case.name(),
                count = n * n,
                solve = kernels[1].name(),
            ),
            Routine::LuSolve => writeln!(
                before,
                "{work}static void copy_{case}(const {real} *a, const {real} *b, {real} *x)\n{{\n    \
                 memcpy(x, b, {n} * sizeof *x);\n    (void){name}(a, x{lent});\n}}",
                case = case.name(),
                work = call.work,
                lent = call.lent,
            ),
        };
    }
    let cases: Vec<Case> = known.iter().map(|(case, _)| *case).collect();
    table("case.h", &cases, |case| format!("copy_{}", case.name()), &before)
}

/// The work struct of a kernel, and how it is passed.
struct Call {
    work: String,
    lent: String,
}

impl Call {
    fn new(kernel: &Kernel) -> Call {
        let name = kernel.name();
        match kernels::lent(kernel, &Tuning::default()).is_empty() {
            true => Call { work: String::new(), lent: String::new() },
            false => Call {
                work: format!("static {name}_work_t {name}_memory;\n"),
                lent: format!(", &{name}_memory"),
            },
        }
    }
}

/// Returns the functions for Chapter 6: one that copies the operands, and the kernel in place.
fn loaded(known: &[(Case, Vec<Kernel>)]) -> String {
    let mut text = String::from("#include \"case.h\"\n#include <string.h>\n");
    let mut list = String::new();
    for (case, kernels) in known {
        let kernel = &kernels[0];
        let (name, n, call) = (kernel.name(), case.size, Call::new(kernel));
        let _ = write!(text, "#include \"{name}.h\"\n{}", call.work);
        let (load, run) = match case.routine {
            Routine::LuSolve => (
                format!(
                    "static void load_{name}(void)\n{{\n    \
                     memcpy(result.f64, vector.f64, {n} * sizeof(double));\n}}\n"
                ),
                format!("{name}(matrix.f64, result.f64{})", call.lent),
            ),
            _ => (
                format!(
                    "static void load_{name}(void)\n{{\n    memcpy(result.f64, matrix.f64, {} * sizeof(double));\n}}\n",
                    n * n
                ),
                format!("{name}(result.f64{})", call.lent),
            ),
        };
        let _ = write!(
            text,
            "{load}__attribute__((noinline)) static void run_{name}(void)\n{{\n    (void){run};\n}}\n"
        );
        let _ = writeln!(
            list,
            "    {{\"{}\", {}, {n}, 0, load_{name}, run_{name}, NULL}},",
            case.name(),
            case.routine.name().to_uppercase()
        );
    }
    text + &format!(
        "const case_t CASES[] = {{\n{list}}};\nconst size_t CASE_COUNT = sizeof CASES / sizeof CASES[0];\n"
    )
}
