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
mod callee;
mod choice;
mod closure_args;
mod comparison;
mod conditions;
mod consumed;
mod context;
mod control;
mod described;
mod destructure;
mod each;
mod expand;
mod expr;
mod fields;
mod frames;
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
mod marks;
mod mentions;
mod names;
mod nested;
mod nothings;
mod numbered;
mod numbers;
mod option;
mod option_places;
mod order;
mod pair;
mod pattern;
mod place;
mod place_functions;
mod problem;
mod pulled;
mod ranges;
mod refusals;
mod rewrite;
mod scopes;
mod seq;
mod settled;
mod single_pass;
mod slice;
mod slots;
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

use bessemer_ir::Module;
use bessemer_ir::tree::{self, Package};

pub use context::Typed;
use context::{Calls, Context, Implied, Joined, Names, Types};
use problem::{Needed, Problem, Result, diagnostic, problem, refused, struct_of};

use crate::diagnostic::{Diagnostic, OUR_FAULT};
use crate::source::Sources;

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
fn typed_with<'a>(mut cx: Context<'a>, package: &'a Package) -> (Vec<Joined>, Outcome) {
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
            names: Names::of(package),
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
}
