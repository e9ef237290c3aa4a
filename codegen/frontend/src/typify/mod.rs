//! From the tree to the typed IR.
//!
//! Resolves names and scopes, computes every type from the bottom up and holds it against the slot in
//! which rustc put its own; gives operators and the DSL's operations their IR nodes; turns control
//! flow that has a value into statements that assign it.
//!
//! Must not know: C, or how an operation is computed. It does not infer: a type that does not follow
//! from the operands comes from a slot.

mod arrays;
mod asked_orders;
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
mod gone_through;
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
mod loops;
mod lowering;
mod mentions;
mod names;
mod numbered;
mod numbers;
mod option;
mod option_places;
mod order;
mod pattern;
mod place;
mod place_functions;
mod ranges;
mod refusals;
mod rewrite;
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
mod types;
mod value;
mod words;
mod zero_sized;

use std::collections::{HashMap, HashSet};

use bessemer_ir::tree::{self, Package, Site};
use bessemer_ir::{FunctionId, Module, Span, StructId, Type};

use crate::diagnostic::{Diagnostic, OUR_FAULT};
use crate::source::Sources;

/// A mistake, its place, and the remedy.
struct Problem {
    site: Site,
    /// Empty where the problem has been told elsewhere.
    message: String,
    help: String,
}

type Result<T, E = Problem> = std::result::Result<T, E>;

fn problem<T>(site: Site, message: impl Into<String>, help: impl Into<String>) -> Result<T> {
    Err(Problem { site, message: message.into(), help: help.into() })
}

/// A problem with a message of the table.
fn refused<T>(site: Site, (message, help): refusals::Reason) -> Result<T> {
    problem(site, message, help)
}

/// Turns an absent value into a problem.
trait Needed<T>: Sized {
    fn or_told(self, site: Site, message: impl Into<String>, help: &str) -> Result<T>;

    /// With a message of the table.
    fn or_refused(self, site: Site, (message, help): refusals::Reason) -> Result<T> {
        self.or_told(site, message, help)
    }

    /// Where only a fault of the compiler can leave it absent.
    fn needed(self, site: Site, message: impl Into<String>) -> Result<T> {
        self.or_told(site, message, OUR_FAULT)
    }
}

impl<T> Needed<T> for Option<T> {
    fn or_told(self, site: Site, message: impl Into<String>, help: &str) -> Result<T> {
        self.map_or_else(|| problem(site, message, help), Ok)
    }
}

/// The struct that a type is, where it has to be one.
fn struct_of(ty: &Type, site: Site, wanted: &str) -> Result<StructId> {
    match ty {
        Type::Struct(id) => Ok(*id),
        _ => problem(site, format!("this is not {wanted}"), OUR_FAULT),
    }
}

/// How the types were found: from the bottom up, and held against what rustc put in the slots.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Typed {
    /// Expressions whose type was computed.
    pub expressions: u32,
    /// Those that rustc was asked about, and agreed.
    pub agreed: u32,
}

/// The typed module, or everything that is wrong.
pub type Outcome = Result<(Module, Typed), Vec<Diagnostic>>;

/// The typed module of a package, or everything that is wrong with it. `by_columns`: matrices lie in memory as
/// kernels take them; else kernels are lent copies.
pub fn typify(package: &Package, sources: &Sources, by_columns: bool) -> Outcome {
    // A function may show that two slices in a struct have one lender, of which those before it have to know.
    let mut joined = Vec::new();
    loop {
        let known = joined.len();
        let cx = Context { by_columns, joined, ..Context::new(package, sources) };
        let (joins, typed) = typed_with(cx, package);
        if joins.len() == known {
            return typed;
        }
        joined = joins;
    }
}

/// What of its structs has one lender, as far as it shows; the typed module, or everything that is wrong.
fn typed_with<'a>(mut cx: Context<'a>, package: &'a Package) -> (Vec<borrowed::Joined>, Outcome) {
    for definition in &package.types {
        if let Err(problem) = cx.define(definition) {
            cx.tell(&definition.file, problem);
            cx.undefined.insert(&definition.path);
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
    cx.waiting = functions.iter().map(|it| (it.path.as_str(), *it)).collect();
    // Of other crates comes what is called, when it is called.
    for function in functions.into_iter().filter(|function| is_own(package, function)) {
        cx.function(&function.path);
    }
    let mut errors = std::mem::take(&mut cx.told);
    errors.extend(ranges::wrong(&cx.module));
    // What contradicts itself may follow from what is refused.
    if errors.iter().any(|it| it.help != OUR_FAULT) {
        errors.retain(|it| it.help != OUR_FAULT);
    }
    errors.sort_by(|one, other| {
        (&one.file, one.line, one.column).cmp(&(&other.file, other.line, other.column))
    });
    let typed = if errors.is_empty() { Ok((cx.module, cx.typed)) } else { Err(errors) };
    (cx.joined, typed)
}

/// A constant is told by its name, its type and its value: of two that agree in these the same must be said.
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

/// Whether a function is the package's own: it stands there, or its instance is named there.
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

/// The names of what is not an instance, and of instances that have one.
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

/// The name that a method would have, in its owner.
fn claim(function: &tree::Function) -> (Option<&str>, &str, &[tree::Argument]) {
    (function.owner.as_deref(), &function.tree.name, &function.suffix)
}

/// What is known of a type beside its definition.
#[derive(Default)]
struct Known<'a> {
    /// Of an author's, and of what is made of these: where it stands.
    home: Option<generic::Home>,
    /// Of a struct that stands for a type of Rust's own: that one.
    shown: Option<String>,
    /// The variants of a struct that stands for an `Option`, a `Result` or an enum with payload.
    cases: Vec<generic::Case>,
    /// The error of one that stands for a `Result`.
    error: Option<tree::Ty>,
    /// The author's fields, if some hold nothing, and where the others are.
    fields: Vec<(String, Option<usize>)>,
    /// The types of the fields of a struct, or of an enum with payload, as rustc sees them.
    rustc: Vec<tree::Ty>,
    /// The function that compares two values part by part.
    equality: Option<FunctionId>,
    /// The function that its author wrote for `==`.
    own_equality: Option<&'a str>,
    /// It does not derive `PartialEq`.
    unequal: bool,
    /// It derives `PartialOrd`.
    ordered: bool,
    /// The greater comes first.
    reversed: bool,
    /// It is a `BoundedMatrix`.
    bounded: bool,
    /// It is a range; whether its end is in it.
    range: Option<bool>,
    /// Of what stands for a quaternion: whether that is a unit one.
    unit: Option<bool>,
}

