//! Compiles a package: tree, typed IR, explicit IR, C.
//!
//! Validation runs before and after the passes; every later stage may rely on it.

use std::collections::BTreeSet;

use bessemer_ir::tree::Package;
use bessemer_ir::visit::Walk;
use bessemer_ir::{ExprKind, Fault, Module, Span, Type};

use crate::deep::deep;
use bessemer_backend::c::given::{Conflict, Taken};
use bessemer_backend::c::interface::Interface;
use bessemer_backend::c::{self, CFile, EntryReport, FunctionReport, Site, Width};
use bessemer_backend::kernels::replace::Replacement;
use bessemer_backend::{kernels, passes, validate};
use bessemer_frontend::diagnostic::{Diagnostic, OUR_FAULT, Place};
use bessemer_frontend::source::Sources;
use bessemer_frontend::typify;

pub use bessemer_backend::c::{Layout, Math, Options, Standard};
pub use bessemer_frontend::typify::Typed;

/// A compiled package: IR, C, and reports.
pub struct Compiled {
    /// SPDX licence expression for the head of each file.
    pub license: String,
    /// Typed IR of the author's program, which the interpreter runs.
    pub module: Module,
    /// Explicit IR from which the C is printed: with checks, simple statements, and large temporaries in the caller's
    /// memory.
    pub explicit: Module,
    /// Number of computed types, and of those that were compared with rustc's.
    pub typed: Typed,
    /// Emitted files.
    pub files: Vec<CFile>,
    /// Interface of the C: types and entry points as data.
    pub interface: Interface,
    /// Entry points with their costs.
    pub entries: Vec<EntryReport>,
    /// Stack of each function.
    pub functions: Vec<FunctionReport>,
    /// Remaining checks of each function, with reasons.
    pub checks: passes::Report,
    /// Kernels that the user's functions replace, with the library of each.
    pub replaced: Vec<(String, String)>,
    /// Kernels in the fast mode, whose bits may differ from Rust's, with their error bounds.
    pub fast: Vec<(String, String)>,
    /// Functions of the target's `math.h` that the C calls, so that its bits may differ from Rust's.
    pub library: Vec<String>,
    /// Texts of the names, `&str`, whose words are in it.
    pub names: Vec<String>,
}

/// Compiles a package.
///
/// # Errors
///
/// All errors in it, at the author's lines.
pub fn compile(
    package: &Package,
    sources: &Sources,
    options: &Options,
) -> Result<Compiled, Vec<Diagnostic>> {
    let compiled = deep(|| {
        let typed = typify::typify(package, sources, options.layout == Layout::Columns)?;
        gate(&typed.0)?;
        let names = package.names.iter().map(|(_, text)| text.clone()).collect();
        of_module(typed, Some(sources), (&package.license, names), options)
    });
    compiled.map_err(|errors| errors.into_iter().map(|it| by_deref(package, it)).collect())
}

/// Rewords an error about the types of an expression, if one of the author's types implements `Deref`: rustc follows it
/// where the tree shows nothing.
fn by_deref(package: &Package, error: Diagnostic) -> Diagnostic {
    let is_of_types =
        error.help == OUR_FAULT || error.message.ends_with("is not a supported field");
    if package.derefs.is_empty() || !is_of_types {
        return error;
    }
    let names: Vec<String> = package.derefs.iter().map(|name| format!("`{name}`")).collect();
    Diagnostic {
        message: format!("this uses the `Deref` of {}, which hides the access that C has to name", names.join(" or ")),
        help: "name the field, `outer.inner.x`, or call a method that returns the reference, `fn inner(&self) -> &Inner`".to_owned(),
        ..error
    }
}

impl Compiled {
    /// Compiles the same IR with other options; the layout of matrices cannot change, since types depend on it.
    ///
    /// # Errors
    ///
    /// All errors in it, at the author's lines.
    pub fn anew(&self, options: &Options) -> Result<Compiled, Vec<Diagnostic>> {
        let said = (self.license.as_str(), self.names.clone());
        deep(|| of_module((self.module.clone(), self.typed), None, said, options))
    }
}

