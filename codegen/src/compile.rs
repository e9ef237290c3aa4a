//! The whole way: tree, typed IR, checked IR, explicit IR, C.
//!
//! Validation is the only gate, and stands before and after the passes: what comes behind it may
//! assume what it checks.

use bessemer_ir::Module;
use bessemer_ir::tree::Package;

use crate::c::{self, CFile, EntryReport};
use crate::deep::deep;
use crate::diagnostic::{Diagnostic, OUR_FAULT};
use crate::kernels::replace::Replacement;
use crate::source::Sources;
use crate::{kernels, passes, typify, validate};

pub use crate::c::{Layout, Math, Options};
pub use crate::typify::Typed;

/// A package as IR and as C.
pub struct Compiled {
    /// The IR as the author wrote it: what the interpreter runs.
    pub module: Module,
    /// The IR that the C is printed from: faults explicit, one step a statement, large temporaries
    /// the caller's.
    pub explicit: Module,
    /// How many types were computed, and how many of them rustc was asked about.
    pub typed: Typed,
    /// The C.
    pub files: Vec<CFile>,
    /// What there is to call, and what it costs.
    pub entries: Vec<EntryReport>,
    /// The checks that are left in each function, and why.
    pub checks: passes::Report,
    /// The kernels that the user's own functions stand for, and whose these are.
    pub replaced: Vec<(String, String)>,
    /// The kernels that are made in the fast mode, whose bits need not be the Rust's, and the bounds of their errors.
    pub fast: Vec<(String, String)>,
    /// Functions of the target's `math.h` that the C calls: there the bits need not be the Rust's.
    pub library: Vec<String>,
}

/// Compiles a package.
///
/// # Errors
/// Everything that is wrong with it, at the author's lines.
pub fn compile(
    package: &Package,
    sources: &Sources,
    options: &Options,
) -> Result<Compiled, Vec<Diagnostic>> {
    deep(|| whole(package, sources, options))
}

fn whole(
    package: &Package,
    sources: &Sources,
    options: &Options,
) -> Result<Compiled, Vec<Diagnostic>> {
    let options = &Options { license: package.license.clone(), ..options.clone() };
    let (module, typed) = typify::typify(package, sources, options.layout == Layout::Columns)?;
    gate(&module)?;
    let (explicit, checks) =
        passes::explicit_with(module.clone(), options.keep_checks).map_err(|errors| {
            errors.iter().map(|error| unproved(&module, error)).collect::<Vec<_>>()
        })?;
    let explicit = passes::lend(explicit, &options.kernels, options.layout != Layout::Array);
    gate(&explicit)?;
    let taken: Vec<_> = c::given::taken(&explicit, options)
        .iter()
        .map(|(span, taken)| Diagnostic {
            help: match taken {
                c::given::Taken::Made(_) => {
                    "name one of them otherwise in the C: `#[c(name = \"…\")]`"
                }
                _ => "give it another name, or leave the name to Bessemer",
            }
            .to_owned(),
            ..place(&module, *span, taken)
        })
        .collect();
    if !taken.is_empty() {
        return Err(taken);
    }
    let files = c::emit(&explicit, options);
    let entries = c::report(&explicit, options, &files);
    let replaced = replaced(&explicit, options);
    let fast = fast(&explicit, options);
    let library = c::library_calls(&explicit, options);
    Ok(Compiled { module, explicit, typed, files, entries, checks, replaced, fast, library })
}

fn replaced(module: &Module, options: &Options) -> Vec<(String, String)> {
    let kernels = module.functions.iter().filter_map(|function| function.kernel.as_ref());
    let replaced = |kernel: &bessemer_ir::Kernel| {
        let replacement = Replacement::of(&options.replacements, kernel)?;
        Some((kernel.name(), replacement.library.clone()))
    };
    kernels.filter_map(replaced).collect()
}

fn fast(module: &Module, options: &Options) -> Vec<(String, String)> {
    let kernels = module.functions.iter().filter_map(|function| function.kernel.as_ref());
    let fast = |kernel: &&bessemer_ir::Kernel| kernels::is_fast(kernel, &options.kernels);
    kernels.filter(fast).map(|kernel| (kernel.name(), kernels::fast::bound(kernel))).collect()
}

/// Validation; what it finds is a fault of the tool, since the author's were found before, but for what nests too deep.
fn gate(module: &Module) -> Result<(), Vec<Diagnostic>> {
    validate::validate(module).map_err(|errors| {
        let help = |problem: &validate::Problem| match problem {
            validate::Problem::NestedTooDeep => "give parts of it names, or functions of their own",
            _ => OUR_FAULT,
        };
        let told = |error: &validate::Error| Diagnostic {
            help: help(&error.problem).to_owned(),
            ..place(module, error.span, &error.problem)
        };
        errors.iter().map(told).collect()
    })
}

/// A claim of the author's that could not be proved; anything else is a fault of the tool.
fn unproved(module: &Module, error: &passes::Error) -> Diagnostic {
    let (span, help) = match error {
        passes::Error::Fallible { check, claim, .. } if *claim == passes::STAND_IN => (
            check.span,
            "rule the fault out: the firmware's function has no status that could tell of it",
        ),
        passes::Error::Fallible { check, .. } => (
            check.span,
            "rule the fault out (a constant index, a smaller type, a comparison before), or write `#[entry]`",
        ),
        passes::Error::Tool(_) => (Default::default(), OUR_FAULT),
    };
    Diagnostic { help: help.to_owned(), ..place(module, span, error) }
}

fn place(module: &Module, span: bessemer_ir::Span, message: &dyn std::fmt::Display) -> Diagnostic {
    Diagnostic {
        file: module.files.get(span.file as usize).cloned().unwrap_or_default(),
        line: span.line,
        column: span.column,
        message: message.to_string(),
        help: String::new(),
    }
}
