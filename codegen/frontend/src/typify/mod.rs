//! Lowers the tree to the typed IR.
//!
//! It resolves names and scopes, and computes each type from the operands; the type must agree with rustc's type in
//! the slot. It selects the IR node of each operator and operation, and turns control flow with a value into
//! assignments.
//!
//! Must not know: C, or how an operation is computed. It does not infer: a type that does not follow from the
//! operands comes from a slot.

mod arrays;
mod atomic;
mod borrowed;
mod borrowed_slices;
mod bounded;
mod builtin;
mod by_hand;
mod call;
mod choice;
mod closure_args;
mod comparison;
mod conditions;
mod consumed;
mod control;
mod destructure;
mod each;
mod expand;
mod expr;
mod fields;
mod function;
mod gather;
mod generator;
mod generic;
mod held_slices;
mod implied;
mod items;
mod iterators;
mod kernels;
mod labelled;
mod lenders;
mod lengths;
mod literal;
mod loans;
mod locals;
mod loops;
mod lowering;
mod mentions;
mod names;
mod nested;
mod numbered;
mod numbers;
mod option;
mod option_places;
mod order;
mod pattern;
mod place;
mod place_functions;
mod pulled;
mod ranges;
mod refusals;
mod rewrite;
mod scopes;
mod seq;
mod settled;
mod single_pass;
mod slice;
mod spatial;
mod stepped;
mod subject;
mod submatrix;
mod syntax;
#[cfg(test)]
mod tests;
mod text;
mod typed;
mod types;
mod value;
mod words;
mod zero_sized;

use std::collections::{HashMap, HashSet};

use bessemer_ir::tree::{self, Package, Site};
use bessemer_ir::{FunctionId, Module, Span, StructId, Type};

use crate::diagnostic::{Diagnostic, OUR_FAULT};
use crate::source::Sources;

/// An error of the author: site, message and remedy.
struct Problem {
    site: Site,
    /// Message; empty if the error was reported elsewhere.
    message: String,
    help: String,
}

type Result<T, E = Problem> = std::result::Result<T, E>;

fn problem<T>(site: Site, message: impl Into<String>, help: impl Into<String>) -> Result<T> {
    Err(Problem { site, message: message.into(), help: help.into() })
}

/// Returns an error with a message of the table.
fn refused<T>(site: Site, (message, help): refusals::Reason) -> Result<T> {
    problem(site, message, help)
}

/// Conversion of an absent value to an error.
trait Needed<T>: Sized {
    fn or_told(self, site: Site, message: impl Into<String>, help: &str) -> Result<T>;

    /// Returns the value, or an error with a message of the table.
    fn or_refused(self, site: Site, (message, help): refusals::Reason) -> Result<T> {
        self.or_told(site, message, help)
    }

    /// Returns the value, or an internal error, since only a bug of the compiler can leave it absent.
    fn needed(self, site: Site, message: impl Into<String>) -> Result<T> {
        self.or_told(site, message, OUR_FAULT)
    }
}

impl<T> Needed<T> for Option<T> {
    fn or_told(self, site: Site, message: impl Into<String>, help: &str) -> Result<T> {
        self.map_or_else(|| problem(site, message, help), Ok)
    }
}

/// Returns the struct that a type must be.
fn struct_of(ty: &Type, site: Site, wanted: &str) -> Result<StructId> {
    match ty {
        Type::Struct(id) => Ok(*id),
        _ => problem(site, format!("this is not {wanted}"), OUR_FAULT),
    }
}

/// Counts of expressions whose types were computed and compared with rustc's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Typed {
    /// Number of expressions with a computed type.
    pub expressions: u32,
    /// Number of computed types that agree with rustc's slot.
    pub agreed: u32,
}

/// The typed module, or all errors.
pub type Outcome = Result<(Module, Typed), Vec<Diagnostic>>;