/// The module so far, and what its names mean.
struct Context<'a> {
    module: Module,
    typed: Typed,
    by_columns: bool,
    package: &'a Package,
    sources: &'a Sources,
    files: HashMap<String, u32>,
    types: HashMap<String, Type>,
    /// Zero-sized types, which are not in the C.
    nothings: HashMap<String, zero_sized::Nothing>,
    /// Whether the C leaves out a type or a field.
    leaves_out: bool,
    /// The authors' types with which something is wrong, which has been told.
    undefined: HashSet<&'a str>,
    /// The names of instances, by their paths.
    aliases: HashMap<&'a str, &'a tree::Alias>,
    /// The names that authors gave, in snake case behind their module or type.
    authored: HashSet<String>,
    /// The structs that stand for types of Rust's own.
    generics: HashMap<tree::Ty, Type>,
    /// What is known of each type, and of one of which nothing is.
    known: HashMap<Type, Known<'a>>,
    unknown: Known<'a>,
    /// The conversions between authors' types.
    conversions: Vec<&'a tree::Implied>,
    /// The structs that stand for slices in values.
    borrowed: HashMap<StructId, borrowed::Borrowed>,
    /// The slices in structs that have one lender.
    joined: Vec<borrowed::Joined>,
    /// Which parameters of functions hold nothing.
    absent: HashMap<FunctionId, Vec<bool>>,
    /// What functions give slices of: places in their parameters.
    given_back: HashMap<FunctionId, Vec<(borrowed::Path, bessemer_ir::Place)>>,
    functions: HashMap<String, FunctionId>,
    /// All functions, by their paths.
    all: HashMap<&'a str, &'a tree::Function>,
    /// The authors' own `iter`s.
    own_iterators: Vec<&'a tree::Function>,
    /// Those that return references and are inlined: a reference lowers to a place, never to a pointer.
    lending: HashSet<&'a str>,
    /// The authors' own `[…]`.
    indexing: Vec<(Type, &'a tree::Implied)>,
    /// The authors' own iterators, each with its `next`, by the number of the callee.
    iterators: Vec<(Type, u32)>,
    /// The functions that no author names.
    unnamed: Vec<tree::Callee>,
    /// Functions that are still to be made.
    waiting: HashMap<&'a str, &'a tree::Function>,
    /// Functions that are being made, each for the one before.
    underway: Vec<&'a str>,
    /// The mistakes so far.
    told: Vec<Diagnostic>,
    /// Whether the builder found something wrong.
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
            types: HashMap::new(),
            nothings: HashMap::new(),
            leaves_out: false,
            undefined: HashSet::new(),
            aliases: package.aliases.iter().map(|alias| (alias.of.as_str(), alias)).collect(),
            authored: authored(package),
            generics: HashMap::new(),
            known: HashMap::new(),
            unknown: Known::default(),
            conversions: Vec::new(),
            borrowed: HashMap::new(),
            joined: Vec::new(),
            absent: HashMap::new(),
            given_back: HashMap::new(),
            functions: HashMap::new(),
            all: package.functions.iter().map(|it| (it.path.as_str(), it)).collect(),
            own_iterators: generator::own_iterators(package),
            lending: HashSet::new(),
            indexing: Vec::new(),
            iterators: Vec::new(),
            unnamed: Vec::new(),
            waiting: HashMap::new(),
            underway: Vec::new(),
            told: package.errors.iter().map(refusal).collect(),
            refused: !package.errors.is_empty(),
        }
    }

    /// What is known of a type.
    fn known(&self, ty: &Type) -> &Known<'a> {
        self.known.get(ty).unwrap_or(&self.unknown)
    }

    /// The same of a struct.
    fn known_of(&self, id: StructId) -> &Known<'a> {
        self.known(&Type::Struct(id))
    }

    /// The same, to note more.
    fn note(&mut self, ty: &Type) -> &mut Known<'a> {
        self.known.entry(ty.clone()).or_default()
    }

    /// Whether another function of its owner wants its name, too.
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