fn of_module(
    (module, typed): (Module, Typed),
    sources: Option<&Sources>,
    (license, names): (&str, Vec<String>),
    options: &Options,
) -> Result<Compiled, Vec<Diagnostic>> {
    let options = &Options { license: license.to_owned(), ..options.clone() };
    let choices = passes::Choices { keep: options.keep_checks, tiles: options.kernels.tiles() };
    let (explicit, checks) = passes::explicit_with(module.clone(), choices).map_err(|errors| {
        errors.iter().map(|error| unproved(&module, error)).collect::<Vec<_>>()
    })?;
    let explicit = passes::lend(explicit, &options.kernels, options.layout != Layout::Array);
    gate(&explicit)?;
    let plan = c::Plan::new(&explicit, options);
    let taken: Vec<_> =
        plan.conflicts().iter().map(|it| conflicting(&module, sources, it)).collect();
    if !taken.is_empty() {
        return Err(taken);
    }
    let files = plan.emit();
    let interface = plan.interface();
    let (entries, functions) = plan.report(&files);
    let too_wide: Vec<_> = entries.iter().flat_map(|entry| too_wide(&explicit, entry)).collect();
    // Kept checks compute where the author's code does not.
    if !too_wide.is_empty() && !options.keep_checks {
        return Err(too_wide);
    }
    let replaced = replaced(&explicit, options);
    let fast = fast(&explicit, options);
    let library = plan.library_calls();
    Ok(Compiled {
        license: license.to_owned(),
        module,
        explicit,
        typed,
        files,
        interface,
        entries,
        functions,
        checks,
        replaced,
        fast,
        library,
        names,
    })
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

/// Validates a module. An error is a bug of the compiler, except too deep a nesting: the front end has reported all
/// others.
fn gate(module: &Module) -> Result<(), Vec<Diagnostic>> {
    validate::validate(module).map_err(|errors| {
        let help = |problem: &validate::Problem| match problem {
            validate::Problem::NestedTooDeep => "give parts of it names, or functions of their own",
            _ => OUR_FAULT,
        };
        let reported = |error: &validate::Error| Diagnostic {
            help: help(&error.problem).to_owned(),
            ..place(module, error.span, &error.problem)
        };
        errors.iter().map(reported).collect()
    })
}

/// Returns the diagnostic of an author's declaration that was not proved; any other error is a bug of the compiler.
fn unproved(module: &Module, error: &passes::Error) -> Diagnostic {
    let passes::Error::Fallible { entry, claim, function, fault, check } = error else {
        return Diagnostic {
            help: OUR_FAULT.to_owned(),
            ..place(module, Default::default(), error)
        };
    };
    let within = if entry == function { String::new() } else { format!("in `{function}`, ") };
    let reason = match fault {
        Fault::Index => format!("an index may be out of bounds ({})", check.reason),
        Fault::Shift => format!("a shift may be as wide as its type ({})", check.reason),
        _ => check.reason.clone(),
    };
    let message = format!("`{entry}` {claim}: {within}{reason}");
    let help = match *claim == passes::STAND_IN {
        true => "rule the fault out: the firmware's function has no status that could tell of it"
            .to_owned(),
        false => format!(
            "{}; or write `#[entry]`, which returns a status",
            ruled_out(*fault, &check.reason)
        ),
    };
    let at = module.functions.iter().position(|it| it.name == *entry);
    let span = at.map_or(check.span, |at| authors(module, at, check.span));
    Diagnostic { help, ..place(module, span, &message) }
}

/// Returns the place of a fault that an entry point reaches. A fault in a function of the DSL has the place of the author's
/// call that leads there.
pub fn authors(module: &Module, entry: usize, span: Span) -> Span {
    let is_ours = |index: usize| module.functions[index].module.split("::").next() == Some(DSL);
    let holds = |index: usize| {
        let of = module.functions[index].span;
        is_ours(index) && of.file == span.file
    };
    if !(0..module.functions.len()).any(holds) {
        return span;
    }
    // The calls of each function, in order; those of the DSL's functions have the place of the author's.
    let mut waiting = vec![(entry, None)];
    let mut seen = BTreeSet::from([entry]);
    let mut next = 0;
    while let Some(&(index, call)) = waiting.get(next) {
        next += 1;
        if let Some(call) = call.filter(|_| holds(index)) {
            return call;
        }
        module.functions[index].body.each_expr(|expr| {
            if let ExprKind::Call(callee, _) = &expr.kind
                && seen.insert(callee.index())
            {
                let through = call.filter(|_| is_ours(index)).unwrap_or(expr.span);
                waiting.push((callee.index(), Some(through)));
            }
        });
    }
    span
}

/// Name of the DSL's crate.
const DSL: &str = "bessemer";

/// Returns a diagnostic for each operation in double or 64 bits that an entry point of `#[entry(single)]` reaches.
fn too_wide(module: &Module, entry: &EntryReport) -> Vec<Diagnostic> {
    let function = &module.functions[entry.function.index()];
    if !function.attributes.single {
        return Vec::new();
    }
    let reported = |site: &Site| {
        let callee = site.through.map(|id| &module.functions[id.index()]);
        let what = match (site.width, callee) {
            (Width::Double, None) => "this is computed in double".to_owned(),
            (Width::Double, Some(callee)) => format!("`{}` computes in double", callee.name),
            (Width::Long, None) => "this is computed in 64 bits".to_owned(),
            (Width::Long, Some(callee)) => format!("`{}` computes in 64 bits", callee.name),
        };
        let message = format!("`{}` is not single: {what}", function.name);
        let of_f32 = callee.is_some_and(|callee| {
            let own = callee.module.starts_with("bessemer::math");
            own && callee.parameters().iter().all(|it| it.ty != Type::F64)
        });
        let help = match site.width {
            _ if of_f32 => {
                "enable the `f32` form of this function in Cargo.toml: `bessemer = { …, features = [\"single\"] }`"
            }
            Width::Double => {
                "compute in `f32`: declare inputs, constants and literals of that type"
            }
            Width::Long => "compute in `u32` or `i32`, and index with `as usize`",
        };
        Diagnostic { help: help.to_owned(), ..place(module, site.span, &message) }
    };
    // A line is reported once.
    let mut sites: Vec<&Site> = entry.wide.iter().collect();
    sites.dedup_by_key(|site| (site.span.file, site.span.line));
    sites.into_iter().map(reported).collect()
}

/// Returns a remedy that prevents a fault.
fn ruled_out(fault: Fault, reason: &str) -> String {
    let operations = [(" + ", "add"), (" - ", "sub"), (" * ", "mul")];
    let operation = operations.iter().find(|(sign, _)| reason.contains(sign));
    match (fault, operation) {
        (Fault::Overflow, Some((_, name))) => format!(
            "write `saturating_{name}`, which stops at the limit, or `wrapping_{name}`, which wraps around; or compare before"
        ),
        (Fault::Overflow, None) => {
            "compare with the limits before, or compute in a wider type".to_owned()
        }
        (Fault::DivisionByZero, _) => {
            "compare before: `if n != 0 { sum / n } else { 0 }`".to_owned()
        }
        (Fault::Shift, _) => "mask the shift count: `1 << (bit & 31)`".to_owned(),
        (Fault::Index, _) => {
            "compare before: `if i < values.len() { values[i] } else { 0.0 }`".to_owned()
        }
        (Fault::Absent, _) => {
            "write a fallback: `.unwrap_or(0.0)`, `if let Some(x) = …`".to_owned()
        }
        (Fault::Clamp, _) => {
            "write `x.max(low).min(high)`, whose bounds may be in any order; or compare before: `if low <= high { x.clamp(low, high) } else { low }`".to_owned()
        }
        (Fault::Assertion, _) => {
            "return before where the condition does not hold: `if !(x >= 0.0) { return 0.0; }`".to_owned()
        }
        _ => "exclude the fault by a comparison before".to_owned(),
    }
}

fn place(module: &Module, span: bessemer_ir::Span, message: &dyn std::fmt::Display) -> Diagnostic {
    Diagnostic {
        file: file_of(module, span),
        line: span.line,
        column: span.column,
        message: message.to_string(),
        ..Diagnostic::default()
    }
}

/// Returns the source file of a span.
/// Returns the error for a conflict of names, at each of its places.
fn conflicting(module: &Module, sources: Option<&Sources>, it: &Conflict) -> Diagnostic {
    let is_made = matches!(it.taken, Taken::Made(_));
    let file = file_of(module, it.span);
    let mut fields =
        it.fields.iter().filter_map(|field| sources?.field(&file, it.span.line, field));
    let mut reported = place(module, it.span, &it.taken);
    if let (Some((line, column)), true) = (fields.next(), is_made) {
        (reported.line, reported.column) = (line, column);
    }
    let also =
        |file, start| Place { file, start, label: "also here".to_owned(), ..Place::default() };
    let others =
        it.others.iter().map(|span| also(file_of(module, *span), (span.line, span.column)));
    reported.also = others.chain(fields.map(|start| also(file.clone(), start))).collect();
    let help = match is_made {
        true => "name one of them otherwise in the C: `#[c(name = \"…\")]`",
        false => "give it another name, or leave the name to Bessemer",
    };
    Diagnostic { help: help.to_owned(), ..reported }
}

fn file_of(module: &Module, span: Span) -> String {
    module.files.get(span.file as usize).cloned().unwrap_or_default()
}