/// Lowers a package to a typed module, or returns all errors in it. With `by_columns`, matrices have the memory
/// layout of the kernels; else kernels receive copies.
pub fn typify(package: &Package, sources: &Sources, by_columns: bool) -> Outcome {
    // A function may show that two slices in a struct have one lender, of which those before it have to know.
    let mut joined = Vec::new();
    loop {
        let known = joined.len();
        let mut cx = Context { by_columns, ..Context::new(package, sources) };
        cx.types.joined = joined;
        let (joins, typed) = typed_with(cx, package);
        if joins.len() == known {
            return typed;
        }
        joined = joins;
    }
}

/// Returns the pairs of slices that have one lender, as far as they were found, and the typed module or all errors.
fn typed_with<'a>(mut cx: Context<'a>, package: &'a Package) -> (Vec<borrowed::Joined>, Outcome) {
    for definition in &package.types {
        if let Err(problem) = cx.define(definition) {
            cx.tell(&definition.file, problem);
            cx.types.undefined.insert(&definition.path);
        }
    }
    for (index, table) in package.tables.iter().enumerate() {
        if let Err(problem) = said_twice(table, &package.tables[..index]) {
            cx.told.push(diagnostic(&table.file, problem));
        }
    }
    let whole = |it: &&tree::Function| {
        it.tree.role != tree::Role::Rewritten && !function::takes_closures(it)
    };
    let functions: Vec<_> = package.functions.iter().filter(whole).collect();
    cx.note_implied(&package.implied);
    cx.note_lending(&functions);
    let in_the_c =
        |it: &&tree::Function| it.tree.role != tree::Role::Expanded && !cx.lends_place(it);
    let functions = functions.into_iter().filter(in_the_c).collect::<Vec<_>>();
    cx.calls.waiting = functions.iter().map(|it| (it.path.as_str(), *it)).collect();
    // Of other crates comes what is called, when it is called.
    for function in functions.into_iter().filter(|function| is_own(package, function)) {
        cx.function(&function.path);
    }
    if let Some(first) = package.functions.first()
        && let Err(problem) = cx.no_clash_left(first.tree.site)
    {
        cx.tell(&first.file, problem);
    }
    let mut errors = std::mem::take(&mut cx.told);
    errors.extend(ranges::wrong(&cx.module));
    errors.extend(crate::axes::wrong(&cx.module));
    // What contradicts itself may follow from what is refused.
    if errors.iter().any(|it| it.help != OUR_FAULT) {
        errors.retain(|it| it.help != OUR_FAULT);
    }
    errors.sort_by(|one, other| {
        (&one.file, one.line, one.column).cmp(&(&other.file, other.line, other.column))
    });
    cx.all_names();
    cx.constants_for_firmware();
    cx.names_to_numbers();
    let typed = if errors.is_empty() { Ok((cx.module, cx.typed)) } else { Err(errors) };
    (cx.types.joined, typed)
}

/// Refuses two constants with equal name, type and value but different C attributes, since the C has only one of
/// them.
fn said_twice(table: &tree::Table, before: &[tree::Table]) -> Result<()> {
    let same = |other: &&tree::Table| other.name == table.name && other.value == table.value;
    let unplaced = |given: &bessemer_ir::Given| (given.name.clone(), given.section.clone());
    match before.iter().find(same) {
        Some(other) if unplaced(&other.given) != unplaced(&table.given) => problem(
            table.site,
            format!("two constants `{}` have one value, but different C attributes", table.name),
            "use one constant for both, or rename one",
        ),
        _ => Ok(()),
    }
}

/// Returns true if a function belongs to the package: it is defined there, or its instance has a name there.
fn is_own(package: &Package, function: &tree::Function) -> bool {
    let own = package.name.replace('-', "_");
    let named = |owner: &String| package.aliases.iter().any(|alias| alias.of == *owner);
    function.module.split("::").next() == Some(own.as_str())
        || function.owner.as_ref().is_some_and(named)
}

fn diagnostic(file: &str, problem: Problem) -> Diagnostic {
    let Problem { site: Site(line, column), message, help } = problem;
    Diagnostic { file: file.to_owned(), line, column, message, help, ..Diagnostic::default() }
}

fn refusal(refusal: &tree::Refusal) -> Diagnostic {
    let (message, help) = (refusal.message.clone(), refusal.remedy.clone());
    diagnostic(&refusal.file, Problem { site: refusal.site, message, help })
}

/// Returns the names of items that are no instances, and of instances with an author's name.
fn authored(package: &Package) -> HashSet<String> {
    let name = |home: &str, name: &str| format!("{home}::{}", names::snake(name));
    let types = package.types.iter().filter(|it| it.arguments.is_empty());
    let functions = package.functions.iter().filter(|it| it.suffix.is_empty() && !it.inner);
    types
        .map(|it| name(&it.module, &it.name))
        .chain(package.aliases.iter().map(|it| name(&it.module, &it.name)))
        .chain(functions.map(|it| name(it.owner.as_deref().unwrap_or(&it.module), &it.tree.name)))
        .collect()
}

/// Returns a function's owner, name and suffix, which must be unique.
fn claim(function: &tree::Function) -> (Option<&str>, &str, &[tree::Argument]) {
    (function.owner.as_deref(), &function.tree.name, &function.suffix)
}

/// Facts about a type besides its definition.
#[derive(Default)]
struct Known<'a> {
    /// Location of an author's type, or of a type that contains one.
    home: Option<generic::Home>,
    /// Rust's name of the standard type that a struct represents.
    shown: Option<String>,
    /// Variants of a struct that represents an `Option`, a `Result` or an enum with payload.
    cases: Vec<generic::Case>,
    /// Error type of a struct that represents a `Result`.
    error: Option<tree::Ty>,
    /// Fields with their indices in the C, if some are zero-sized and have none.
    fields: Vec<(String, Option<usize>)>,
    /// rustc's types of the fields of a struct, or of an enum with payload.
    rustc: Vec<tree::Ty>,
    /// Generated function that compares two values part by part.
    equality: Option<FunctionId>,
    /// Path of the author's function for `==`.
    own_equality: Option<&'a str>,
    /// True if the type does not derive `PartialEq`.
    unequal: bool,
    /// True if the type derives `PartialOrd`.
    ordered: bool,
    /// True for `Reverse`, which orders greater values first.
    reversed: bool,
    /// True for a `BoundedMatrix`.
    bounded: bool,
    /// For a range: true if it includes its end.
    range: Option<bool>,
    /// For a quaternion: true if it is a unit quaternion.
    unit: Option<bool>,
}

/// The types so far.
#[derive(Default)]
struct Types<'a> {
    by_path: HashMap<String, Type>,
    /// Zero-sized types, which the C does not have.
    nothings: HashMap<String, zero_sized::Nothing>,
    /// True if the C omits a type or a field.
    leaves_out: bool,
    /// Authors' types with an error that was reported.
    undefined: HashSet<&'a str>,
    /// Structs that represent standard types.
    generics: HashMap<tree::Ty, Type>,
    /// Facts about each type; `unknown` serves all others.
    known: HashMap<Type, Known<'a>>,
    unknown: Known<'a>,
    /// Structs that represent slices in values.
    borrowed: HashMap<StructId, borrowed::Borrowed>,
    /// Pairs of slices in structs that have one lender.
    joined: Vec<borrowed::Joined>,
}

/// The functions that can be called.
#[derive(Default)]
struct Calls<'a> {
    /// Functions of the module, by path.
    lowered: HashMap<String, FunctionId>,
    /// All functions, by path.
    all: HashMap<&'a str, &'a tree::Function>,
    /// Functions that are lowered at their first use.
    waiting: HashMap<&'a str, &'a tree::Function>,
    /// Functions that are being lowered, each required by the one before.
    underway: Vec<&'a str>,
    /// For each function, true for the parameters that are zero-sized.
    absent: HashMap<FunctionId, Vec<bool>>,
    /// For each function, the lenders of the slices in its result, as places in its parameters.
    given_back: HashMap<FunctionId, Vec<(borrowed::Path, bessemer_ir::Place)>>,
    /// Paths of functions that return references and are inlined: a reference lowers to a place, never to a pointer.
    lending: HashSet<&'a str>,
    /// Callees without a name in the source.
    unnamed: Vec<tree::Callee>,
    /// The authors' `iter` methods.
    own_iterators: Vec<&'a tree::Function>,
}

/// The authors' implementations of std's traits.
#[derive(Default)]
struct Implied<'a> {
    /// Conversions between authors' types, and comparisons of two types.
    between: Vec<&'a tree::Implied>,
    /// Implementations of `Index`.
    indexing: Vec<(Type, &'a tree::Implied)>,
    /// Author-defined iterators, each with the callee number of its `next`.
    iterators: Vec<(Type, u32)>,
}

/// The module so far, and the meaning of its names.
struct Context<'a> {
    module: Module,
    typed: Typed,
    by_columns: bool,
    package: &'a Package,
    sources: &'a Sources,
    files: HashMap<String, u32>,
    /// Names that authors gave to generic instances, by path.
    aliases: HashMap<&'a str, &'a tree::Alias>,
    /// Names in snake case, below their module or type, that authors chose.
    authored: HashSet<String>,
    types: Types<'a>,
    /// Names, `&str`: their type, and pairs that the C could not distinguish.
    names: text::Names<'a>,
    calls: Calls<'a>,
    implied: Implied<'a>,
    /// Errors so far.
    told: Vec<Diagnostic>,
    /// True if the builder found an error.
    refused: bool,
}

impl<'a> Context<'a> {
    fn new(package: &'a Package, sources: &'a Sources) -> Context<'a> {
        let module = Module { name: package.name.clone(), ..Module::default() };
        Context {
            module,
            typed: Typed::default(),
            by_columns: true,
            package,
            sources,
            files: HashMap::new(),
            aliases: package.aliases.iter().map(|alias| (alias.of.as_str(), alias)).collect(),
            authored: authored(package),
            types: Types::default(),
            names: text::Names::of(package),
            calls: Calls {
                all: package.functions.iter().map(|it| (it.path.as_str(), it)).collect(),
                own_iterators: generator::own_iterators(package),
                ..Calls::default()
            },
            implied: Implied::default(),
            told: package.errors.iter().map(refusal).collect(),
            refused: !package.errors.is_empty(),
        }
    }

    /// Returns the facts about a type.
    fn known(&self, ty: &Type) -> &Known<'a> {
        self.types.known.get(ty).unwrap_or(&self.types.unknown)
    }

    /// Returns the facts about a struct.
    fn known_of(&self, id: StructId) -> &Known<'a> {
        self.known(&Type::Struct(id))
    }

    /// Returns the facts about a type, to add more.
    fn note(&mut self, ty: &Type) -> &mut Known<'a> {
        self.types.known.entry(ty.clone()).or_default()
    }

    /// Returns true if another function of the same owner has the same name.
    fn is_claimed_twice(&self, function: &tree::Function) -> bool {
        let all = self.package.functions.iter();
        all.filter(|other| claim(other) == claim(function)).nth(1).is_some()
    }

    fn span(&mut self, file: &str, Site(line, column): Site) -> Span {
        if let Some(&file) = self.files.get(file) {
            return Span { file, line, column };
        }
        let index = self.module.files.len() as u32;
        self.files.insert(file.to_owned(), index);
        self.module.files.push(file.to_owned());
        let about = self.sources.about(file);
        if !about.is_empty() {
            self.module.about.insert(file.to_owned(), about);
        }
        Span { file: index, line, column }
    }
}
